#include "haptics/dynamics/island_turns.h"

#include <algorithm>
#include <limits>

namespace fulcrum {
namespace {

double find_speed(const RigidWorldBody& body, const Twist& velocity) noexcept {
    return velocity.linear.norm() + velocity.angular.norm() * body.shape.bounding_radius_m;
}

// One that is awake wakes all.
bool wake_island(std::span<const std::int32_t> bodies, RigidScene& scene) noexcept {
    const bool is_awake =
        std::ranges::any_of(bodies, [&](std::int32_t i) { return !scene.body(i).asleep; });
    for (const std::int32_t i : bodies) {
        RigidWorldBody& body = scene.body(i);
        if (is_awake && body.asleep) {
            body.wake();
        }
    }
    return is_awake;
}

}  // namespace

// Those that have just met have not waited equally long: the least counts, and the rest is dropped.
void IslandTurns::find(double dt_s, const SceneIslands& islands, RigidScene& scene) noexcept {
    due_.clear();
    n_asleep_ = 0;
    for (std::int32_t island = 0; island < islands.count(); ++island) {
        const auto bodies = islands.bodies_of(island);
        if (!wake_island(bodies, scene)) {
            n_asleep_ += static_cast<int>(bodies.size());
            continue;
        }
        bool is_touched = false;
        double behind_s = std::numeric_limits<double>::infinity();
        for (const std::int32_t i : bodies) {
            RigidWorldBody& body = scene.body(i);
            body.behind_s += dt_s;
            behind_s = std::min(behind_s, body.behind_s);
            is_touched = is_touched || body.touched;
        }
        // Half a step for rounding.
        if (is_touched || behind_s + 0.5 * dt_s >= slow_period_s_) {
            due_.add({island, behind_s});
        }
    }
}

bool IslandTurns::may_rest(const IslandParts& parts, const RigidScene& scene) const noexcept {
    const auto is_driven = [&](std::int32_t i) {
        const JointDrive& drive = scene.joint(i).drive;
        return drive.motor_force > 0.0 && drive.motor_speed != 0.0;
    };
    const bool touches = std::ranges::any_of(
        parts.pairs, [&](std::int32_t i) { return scene.pairs.at(i).manifold.count > 0; });
    return sleep_after_s_ > 0.0 && (touches || !parts.joints.empty()) &&
           std::ranges::none_of(parts.joints, is_driven);
}

void IslandTurns::rest(const IslandParts& parts, double dt_s, RigidScene& scene) const noexcept {
    double least_s = std::numeric_limits<double>::infinity();
    for (const std::int32_t i : parts.bodies) {
        RigidWorldBody& body = scene.body(i);
        const double speed =
            std::max(find_speed(body, body.state.velocity_W), find_speed(body, body.drift_W));
        const bool is_slow = !body.touched && speed <= sleep_speed_m_per_s_;
        body.still_s = is_slow ? body.still_s + dt_s : 0.0;
        body.touched = false;
        least_s = std::min(least_s, body.still_s);
    }
    if (may_rest(parts, scene) && least_s >= sleep_after_s_) {
        for (const std::int32_t i : parts.bodies) {
            scene.body(i).asleep = true;
            scene.body(i).state.velocity_W = {};
        }
    }
}

}  // namespace fulcrum
