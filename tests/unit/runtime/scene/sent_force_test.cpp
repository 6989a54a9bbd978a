// What reaches a hand that strokes a solid, with the plan, the damper, the passivity stage and the gate that a lesson gets.
#include "tests/support/sent_force.h"

#include "haptics/geometry/shape.h"
#include "haptics/math/length.h"
#include "haptics/surface/materials.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

using namespace fulcrum;
using test::SentForce;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kPush_N = 2.0;

// A place on a true surface along a stroke, with its normal.
struct Place {
    Vector3 at_W;
    Vector3 normal_W;
};
using Way = std::function<Place(double way_m)>;

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

struct Sent {
    double sideways_N = 0.0;  // root mean square, less what the spring alone has
    double along_N = -1.0e9;  // most that points along the way
    double cone = 0.0;        // most of tangential over normal force while it slides
};

// Strokes with 2 N of the spring, after coming in from outside.
Sent stroke(SentForce& loop, const Material& material, const Way& way, double speed_m_per_s) {
    constexpr double kAway_m = 0.002;
    const auto hand_at = [&](double way_m, double deep_m) {
        const Place place = way(way_m);
        return Vector3(place.at_W - deep_m * place.normal_W);
    };
    const double deep_m = kPush_N / material.coupling.stiffness_N_per_m;
    loop.open_gate(hand_at(0.0, -kAway_m));
    for (double in_m = -kAway_m; in_m < deep_m; in_m += 2.0e-5) {
        (void)loop.step(hand_at(0.0, in_m));
    }
    Sent sent;
    double squares = 0.0;
    int n = 0;
    Vector3 before_W = hand_at(0.0, deep_m);
    const double settled_m = 0.02 + 0.05 * speed_m_per_s;
    for (double way_m = 0.0; way_m < settled_m + 0.1; way_m += kDt_s * speed_m_per_s) {
        const Place place = way(way_m);
        const Vector3 hand_W = place.at_W - deep_m * place.normal_W;
        const Vector3 force_W = loop.step(hand_W);
        if (way_m > settled_m) {
            const Vector3 side_W = force_W - force_W.dot(place.normal_W) * place.normal_W;
            const Vector3 moved_W = hand_W - before_W;
            squares += side_W.squaredNorm();
            sent.along_N = std::max(sent.along_N, side_W.dot(moved_W.normalized()));
            sent.cone = std::max(sent.cone, side_W.norm() / force_W.dot(place.normal_W));
            ++n;
        }
        before_W = hand_W;
    }
    sent.sideways_N = std::sqrt(squares / n);
    return sent;
}

Sent stroke(const MeshShape& mesh, const Material& material, bool rounded, const Way& way,
            double speed_m_per_s) {
    SentForce loop(test::make_touch_lesson(material, rounded), mesh);
    return stroke(loop, material, way, speed_m_per_s);
}

Material bare(const Material& shipped) {
    Material material = shipped;
    material.friction = {};
    material.texture = {};
    material.transient = {};
    return material;
}

}  // namespace

TEST_CASE("sent force: over a rounded surface nothing is sent along it, of whatever material") {
    const auto sphere = touchable(make_sphere(0.1, 22));
    const auto torus = touchable(make_torus(kRing_m, kTube_m, 192, 96));
    for (const Material& shipped : shipped_materials()) {
        for (const double speed_m_per_s : {0.02, 0.2, 0.5}) {
            INFO(shipped.name << " at " << speed_m_per_s << " m/s");
            CHECK(stroke(sphere, bare(shipped), true, on_sphere, speed_m_per_s).sideways_N < 0.005);
            CHECK(stroke(torus, bare(shipped), true, on_torus, speed_m_per_s).sideways_N < 0.02);
        }
    }
}

TEST_CASE("sent force: the program's own ball is felt as a ball, not as its mesh") {
    const auto coarse = touchable(make_sphere(0.1, 1));
    const Material metal = bare(*find_material("metal"));
    SentForce loop(test::make_touch_lesson(metal, false, "sphere"), coarse);
    const Sent sent = stroke(loop, metal, on_sphere, 0.2);
    CHECK(sent.sideways_N < 1.0e-3);
    CHECK(loop.state().touched_body == 0);
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
            const Sent sent = stroke(sphere, material, true, on_sphere, speed_m_per_s);
            INFO(shipped.name << " at " << speed_m_per_s << " m/s: along " << sent.along_N
                              << ", cone " << sent.cone);
            CHECK(sent.along_N < 0.05);
            CHECK(sent.cone < 1.03 * shipped.friction.static_coefficient + 0.003);
        }
    }
}
