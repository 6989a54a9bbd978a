// The bodies of a scene: they fall, are caught by the bucket in the hand, ride in it, and land.
//
//   v <- (v + dt g) / (1 + dt c |v|),  c = rho C_d A / 2m;  x <- x + dt v          (semi-implicit
//   Euler) The drag -c |v| v is taken at the new velocity and the old speed, so any dt is stable
//   and the terminal speed sqrt(|g| / c) is met exactly. R <- exp(omega dt) R, a gentle constant
//   spin. Catching: in the rim's frame, which moves with the tool, the centre goes from a to b in
//   one step. It is caught when a_y >= 0 > b_y and at a_y / (a_y - b_y) of the way it lies within
//   the opening's radius less a margin. So neither a fast body nor a fast bucket is missed. A
//   caught body glides to its place in the bucket, z <- z e^(-dt / T), and rides. Landing: where
//   the centre would pass the ground plus its radius; it bounces weakly and comes to rest.
//   carried_force_W = sum over held bodies of felt mass times gravity, from the moment of the
//   catch.
// Thread: the world loop. Cost: bounded by the bodies that move; nothing falling costs a few
// nanoseconds a held body. No allocation after construction. Source: E. Hairer, C. Lubich, G.
// Wanner 2006, Geometric Numerical Integration, chapter I.1 (symplectic Euler); the linearly
// implicit drag and the swept test are derived above.
#pragma once

#include "haptics/base/error.h"
#include "haptics/dynamics/catcher.h"
#include "haptics/dynamics/rigid_body.h"
#include "haptics/dynamics/world_plan.h"
#include "haptics/handover/messages.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

/// Refuses a plan with anything out of its range: rate, masses, radii, catcher, more than
/// kMaxBodies.
[[nodiscard]] Expected<void> validate(const WorldPlan& plan);

class World {
  public:
    /// Takes a plan that `validate` accepted. All bodies are hidden.
    explicit World(const WorldPlan& plan);

    /// Does what the lesson asked; a command that names no body or holds no finite numbers is
    /// ignored and counted.
    void apply(const WorldCommand& command) noexcept;
    /// Moves everything on by `dt_s`, to where the tool is `tool`. A dt that is not positive and
    /// finite, or a tool pose that is not finite, moves nothing that depends on it.
    void step(double dt_s, const HapticState& tool) noexcept;
    /// All bodies hidden, time zero.
    void reset() noexcept;

    /// What the picture and the lesson see; valid until the next call.
    [[nodiscard]] const WorldSnapshot& snapshot() const noexcept { return snapshot_; }
    /// What the haptic loop needs, stamped `stamp_s` seconds of the run's clock. Solids keep
    /// `solid_bodies`' poses: entry i is the pose of the scene's body solid_bodies[i].
    [[nodiscard]] WorldFrame make_frame(double stamp_s,
                                        std::span<const std::int32_t> solid_bodies) const noexcept;
    /// What happened in the last `step`, in the order of the bodies.
    [[nodiscard]] std::span<const WorldEvent> events() const noexcept {
        return {events_.data(), n_events_};
    }
    /// How many commands were ignored so far.
    [[nodiscard]] std::uint64_t ignored_commands() const noexcept { return ignored_commands_; }
    /// True when nothing falls, glides or bounces: a step then costs next to nothing.
    [[nodiscard]] bool is_at_rest() const noexcept { return n_moving_ == 0; }

  private:
    void place_body(std::int32_t body, const WorldCommand& command) noexcept;
    void hold_body(std::int32_t body, const Pose& pose_T) noexcept;
    void move_falling(std::size_t body, double dt_s, const Pose& tool_before_WT,
                      const Pose& tool_WT) noexcept;
    void move_landed(std::size_t body, double dt_s) noexcept;
    void move_held(std::size_t body, double dt_s, const Pose& tool_WT) noexcept;
    void settle(std::size_t body, double impact_m_per_s) noexcept;
    void add_event(WorldEvent::Kind kind, std::size_t body, double speed_m_per_s) noexcept;
    void count_load() noexcept;

    WorldPlan plan_;
    std::vector<RigidBody> bodies_;
    Catcher catcher_;
    Pose tool_WT_{};  // of the last step
    bool has_tool_ = false;
    std::size_t n_moving_ = 0;
    std::uint64_t ignored_commands_ = 0;
    std::uint32_t n_drops_ = 0;
    std::array<WorldEvent, 2 * kMaxBodies> events_{};
    std::size_t n_events_ = 0;
    WorldSnapshot snapshot_{};
};

}  // namespace fulcrum
