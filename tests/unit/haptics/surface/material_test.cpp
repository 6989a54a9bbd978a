#include "haptics/surface/material.h"

#include "haptics/point/solid_plan.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;

namespace {

Material make_good() {
    Material material;
    material.name = "cork";
    material.friction = {0.5, 0.4, 0.0};
    material.texture.source = SineTexture{};
    material.texture.law = TextureLaw::lateral;
    material.transient.kind = TransientKind::decaying_sinusoid;
    material.coupling.stiffness_N_per_m = 321.0;
    return material;
}

}  // namespace

TEST_CASE("material: every part is checked, and the sentence names the material") {
    CHECK(validate(make_good()));
    Material nameless = make_good();
    nameless.name.clear();
    CHECK_FALSE(validate(nameless));
    const auto refused = [](auto spoil) {
        Material material = make_good();
        spoil(material);
        const auto valid = validate(material);
        return !valid && to_sentence(valid.error()).find("cork: ") == 0;
    };
    CHECK(refused([](Material& m) { m.coupling.stiffness_N_per_m = -1.0; }));
    CHECK(refused([](Material& m) { m.friction.dynamic_coefficient = -1.0; }));
    CHECK(refused([](Material& m) { m.texture.height_m = 1.0; }));
    CHECK(refused([](Material& m) { m.transient.decay_per_s = 0.0; }));
}

TEST_CASE("material: a body made of it has its numbers, and keeps its shading and its sound") {
    SolidPlan solid;
    solid.surface.shading = {true, 12.0};
    solid.surface.audible = true;
    put_material(make_good(), solid);
    REQUIRE(solid.coupling);
    CHECK(solid.coupling->stiffness_N_per_m == 321.0);
    CHECK(solid.friction.static_coefficient == 0.5);
    CHECK(std::holds_alternative<SineTexture>(solid.surface.texture.source));
    CHECK(solid.surface.transient.kind == TransientKind::decaying_sinusoid);
    CHECK(solid.surface.shading.on);
    CHECK(solid.surface.shading.crease_angle_deg == 12.0);
    CHECK(solid.surface.audible);
}

TEST_CASE("material: a grade is even in the logarithm") {
    const GradeScale scale{10.0, 1000.0};
    CHECK(compute_grade(10.0, scale) == 0.0);
    CHECK(compute_grade(100.0, scale) == Approx(0.5));
    CHECK(compute_grade(1000.0, scale) == Approx(1.0));
    CHECK(compute_grade(1.0e9, scale) == 1.0);
    for (const double none : {0.0, -1.0, 9.0, std::nan("")}) {
        CHECK(compute_grade(none, scale) == 0.0);
    }
}

TEST_CASE("material: what it is like follows from its numbers alone") {
    const Material base = make_good();
    const MaterialFacts facts = describe(base);
    // Grooves of 2 mm, 0.1 mm deep.
    CHECK(facts.rms_height_m == Approx(0.5e-4 / std::sqrt(2.0)).epsilon(0.001));
    CHECK(facts.stiffness_N_per_m == 321.0);
    CHECK(facts.ringing_Hz == 100.0);
    CHECK(facts.dynamic_coefficient == 0.4);
    const auto changed = [&base](auto change) {
        Material other = base;
        change(other);
        return describe(other);
    };
    CHECK(changed([](Material& m) { m.coupling.stiffness_N_per_m *= 2.0; }).hardness >
          facts.hardness);
    CHECK(changed([](Material& m) { m.transient.frequency_Hz /= 2.0; }).hardness < facts.hardness);
    CHECK(changed([](Material& m) { m.transient.kind = TransientKind::none; }).hardness ==
          compute_grade(321.0, kStiffnessScale));
    CHECK(changed([](Material& m) { m.texture.height_m *= 2.0; }).roughness > facts.roughness);
    CHECK(changed([](Material& m) {
              m.texture.source = SineTexture{0.02, 0.0};
          }).roughness < facts.roughness);
    CHECK(changed([](Material& m) { m.texture.source = {}; }).roughness == 0.0);
    CHECK(changed([](Material& m) { m.friction.dynamic_coefficient /= 2.0; }).slipperiness >
          facts.slipperiness);
    CHECK(changed([](Material& m) { m.name = "butter"; }).hardness == facts.hardness);
}
