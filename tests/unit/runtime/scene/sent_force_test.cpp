// What reaches a hand that strokes a solid, with the plan, the damper, the passivity stage and the gate that a lesson gets.
#include "haptics/geometry/shape.h"
#include "haptics/math/length.h"
#include "haptics/surface/materials.h"
#include "tests/support/sent_stroke.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace fulcrum;
using test::bare;
using test::Place;
using test::SentForce;
using test::SentStroke;
using test::stroke;
using test::Way;

namespace {

Place on_sphere(double way_m) {
    constexpr double kRadius_m = 0.1;
    static const Vector3 kAlong = Vector3(0.8, 0.1, -0.59).normalized();
    static const Vector3 kAcross = kAlong.cross(Vector3(0.2, 1.0, 0.4)).normalized();
    const double angle = way_m / kRadius_m;
    const Vector3 n = std::cos(angle) * kAlong + std::sin(angle) * kAcross;
    return {kRadius_m * n, n};
}

// Round the tube and round the ring at once: convex outside, a saddle within.
constexpr double kRing_m = 0.06;
constexpr double kTube_m = 0.03;
Place on_torus(double way_m) {
    const double round = way_m / kTube_m;
    const double about = 0.37 * round + 0.2;
    const Vector3 out(std::cos(about), 0.0, std::sin(about));
    const Vector3 n = std::cos(round) * out + std::sin(round) * Vector3::UnitY();
    return {kRing_m * out + kTube_m * n, n};
}

// Along the ring on its inner side, which is hollow that way.
Place in_hollow(double way_m) {
    constexpr double kRound = 2.9;
    const double about = way_m / (kRing_m + kTube_m * std::cos(kRound)) + 0.2;
    const Vector3 out(std::cos(about), 0.0, std::sin(about));
    const Vector3 n = std::cos(kRound) * out + std::sin(kRound) * Vector3::UnitY();
    return {kRing_m * out + kTube_m * n, n};
}

// At the place of the torus nearest to another.
Vector3 torus_normal(const Vector3& place_W) {
    const Vector3 ring_W = kRing_m * Vector3(place_W.x(), 0.0, place_W.z()).normalized();
    return (place_W - ring_W).normalized();
}

SentStroke stroke(const MeshShape& mesh, const Material& material, bool rounded, const Way& way,
                  double speed_m_per_s) {
    SentForce loop(test::make_touch_lesson(material, rounded), mesh);
    return stroke(loop, material, way, speed_m_per_s);
}

}  // namespace

TEST_CASE("sent force: over a rounded surface nothing is sent along it, of whatever material") {
    const auto sphere = touchable(make_sphere(0.1, 22));
    const auto torus = touchable(make_torus(kRing_m, kTube_m, 192, 96));
    for (const Material& shipped : shipped_materials()) {
        for (const double speed_m_per_s : {0.02, 0.2, 0.5}) {
            INFO(shipped.name << " at " << speed_m_per_s << " m/s");
            CHECK(stroke(sphere, bare(shipped), true, on_sphere, speed_m_per_s).sideways_N < 0.005);
            SentForce loop(test::make_touch_lesson(bare(shipped), true), torus);
            CHECK(stroke(loop, shipped, on_torus, speed_m_per_s, torus_normal).sideways_N < 0.005);
        }
    }
}

TEST_CASE(
    "sent force: a rounded body that is never touched changes nothing of what another gives") {
    constexpr double kRadius_m = 0.1;
    constexpr double kStiffness_N_per_m = 300.0;
    const auto ball = touchable(make_sphere(kRadius_m, 3));
    Material material = *find_material("metal");
    material.friction = {1.5, 1.5, 0.0};
    material.texture = {};
    material.transient = {};
    material.coupling.stiffness_N_per_m = kStiffness_N_per_m;
    const auto make = [&](bool is_rounded) {
        runtime::LessonDescription lesson = test::make_touch_lesson(material, false);
        lesson.bodies.push_back(lesson.bodies[0]);
        lesson.bodies[1].name = lesson.bodies[1].noun = "other";
        lesson.bodies[1].position_W = Vector3(1.0, 0.0, 0.0);
        lesson.bodies[1].shading.on = is_rounded;
        return SentForce(lesson, ball);
    };
    SentForce alone = make(false);
    SentForce beside = make(true);
    const double deep_m = 3.0 / kStiffness_N_per_m;
    for (SentForce* loop : {&alone, &beside}) {
        loop->open_gate(Vector3(0.0, 0.2, 0.0));
        for (double y_m = 0.2; y_m > kRadius_m - deep_m; y_m -= 1.0e-4) {
            loop->step(Vector3(0.0, y_m, 0.0));
        }
    }
    for (int round = 0; round < 3000; ++round) {
        const double s = 0.005 * round;  // 0.5 m/s
        const double angle_rad = 1.2 * std::sin(s);
        const Vector3 out =
            Vector3(std::sin(angle_rad), std::cos(angle_rad), 0.3 * std::sin(2.3 * s)).normalized();
        const Vector3 hand_W = (kRadius_m - deep_m - std::sin(3.7 * s) / kStiffness_N_per_m) * out;
        INFO("round " << round);
        REQUIRE(alone.step(hand_W) == beside.step(hand_W));
    }
}

