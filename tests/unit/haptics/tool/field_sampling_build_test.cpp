#include "haptics/geometry/shape.h"
#include "haptics/tool/field_sampling.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;

TEST_CASE("field sampling build: settings out of range and missing parts are refused") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(validate(FieldSamplingSettings{}));
    CHECK(validate(FieldSamplingSettings{.budget_us = 100.0}));
    CHECK_FALSE(validate(FieldSamplingSettings{.stiffness_N_per_m = -1.0}));
    CHECK_FALSE(validate(FieldSamplingSettings{.stiffness_N_per_m = nan}));
    CHECK_FALSE(validate(FieldSamplingSettings{.budget_us = 1.0}));
    CHECK_FALSE(validate(FieldSamplingSettings{.budget_us = nan}));
    CHECK_FALSE(validate(FieldSamplingSettings{.leaf_us = 0.0}));
    CHECK_FALSE(validate(FieldSamplingSettings{.group_us = 0.0}));
    CHECK_FALSE(
        validate(FieldSamplingSettings{.mode = SamplingMode::brute_force, .budget_us = 100.0}));
    CHECK_FALSE(validate(FieldSamplingSettings{.mode = SamplingMode::tree, .budget_us = 100.0}));

    const TriangleMesh mesh = *make_sphere(1.0, 4);
    const auto field = std::make_shared<const DistanceField>(
        DistanceField::build(mesh, DistanceField::make_frame(mesh, 32).value()).value());
    const auto shell = std::make_shared<const ShellTree>(
        ShellTree::build(make_surface_pointshell(mesh, 50).value()).value());
    CHECK_FALSE(FieldSampler::build(nullptr, shell));
    CHECK_FALSE(FieldSampler::build(field, nullptr));
    CHECK_FALSE(FieldSampler::build(field, shell, {.leaf_us = -1.0}));
    const auto sampler = FieldSampler::build(field, shell);
    REQUIRE(sampler);
    CHECK(sampler->memory_bytes() > 0);
}
