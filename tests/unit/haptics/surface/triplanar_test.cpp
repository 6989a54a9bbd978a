#include "haptics/surface/triplanar.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <rapidcheck.h>

using namespace fulcrum;

namespace {

Texture make_bumps(TextureLaw law) {
    TextureSettings settings;
    settings.source = NoiseTexture{0.002, 0.004, 2};
    settings.law = law;
    settings.height_m = 3.0e-4;
    return Texture(settings);
}

Vector3 any_unit() {
    for (;;) {
        const auto any = [] { return 0.01 * *rc::gen::inRange(-100, 101); };
        const Vector3 v(any(), any(), any());
        if (v.norm() > 0.1) {
            return v.normalized();
        }
    }
}

}  // namespace

TEST_CASE("triplanar: a face along an axis has one view, u and v as told") {
    const Vector3 p(0.01, 0.02, 0.03);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            const Vector3 normal = sign * Vector3::Unit(static_cast<Index>(axis));
            const Vector3 weights = compute_view_weights(normal);
            CHECK(weights == Vector3::Unit(static_cast<Index>(axis)));
        }
    }
    CHECK(project_on_view(0, p).u_m == 0.03);
    CHECK(project_on_view(0, p).v_m == 0.02);
    CHECK(project_on_view(1, p).u_m == 0.01);
    CHECK(project_on_view(1, p).v_m == 0.03);
    CHECK(project_on_view(2, p).u_m == 0.01);
    CHECK(project_on_view(2, p).v_m == 0.02);
}

TEST_CASE("triplanar: weights add up to one and turn without a step") {
    CHECK(rc::check("for any normal", [] {
        const Vector3 normal = any_unit();
        const Vector3 weights = compute_view_weights(normal);
        RC_ASSERT(std::abs(weights.sum() - 1.0) < 1.0e-12);
        RC_ASSERT(weights.minCoeff() >= 0.0);
        const Vector3 beside = (normal + 1.0e-6 * any_unit()).normalized();
        RC_ASSERT((compute_view_weights(beside) - weights).cwiseAbs().maxCoeff() < 1.0e-4);
    }));
}

TEST_CASE("triplanar: what is felt of a slope lies along the surface; a normal part is kept") {
    static const Texture lateral = make_bumps(TextureLaw::lateral);
    static const Texture carved = make_bumps(TextureLaw::height_offset);
    CHECK(rc::check("for any normal", [] {
        const Vector3 normal = any_unit();
        const Vector3 place = 0.01 * any_unit();
        const BodyOffset felt = feel_on_body(lateral, place, 1.0e-4 * any_unit(), normal, 0.002);
        RC_ASSERT(std::abs(felt.offset_B_m.dot(normal)) < 1.0e-15);
        const BodyOffset cut = feel_on_body(carved, place, Vector3::Zero(), normal, 0.002);
        RC_ASSERT(cut.offset_B_m.dot(normal) <= 1.0e-15);
        // Between its samples a relief may reach a little over its peak.
        RC_ASSERT(std::abs(-cut.offset_B_m.dot(normal) - (3.0e-4 - cut.height_m)) < 3.0e-6);
    }));
}

TEST_CASE("triplanar: on a floor it is the texture itself") {
    const Texture texture = make_bumps(TextureLaw::perturbed_normal);
    const Vector3 place(0.0013, 0.5, -0.0021);
    const Vector3 stroke(3.0e-4, 0.0, 1.0e-4);
    const BodyOffset felt = feel_on_body(texture, place, stroke, Vector3::UnitY(), 0.001);
    const TextureOffset flat = texture.feel({0.0013, -0.0021}, {3.0e-4, 1.0e-4}, 0.001);
    CHECK(felt.offset_B_m.x() == flat.along.u_m);
    CHECK(felt.offset_B_m.z() == flat.along.v_m);
    CHECK(felt.offset_B_m.y() == Approx(flat.normal_m).margin(1.0e-18));
    CHECK(felt.place.u_m == 0.0013);
    CHECK(felt.place.v_m == -0.0021);
    CHECK(felt.height_m == flat.height_m);
}
