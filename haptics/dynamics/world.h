// The bodies of a scene: they fall, are caught by the bucket in the hand, ride in it, and land.
//
//   v <- (v + dt g) / (1 + dt c |v|),  c = rho C_d A / 2m;   x <- x + dt v     (semi-implicit Euler)
//     The drag -c |v| v is taken at the new velocity and the old speed, so any dt is stable and the
//     terminal speed sqrt(|g| / c) is met exactly. R <- exp(omega dt) R, a gentle constant spin.
//   Catching: in the rim's frame, which moves with the tool, the centre goes from a to b in one step.
//     It is caught when a_y >= 0 > b_y and, a_y / (a_y - b_y) of the way, lies within the opening's
//     radius less a margin: neither a fast body nor a fast bucket is missed. A caught body glides to
//     its place in the bucket, z <- z e^(-dt / T), and rides.
//   Landing: where the centre would pass the ground plus its radius; it bounces weakly, then rests.
//   carried_force_W = sum over held bodies of felt mass times gravity, from the moment of the catch.
//
// Thread: the world loop. No allocation after construction.
// Cost: bounded by the bodies that move; nothing falling and nothing held costs a comparison.
// Source: E. Hairer, C. Lubich, G. Wanner 2006, Geometric Numerical Integration, chapter I (symplectic
// Euler); the linearly implicit drag and the swept test are derived above.
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
    /// finite moves nothing; a tool pose that is not finite leaves the tool where it was. The tool
    /// is turned like the hand and stands where the proxy is, as it is seen.
    void step(double dt_s, const HapticState& tool) noexcept;
    /// Puts the world's clock to `time_s` of the run's clock; `step` adds its dt to it.
    void set_time(double time_s) noexcept { snapshot_.time_s = time_s; }

    /// What the picture and the lesson see; valid until the next call.
    [[nodiscard]] const WorldSnapshot& snapshot() const noexcept { return snapshot_; }
    /// Grows whenever a body or what is carried may have changed, and so never while all rest; begins above 0. The
    /// clock's going on is no change.
    [[nodiscard]] std::uint64_t revision() const noexcept { return revision_; }
    /// What the haptic loop needs, stamped `stamp_s` seconds of the run's clock. Solids keep
    /// `solid_bodies`' poses: entry i is the pose of the scene's body solid_bodies[i], which a
    /// `place` command has put there; a hidden one is out of every hand's reach.
    [[nodiscard]] WorldFrame make_frame(double stamp_s,
                                        std::span<const std::int32_t> solid_bodies) const noexcept;
    /// What happened in the last `step`, in the order of the bodies.
    [[nodiscard]] std::span<const WorldEvent> events() const noexcept {
        return {events_.data(), n_events_};
    }
    /// How many commands were ignored so far.
    [[nodiscard]] std::uint64_t ignored_commands() const noexcept { return ignored_commands_; }
    /// True when nothing falls, glides or bounces: unless something is held, a step costs next to nothing then.
    [[nodiscard]] bool is_at_rest() const noexcept { return n_moving_ == 0; }
    /// How many bodies lie in the tool.
    [[nodiscard]] std::size_t n_held() const noexcept { return n_held_; }

  private:
    [[nodiscard]] bool is_full() const noexcept;
    [[nodiscard]] bool is_usable(const WorldCommand& command) const noexcept;
    Pose take_tool(const HapticState& tool) noexcept;
    void move_bodies(double dt_s, const Pose& tool_before_WT) noexcept;
    void free_body(RigidBody& body, const WorldCommand& command) noexcept;
    void hold_body(RigidBody& body) noexcept;
    void move_falling(std::size_t index, double dt_s, const Pose& tool_before_WT) noexcept;
    void move_landed(RigidBody& body, double dt_s) noexcept;
    void move_held(RigidBody& body, double dt_s) noexcept;
    void bounce(RigidBody& body) noexcept;
    void add_event(WorldEvent::Kind kind, std::size_t index, double speed_m_per_s) noexcept;
    void describe() noexcept;

    WorldPlan plan_;
    std::vector<RigidBody> bodies_;
    Catcher catcher_;
    Pose tool_WT_{};  // of the last step
    bool has_tool_ = false;
    std::size_t n_moving_ = 0;
    std::size_t n_held_ = 0;
    std::uint64_t ignored_commands_ = 0;
    std::uint32_t n_drops_ = 0;
    std::array<WorldEvent, kMaxBodies> events_{};  // a body has at most one a step
    std::size_t n_events_ = 0;
    std::uint64_t revision_ = 0;  // of the snapshot but for its time
    WorldSnapshot snapshot_{};
};

}  // namespace fulcrum
