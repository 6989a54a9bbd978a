#include "haptics/surface/material.h"

#include "haptics/point/solid_plan.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

Material make_good() {
    Material material;
    material.name = "cork";
    material.friction = {0.5, 0.4, 0.0};
    material.texture.source = SineTexture{};
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
