// The step path of world.h.
#include "haptics/dynamics/world.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

constexpr double kSpin_rad_per_s = 1.5;     // gentle: a turn in four seconds
constexpr double kGlideTime_s = 0.08;       // into the bucket's place: quick, and still seen
constexpr double kGlideEnd_m = 1.0e-4;      // nobody sees less
constexpr double kRestitution = 0.25;       // share of the speed kept upwards in a bounce
constexpr double kGroundGrip = 0.5;         // share of the sideways speed and spin kept in a bounce
constexpr double kRestSpeed_m_per_s = 0.2;  // a slower bounce is none
constexpr double kFarthest_m = 1.0e4;       // no scene is larger
constexpr double kFastest_m_per_s = 1.0e3;  // no thing in a scene is faster
constexpr double kUnitTolerance = 1.0e-3;
const Vector3 kOutOfReach_W(0.0, -2.0 * kFarthest_m, 0.0);  // of every hand: hidden solids

// The tool as it is seen: turned like the hand, standing where the proxy is.
Pose get_tool_pose(const HapticState& tool) noexcept {
    return {tool.proxy_position_W, tool.tool_pose_W.orientation};
}

bool is_pose(const Pose& pose) noexcept {
    return is_finite(pose) && std::abs(pose.orientation.coeffs().norm() - 1.0) < kUnitTolerance;
}

}  // namespace

void World::step(double dt_s, const HapticState& tool) noexcept {
    n_events_ = 0;
    if (!(dt_s > 0.0) || !std::isfinite(dt_s)) {
        return;
    }
    const Pose before_WT = take_tool(tool);
    snapshot_.time_s += dt_s;
    if (n_moving_ == 0 && n_held_ == 0) {
        return;
    }
    move_bodies(dt_s, before_WT);
    describe();
}

// Returns where it was.
Pose World::take_tool(const HapticState& tool) noexcept {
    const Pose asked_WT = get_tool_pose(tool);
    const Pose before_WT = has_tool_ ? tool_WT_ : asked_WT;
    if (is_pose(asked_WT)) {
        tool_WT_ = asked_WT;
        has_tool_ = true;
    }
    return before_WT;
}

void World::move_bodies(double dt_s, const Pose& tool_before_WT) noexcept {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (bodies_[i].where == BodyWhere::falling) {
            move_falling(i, dt_s, tool_before_WT);
        } else if (bodies_[i].where == BodyWhere::held) {
            const Vector3 before_W = bodies_[i].pose_W.position;
            move_held(bodies_[i], dt_s);
            bodies_[i].velocity_W = (bodies_[i].pose_W.position - before_W) / dt_s;
        } else if (bodies_[i].where == BodyWhere::landed && bodies_[i].moving) {
            move_landed(bodies_[i], dt_s);
        }
    }
}

void World::apply(const WorldCommand& command) noexcept {
    if (!is_usable(command)) {
        ++ignored_commands_;
        return;
    }
    if (command.kind == WorldCommand::Kind::release) {
        for (RigidBody& body : bodies_) {
            if (body.where == BodyWhere::held) {
                body.where = BodyWhere::hidden;
                body.moving = false;
                ++body.n_placements;
            }
        }
    } else {
        RigidBody& body = bodies_[static_cast<std::size_t>(command.body)];
        ++body.n_placements;
        if (command.kind != WorldCommand::Kind::hold) {
            free_body(body, command);
        } else if (body.where != BodyWhere::held && is_full()) {
            ++ignored_commands_;
        } else if (body.where != BodyWhere::held) {
            hold_body(body);
            body.pose_T = Pose::at(body.resting_place_T);
            body.velocity_W.setZero();
            move_held(body, 0.0);
        }
    }
    describe();
}

// Counted afresh: two bodies may reach the opening in one step.
bool World::is_full() const noexcept {
    const auto held = std::count_if(bodies_.begin(), bodies_.end(), [](const RigidBody& body) {
        return body.where == BodyWhere::held;
    });
    return held >= plan_.catcher.capacity;
}

bool World::is_usable(const WorldCommand& command) const noexcept {
    if (command.kind == WorldCommand::Kind::release) {
        return true;
    }
    const auto kind = static_cast<std::uint8_t>(command.kind);
    return kind < static_cast<std::uint8_t>(WorldCommand::Kind::release) && command.body >= 0 &&
           static_cast<std::size_t>(command.body) < bodies_.size() &&
           command.position_W.cwiseAbs().maxCoeff() <= kFarthest_m &&
           command.velocity_W.cwiseAbs().maxCoeff() <= kFastest_m_per_s &&
           is_finite(command.position_W) && is_finite(command.velocity_W);
}

// drop, place, hide: out of the tool, wherever the command says.
void World::free_body(RigidBody& body, const WorldCommand& command) noexcept {
    body.pose_W = {command.position_W, Quaternion::Identity()};
    body.velocity_W.setZero();
    body.spin_W.setZero();
    body.moving = command.kind == WorldCommand::Kind::drop;
    if (command.kind == WorldCommand::Kind::hide) {
        body.where = BodyWhere::hidden;
        return;
    }
    body.where = body.moving ? BodyWhere::falling : BodyWhere::placed;
    if (body.moving) {
        body.velocity_W = command.velocity_W;
        // Each drop turns about another axis, the same ones in every run.
        const double angle_rad = std::numbers::pi * (3.0 - std::sqrt(5.0)) * ++n_drops_;
        body.spin_W =
            kSpin_rad_per_s * Vector3(std::cos(angle_rad), 0.5, std::sin(angle_rad)).normalized();
    }
}

