// The program's own haptic loop with an arm of seven joints on a floor: joint dynamics, dry friction, encoder steps and all.
#include "haptics/collision/collision_mesh.h"
#include "haptics/device/arm/simulated_wam.h"
#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>

using namespace fulcrum;

namespace {

constexpr double kAbove_m = 0.01;

HapticPlan make_plan() {
    HapticPlan plan;
    plan.expects_lesson = false;
    plan.safety.soft_start_s = 0.0;
    plan.safety.max_slew_N_per_s = 5000.0;
    plan.coupling.stiffness_N_per_m = 1000.0;
    const auto box = make_box(Vector3(2.0, 2.0, 2.0)).value();
    plan.solids.push_back({.body = 0,
                           .shape = CollisionMesh::create(box).value(),
                           .initial_pose_W = Pose::at(Vector3(0.0, -1.0 - kAbove_m, 0.0))});
    return plan;
}

// From the least to the most of what was seen.
struct Span {
    double low = 1.0e9;
    double high = -1.0e9;
    void take(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

struct Course {
    Span height_m, force_N;
    Fault faults = Fault::none;
};

// The hand presses `press_m` below the floor; what the last second of four sees.
Course press(const HandGrip& grip, double press_m) {
    LatestValue<HandTarget> target;
    SimulatedWamSettings settings;
    settings.grip = grip;
    const auto wam = SimulatedWam::create(settings, target);
    REQUIRE(wam);
    const HapticPlan plan = make_plan();
    REQUIRE(validate(plan, (*wam)->traits()));
    const auto channels = std::make_unique<HapticChannels>();
    HapticLoop loop(plan, **wam, *channels);
    Course course;
    for (int k = 1; k <= 4000; ++k) {
        if (k == 200) {
            // By then the gate has engaged.
            HandTarget wanted;
            wanted.pose_D.position.y() = -kAbove_m - press_m;
            target.publish(wanted);
        }
        loop.step(0.001 * k);
        course.faults = course.faults | loop.state().faults;
        if (k > 3000) {
            course.height_m.take((*wam)->compute_pose_D().position.y());
            course.force_N.take(loop.state().applied_W.force.y());
        }
    }
    return course;
}

}  // namespace

TEST_CASE("WAM on a floor: the haptic loop holds every hand that presses it, without a buzz") {
    HandGrip finger;
    finger.push = kFingertip;
    HandGrip arm;
    arm.push = kArm;
    const struct {
        HandGrip grip;
        double press_m;
    } hands[] = {{HandGrip{}, 0.012}, {finger, 0.012}, {arm, 0.025}};
    for (const auto& hand : hands) {
        const Course course = press(hand.grip, hand.press_m);
        CAPTURE(hand.grip.push.stiffness_N_per_m, course.height_m.low, course.height_m.high,
                course.force_N.low, course.force_N.high);
        CHECK(course.faults == Fault::none);
        // It pushes back, less than the gate's 5 N, and the handle is in the floor by what the coupling gives way.
        CHECK(course.force_N.low > 0.5);
        CHECK(course.force_N.high < 5.0);
        CHECK(course.height_m.high < -kAbove_m);
        CHECK(course.height_m.low > -kAbove_m - 0.006);
        // Two steps of the encoder, and what they ripple: nothing that a hand feels.
        CHECK(course.height_m.high - course.height_m.low < 8.0e-5);
        CHECK(course.force_N.high - course.force_N.low < 0.3);
    }
}
