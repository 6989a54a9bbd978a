// How far round it a body of the world looks for others, and what counts as near.
//
//   reach = 2e-3 R + t (|v| + t |a|) + t (|w| + t |I^-1 torque|) lever       what it may come to in the time t under its loads
// Thread: the world loop; during the solving of islands, that of the island's own. Cost: some ten ns.
#pragma once

#include "haptics/collision/contact_sweep.h"
#include "haptics/dynamics/rigid_world_body.h"
#include "haptics/math/length.h"

#include <algorithm>

namespace fulcrum {

/// Of a body's size: what is nearer than this is near, however slow.
inline constexpr double kNearPart = 2.0e-3;

[[nodiscard]] inline double find_near(const RigidWorldBody& a, const RigidWorldBody& b) noexcept {
    return kNearPart * (a.shape.bounding_radius_m + b.shape.bounding_radius_m);
}

/// How near two bodies bounce: the same of the smaller one alone, for a large one may be near from far.
[[nodiscard]] inline double find_bounce_gap(const RigidWorldBody& a,
                                            const RigidWorldBody& b) noexcept {
    const double size_a = a.shape.bounding_radius_m;
    const double size_b = b.shape.bounding_radius_m;
    return kNearPart *
           (size_a > 0.0 && size_b > 0.0 ? std::min(size_a, size_b) : std::max(size_a, size_b));
}

/// How far the farthest of a body comes in a second, or with a way, in all.
[[nodiscard]] inline double find_farthest(const Twist& velocity_W, double lever_m) noexcept {
    return compute_length(velocity_W.linear) + compute_length(velocity_W.angular) * lever_m;
}

/// Of a's points over b's at a place and time on their ways: below 0 they approach.
[[nodiscard]] inline double find_apart(const Vector3& normal_W, const Vector3& place_W,
                                       double time_s, const RigidWorldBody& a,
                                       const RigidWorldBody& b) noexcept {
    const auto velocity_of = [&](const RigidWorldBody& body) noexcept {
        const Vector3 arm = place_W - body.state.pose_W.position - time_s * body.ahead_W.linear;
        return Vector3(body.ahead_W.linear + body.ahead_W.angular.cross(arm));
    };
    return normal_W.dot(velocity_of(a) - velocity_of(b));
}

/// On its way by this velocity, or by such a way in all.
[[nodiscard]] inline MovingShape make_moving(const RigidWorldBody& body,
                                             const Twist& velocity_W) noexcept {
    return {&body.shape, body.place, body.state.pose_W.position, velocity_W, body.lever_m};
}

/// Of its shape, and its inertia in the world, from its state.
inline void place_body(RigidWorldBody& body) noexcept {
    const Matrix3 R = body.state.pose_W.orientation.toRotationMatrix();
    body.place.turn_WB = R * body.turn_PB;
    body.place.position_W = body.state.pose_W.position + R * body.X_PB.position;
    if (body.moves) {
        body.inertia_W = R * body.inertia.moments_kg_m2.asDiagonal() * R.transpose();
    }
}

/// Sets the velocity that its loads bring it to in the time; returns what is gained of it.
inline Twist find_ahead(RigidWorldBody& body, const Vector3& gravity_W, double reach_s) noexcept {
    const Twist& velocity = body.state.velocity_W;
    const Twist gained{
        reach_s * (gravity_W + body.load_W.force / body.inertia.mass_kg),
        compute_spin_W(body.inertia, body.state.pose_W.orientation, reach_s * body.load_W.torque)};
    body.ahead_W = {velocity.linear + gained.linear, velocity.angular + gained.angular};
    return gained;
}

/// Sets what it may meet on its way in the time, and how far that is.
inline void find_reach(RigidWorldBody& body, const Vector3& gravity_W, double reach_s) noexcept {
    const double near_m = kNearPart * body.shape.bounding_radius_m;
    body.ahead_W = {};
    body.reach_m = near_m;
    if (!body.moves) {
        return;
    }
    const Twist gained = find_ahead(body, gravity_W, reach_s);
    body.reach_m += reach_s * (find_farthest(body.state.velocity_W, body.lever_m) +
                               find_farthest(gained, body.lever_m));
}

}  // namespace fulcrum
