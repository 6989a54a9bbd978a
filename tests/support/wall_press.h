// A hand of the simulation that goes to a wall and presses it through the loop, and how it shakes then.
#pragma once

#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/support/touchable.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace fulcrum::wall_press {

/// A light handle in a loose grip: of its own it damps 0.2 Ns/m, less than k T / 2 of any wall here.
inline SimulatedHandSettings make_loose_grip() {
    SimulatedHandSettings settings;
    settings.mass_kg = 0.05;
    settings.stiffness_N_per_m = 50.0;
    settings.damping_Ns_per_m = 0.2;
    settings.start_pose_D = Pose::at(Vector3(0.0, 0.03, 0.0));
    return settings;
}

/// A box whose top is the plane y = 0.
inline HapticPlan make_wall(double stiffness_N_per_m, double damping_Ns_per_m) {
    HapticPlan plan;
    plan.expects_lesson = false;
    plan.coupling.stiffness_N_per_m = stiffness_N_per_m;
    plan.coupling.damping_Ns_per_m = damping_Ns_per_m;
    plan.solids.push_back({0,
                           CollisionMesh::create(make_box(Vector3::Constant(0.4)).value()).value(),
                           Pose::at(Vector3(0.0, -0.2, 0.0))});
    return plan;
}

struct Press {
    double speed_m_per_s = 0.1;
    double depth_m = 0.02;  ///< the wish: how far into the wall
};

/// What was rendered, round by round.
struct Course {
    std::vector<Vector3> force_N;
    std::vector<double> speed_m_per_s;
    double braked_J = 0.0;
    double peak_J = 0.0;
};

/// Waits until the gate is open, then goes to the wall and presses for four seconds.
inline Course press(const HapticPlan& plan, const SimulatedHandSettings& settings,
                    const Press& how) {
    LatestValue<HandTarget> target;
    SimulatedHand hand(settings, target);
    auto channels = std::make_unique<HapticChannels>();
    HapticLoop loop(plan, hand, *channels);
    Course course;
    const double dt_s = 1.0 / plan.rate_hz;
    const int n = static_cast<int>(7.0 * plan.rate_hz);
    for (int k = 1; k <= n; ++k) {
        const double way_m = how.speed_m_per_s * std::max(k * dt_s - 3.0, 0.0);
        HandTarget wanted;
        wanted.pose_D.position.y() = std::max(0.03 - way_m, -how.depth_m);
        target.publish(wanted);
        loop.step(k * dt_s);
        course.force_N.push_back(loop.state().applied_W.force);
        course.speed_m_per_s.push_back(hand.velocity_D().norm());
    }
    course.braked_J = loop.state().force_energy.braked_J;
    course.peak_J = loop.state().force_energy.peak_J;
    return course;
}

/// Of the force about its mean, and of the speed, in the last second.
struct Shaking {
    double force_N = 0.0;
    double speed_m_per_s = 0.0;
    double mean_N = 0.0;
};
inline Shaking last_second(const Course& course, double rate_hz) {
    const auto n = static_cast<std::size_t>(rate_hz);
    const std::size_t first = course.force_N.size() - n;
    Vector3 mean = Vector3::Zero();
    for (std::size_t i = first; i < course.force_N.size(); ++i) {
        mean += course.force_N[i] / rate_hz;
    }
    Shaking shaking;
    for (std::size_t i = first; i < course.force_N.size(); ++i) {
        shaking.force_N += (course.force_N[i] - mean).squaredNorm() / rate_hz;
        shaking.speed_m_per_s += std::pow(course.speed_m_per_s[i], 2) / rate_hz;
    }
    return {std::sqrt(shaking.force_N), std::sqrt(shaking.speed_m_per_s), mean.norm()};
}

}  // namespace fulcrum::wall_press
