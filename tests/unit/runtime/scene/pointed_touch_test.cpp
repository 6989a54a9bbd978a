// A mouse presses what lies in a lesson: what is seen of the force comes to rest, where it should.
#include "tests/support/pointed_touch.h"

#include "haptics/surface/materials.h"
#include "tests/support/sent_force.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum;
using test::PointedTouch;

namespace {

runtime::LessonDescription make_ball_of(double stiffness_N_per_m) {
    Material material = *find_material("metal");
    material.friction = {};
    material.texture = {};
    material.transient = {};
    material.coupling = {.stiffness_N_per_m = stiffness_N_per_m, .damping_Ns_per_m = 0.0};
    return test::make_touch_lesson(material, false, "sphere");
}

constexpr double kBall_m = 0.1;
constexpr double kCalm_s = 1.0;  // until the gate is open

// From where nothing is touched to so deep below the top, where it stays.
struct Pressed {
    double stiffness_N_per_m = 0.0;  // as the plan lets it be
    double force_N = 0.0;            // in the end
    double unrest_N = 0.0;           // from the least to the most of the last 0.3 s
    double seen_m = 0.0;             // how far the hand gave way
};
Pressed press(const runtime::LessonDescription& lesson, double yield, double depth_m) {
    PointedTouch mouse(lesson, nullptr, yield);
    (void)mouse.point_at({0.0, kBall_m + 0.02, 0.0}, kCalm_s);
    const Vector3 place_W(0.0, kBall_m - depth_m, 0.0);
    (void)mouse.point_at(place_W, 1.5);
    Pressed pressed;
    pressed.stiffness_N_per_m = mouse.plan().solids.front().coupling->stiffness_N_per_m;
    double least_N = 1e9;
    double most_N = 0.0;
    for (int i = 0; i < 300; ++i) {
        pressed.force_N = mouse.point_at(place_W, 0.001).norm();
        least_N = std::min(least_N, pressed.force_N);
        most_N = std::max(most_N, pressed.force_N);
    }
    pressed.unrest_N = most_N - least_N;
    pressed.seen_m = (mouse.hand_W() - place_W).norm();
    return pressed;
}

}  // namespace

TEST_CASE(
    "pointed touch: a hand gives way as a spring in line with the wall's, and comes to rest") {
    for (const double yield : {0.0, 0.5, 1.0, kMostYield}) {
        for (const double stiffness_N_per_m : {100.0, 500.0, 1500.0, 3000.0, 5000.0}) {
            for (const double depth_m : {0.0005, 0.002, 0.010, 0.040}) {
                const auto lesson = make_ball_of(stiffness_N_per_m);
                const Pressed pressed = press(lesson, yield, depth_m);
                INFO(yield << " x, " << stiffness_N_per_m << " N/m, " << depth_m << " m");
                const double sag = make_yielding(yield).sag_m_per_N;
                const double wanted_N = depth_m / (1.0 / pressed.stiffness_N_per_m + sag);
                // The gate's limit is all that is sent.
                if (wanted_N < 4.5) {
                    CHECK(pressed.force_N == Approx(wanted_N).epsilon(0.02));
                } else {
                    CHECK(pressed.force_N <= 5.0 + 1e-9);
                }
                CHECK(pressed.unrest_N < 0.005);
                CHECK(pressed.seen_m == Approx(sag * pressed.force_N).margin(1e-5));
            }
        }
    }
}

TEST_CASE("pointed touch: without yielding the hand is where the mouse is, whatever pushes") {
    const Pressed pressed = press(make_ball_of(500.0), 0.0, 0.005);
    CHECK(pressed.seen_m < 1e-9);
    CHECK(pressed.force_N > 2.0);
}