// From now on it rides in the tool; the caller says from where in it.
void World::hold_body(RigidBody& body) noexcept {
    body.resting_place_T = catcher_.compute_resting_place(body.radius_m, bodies_);
    body.where = BodyWhere::held;
    body.spin_W.setZero();
    body.moving = true;
}

void World::move_falling(std::size_t index, double dt_s, const Pose& tool_before_WT) noexcept {
    RigidBody& body = bodies_[index];
    const Vector3 before_W = body.pose_W.position;
    const Vector3 before_T = tool_before_WT.inverse() * before_W;
    step_flight(body, plan_.gravity_W, dt_s);
    // Through the opening?
    if (catcher_.present() && has_tool_ && !is_full()) {
        const Pose inverse_TW = tool_WT_.inverse();
        const Vector3 after_T = inverse_TW * body.pose_W.position;
        const Crossing crossing = catcher_.compute_crossing(before_T, after_T, body.radius_m);
        if (crossing.inside) {
            const double speed_m_per_s = (after_T - before_T).norm() / dt_s;
            hold_body(body);
            body.pose_T = {before_T + crossing.share * (after_T - before_T),
                           (inverse_TW.orientation * body.pose_W.orientation).normalized()};
            move_held(body, (1.0 - crossing.share) * dt_s);
            // The mean of the whole step, half flight and half glide: no leap at the catch.
            body.velocity_W = (body.pose_W.position - before_W) / dt_s;
            add_event(WorldEvent::Kind::caught, index, speed_m_per_s);
            return;
        }
    }
    // Onto the ground?
    if (body.pose_W.position.y() <= plan_.ground_height_m + body.radius_m) {
        const double speed_m_per_s = body.velocity_W.norm();
        body.where = BodyWhere::landed;
        bounce(body);
        add_event(WorldEvent::Kind::landed, index, speed_m_per_s);
    }
}

void World::move_landed(RigidBody& body, double dt_s) noexcept {
    step_flight(body, plan_.gravity_W, dt_s);
    if (body.pose_W.position.y() <= plan_.ground_height_m + body.radius_m) {
        bounce(body);
    }
}

void World::bounce(RigidBody& body) noexcept {
    body.pose_W.position.y() = plan_.ground_height_m + body.radius_m;
    const double up_m_per_s = std::max(-kRestitution * body.velocity_W.y(), 0.0);
    body.velocity_W *= kGroundGrip;
    body.velocity_W.y() = up_m_per_s;
    body.spin_W *= kGroundGrip;
    if (up_m_per_s < kRestSpeed_m_per_s) {
        body.velocity_W.setZero();
        body.spin_W.setZero();
        body.moving = false;
    }
}

void World::move_held(RigidBody& body, double dt_s) noexcept {
    if (body.moving) {
        const Vector3 away_T = body.pose_T.position - body.resting_place_T;
        body.moving = away_T.squaredNorm() > kGlideEnd_m * kGlideEnd_m;
        body.pose_T.position =
            body.moving ? Vector3(body.resting_place_T + std::exp(-dt_s / kGlideTime_s) * away_T)
                        : body.resting_place_T;
    }
    body.pose_W = tool_WT_ * body.pose_T;
}

void World::add_event(WorldEvent::Kind kind, std::size_t index, double speed_m_per_s) noexcept {
    events_[n_events_++] = {kind, static_cast<std::int32_t>(index), snapshot_.time_s,
                            speed_m_per_s};
}

// What is seen and what is carried, after bodies have changed.
void World::describe() noexcept {
    ++revision_;
    n_moving_ = 0;
    n_held_ = 0;
    double felt_mass_kg = 0.0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const RigidBody& body = bodies_[i];
        snapshot_.bodies[i] = {body.pose_W, body.velocity_W, body.where};
        n_moving_ += body.moving ? 1U : 0U;
        if (body.where == BodyWhere::held) {
            ++n_held_;
            felt_mass_kg += body.felt_mass_kg;
        }
    }
    snapshot_.carried_force_W = felt_mass_kg * plan_.gravity_W;
}

WorldFrame World::make_frame(double stamp_s,
                             std::span<const std::int32_t> solid_bodies) const noexcept {
    WorldFrame frame;
    frame.stamp_s = stamp_s;
    frame.carried_force_W = snapshot_.carried_force_W;
    const std::size_t n = std::min<std::size_t>(solid_bodies.size(), kMaxSolids);
    for (std::size_t i = 0; i < n; ++i) {
        const std::int32_t body = solid_bodies[i];
        if (body >= 0 && static_cast<std::size_t>(body) < bodies_.size()) {
            const RigidBody& solid = bodies_[static_cast<std::size_t>(body)];
            frame.solid_poses_W[i] = solid.pose_W;
            frame.solid_placements[i] = solid.n_placements;
            if (solid.where == BodyWhere::hidden) {
                frame.solid_poses_W[i].position = kOutOfReach_W;
            }
        }
    }
    return frame;
}

}  // namespace fulcrum