TEST_CASE("sent force: the program's own ball is felt as a ball, alone and among meshes") {
    const auto coarse = touchable(make_sphere(0.1, 1));
    const Material metal = bare(*find_material("metal"));
    for (const bool alone : {true, false}) {
        runtime::LessonDescription lesson = test::make_touch_lesson(metal, false, "sphere");
        if (!alone) {
            lesson.bodies.push_back(lesson.bodies[0]);
            lesson.bodies[1].name = lesson.bodies[1].model = "thing beside";
            lesson.bodies[1].position_W = Vector3(0.0, 0.25, 0.0);
        }
        for (const double speed_m_per_s : {0.02, 0.2, 0.5}) {
            SentForce loop(lesson, coarse);
            const SentStroke sent = stroke(loop, metal, on_sphere, speed_m_per_s);
            CHECK(sent.sideways_N < 1.0e-3);
            CHECK(sent.along_N < 1.0e-3);
            CHECK(loop.state().touched_body == 0);
            CHECK(loop.plan().proxy.kind == ProxyKind::god_object);
        }
    }
}

TEST_CASE("sent force: on facets the damper adds nothing along the surface to the spring's own") {
    for (const int frequency : {4, 12, 40}) {
        const auto mesh = touchable(make_sphere(0.1, frequency));
        Material metal = bare(*find_material("metal"));
        const double damped_N = stroke(mesh, metal, false, on_sphere, 0.2).sideways_N;
        metal.coupling.damping_Ns_per_m = 0.0;
        CHECK(damped_N < stroke(mesh, metal, false, on_sphere, 0.2).sideways_N + 0.005);
    }
}

TEST_CASE("sent force: what slides is never pulled along, and friction stays in its cone") {
    const auto sphere = touchable(make_sphere(0.1, 40));
    for (const Material& shipped : shipped_materials()) {
        Material material = bare(shipped);
        material.friction = shipped.friction;
        for (const double speed_m_per_s : {0.05, 0.2, 0.5}) {
            const SentStroke sent = stroke(sphere, material, true, on_sphere, speed_m_per_s);
            INFO(shipped.name << " at " << speed_m_per_s << " m/s: along " << sent.along_N
                              << ", cone " << sent.cone);
            CHECK(sent.along_N < 0.05);
            CHECK(sent.cone < 1.03 * shipped.friction.static_coefficient + 0.003);
        }
    }
}

TEST_CASE(
    "sent force: what slides over a rounded ring is held by its friction, no more and no less") {
    // The evened normals of so coarse a ring are wrong by 0.0016.
    constexpr double kShading = 0.002;
    const auto torus = touchable(make_torus(kRing_m, kTube_m, 96, 48));
    for (const Material& shipped : shipped_materials()) {
        Material material = bare(shipped);
        // One circle for what sticks and what slides.
        const double coefficient = shipped.friction.dynamic_coefficient;
        material.friction = {coefficient, coefficient, 0.0};
        for (const double speed_m_per_s : {0.02, 0.2, 0.5}) {
            // A force that is held for a round does not turn with a hollow that the hand goes through: it would push by F v T / 2 R, and
            // that is braked.
            const double held = speed_m_per_s * 0.001 / (2.0 * kTube_m);
            for (const auto way : {on_torus, in_hollow}) {
                SentForce loop(test::make_touch_lesson(material, true), torus);
                const SentStroke sent = stroke(loop, material, way, speed_m_per_s, torus_normal);
                INFO(shipped.name << " at " << speed_m_per_s << " m/s: along " << sent.along_N
                                  << ", cone " << sent.least_cone << " to " << sent.cone << " for "
                                  << coefficient);
                CHECK(sent.along_N < 0.05);
                CHECK(sent.cone < 1.03 * coefficient + kShading + held);
                CHECK(sent.least_cone > 0.97 * coefficient - kShading);
            }
        }
    }
}
