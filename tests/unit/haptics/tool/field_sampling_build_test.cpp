#include "haptics/tool/field_sampling.h"
#include "tests/support/field_parts.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;

TEST_CASE("field sampling build: settings out of range and missing parts are refused") {
    test::check_refused(
        FieldSamplingSettings{.budget_us = 100.0},
        {[](auto& s) { s.stiffness_N_per_m = -1.0; },
         [](auto& s) { s.stiffness_N_per_m = std::nan(""); }, [](auto& s) { s.budget_us = 1.0; },
         [](auto& s) { s.budget_us = std::nan(""); }, [](auto& s) { s.leaf_us = 0.0; },
         [](auto& s) { s.group_us = 0.0; }, [](auto& s) { s.mode = SamplingMode::brute_force; },
         [](auto& s) { s.mode = SamplingMode::tree; }});
    CHECK(validate(FieldSamplingSettings{}));
    const TriangleMesh mesh = *make_sphere(1.0, 4);
    const auto field = test::make_field(mesh, 32);
    const auto shell = test::make_shell(mesh, 50);
    CHECK_FALSE(FieldSampler::build(nullptr, shell));
    CHECK_FALSE(FieldSampler::build(field, nullptr));
    CHECK_FALSE(FieldSampler::build(field, shell, {.leaf_us = -1.0}));
    const auto sampler = FieldSampler::build(field, shell);
    REQUIRE(sampler);
    CHECK(sampler->memory_bytes() > 0);
}
