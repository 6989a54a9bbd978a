// A small world for tests: three bodies and a bucket, and what is said to it.
#pragma once

#include "haptics/dynamics/world.h"

namespace fulcrum {

inline constexpr double kDt_s = 0.002;

/// A heavy body that the opening nearly clips, and two light ones; gravity 9.81 m/s^2, ground at 0.
inline WorldPlan make_world_plan() {
    WorldPlan plan;
    plan.bodies = {{5.0, 4.0, 0.09, 0.0}, {0.2, 0.6, 0.04, 0.0}, {0.12, 0.4, 0.04, 0.0}};
    plan.catcher.present = true;
    plan.catcher.opening_radius_m = 0.1;
    plan.catcher.depth_m = 0.12;
    plan.catcher.capacity = 8;
    return plan;
}

inline WorldCommand make_command(WorldCommand::Kind kind, std::int32_t body,
                                 const Vector3& position_W = Vector3::Zero(),
                                 const Vector3& velocity_W = Vector3::Zero()) {
    return {kind, body, position_W, velocity_W};
}

/// A hand in free space: the proxy is where the tool is.
inline HapticState tool_at(const Vector3& position_W) {
    HapticState tool;
    tool.tool_pose_W.position = position_W;
    tool.proxy_position_W = position_W;
    return tool;
}

inline bool is_same(const BodyState& a, const BodyState& b) {
    return a.pose_W.position == b.pose_W.position &&
           a.pose_W.orientation.coeffs() == b.pose_W.orientation.coeffs() &&
           a.velocity_W == b.velocity_W && a.where == b.where;
}

/// A world that is told and asked in few words.
struct ToldWorld : World {
    explicit ToldWorld(const WorldPlan& plan = make_world_plan()) : World(plan) {}

    void tell(WorldCommand::Kind kind, std::int32_t body, const Vector3& at_W = Vector3::Zero(),
              const Vector3& velocity_W = Vector3::Zero()) {
        apply(make_command(kind, body, at_W, velocity_W));
    }
    void drop(std::int32_t body, const Vector3& at_W = Vector3::Zero(),
              const Vector3& velocity_W = Vector3::Zero()) {
        tell(WorldCommand::Kind::drop, body, at_W, velocity_W);
    }
    void hold(std::int32_t body) { tell(WorldCommand::Kind::hold, body); }
    void run(const HapticState& tool, int n = 1) {
        for (int k = 0; k < n; ++k) {
            step(kDt_s, tool);
        }
    }
    /// Steps until an event comes, at most `n` steps; the event, or one without a body.
    WorldEvent run_to_event(const HapticState& tool, int n = 2000) {
        for (int k = 0; k < n; ++k) {
            run(tool);
            if (!events().empty()) {
                return events().front();
            }
        }
        return {};
    }
    [[nodiscard]] const BodyState& body(std::size_t index = 1) const {
        return snapshot().bodies[index];
    }
    [[nodiscard]] const Vector3& at_W(std::size_t index = 1) const {
        return body(index).pose_W.position;
    }
};

inline WorldPlan make_weightless_plan() {
    WorldPlan plan = make_world_plan();
    plan.gravity_W.setZero();
    return plan;
}

}  // namespace fulcrum
