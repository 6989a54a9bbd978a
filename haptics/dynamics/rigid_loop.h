// The round of a world of rigid bodies: takes the lesson's commands and the hands' pushes, steps the world, tells all how bodies are.
//
// It runs beside the haptic loops, of which there may be several, and none waits for it: each reads the newest frame and moves it on
// (body_stage.h). So a hand knows a body as it was a step and its computing time ago. The world knows it better, and takes the push as the
// hand's spring and damper would have given it there:
//   F = F_told - k (x - x_told) - b (v - v_told)      couples alike with angles
// x and v where the world has the body as its step begins; what the body does in the step the rows of the hand answer, which also keep it
// within what the hand may feel, and a push from drawing (hand_rows.h). So a push may be as old as the step, or a hand stall and go on with
// its last one: it gives no more than its spring held, and nothing after kStalePush_s. A push turns with no more than the couple that it
// told, and never the other way.
// A body has landed when it touches something after it touched nothing for a while.
// Where a hand holds a carrier, a bucket, those are carried that lie on it or on what is carried, and touch nothing that stays; one that has been
// carried for kCaught_s is caught, and is not again before it was not carried for
// as long and touches what stays, or for kLost_s.
//
// Thread: `step` on one thread beside the haptic ones (or a virtual clock). Cost: that of RigidWorld::step, and one copy of the snapshot and
// of each hand's frame. No allocation after construction.
#pragma once

#include "haptics/base/periodic_task.h"
#include "haptics/dynamics/rigid_loop_plan.h"
#include "haptics/dynamics/rigid_world.h"
#include "haptics/handover/channels.h"
#include "haptics/handover/rigid_messages.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace fulcrum {

/// A step is at least so long: what comes sooner is gathered.
inline constexpr double kShortestRigidStep_s = 1.0e-4;
/// A hand that has said nothing for so long, or speaks of a time so far ahead, pushes nothing.
inline constexpr double kStalePush_s = 0.1;
/// A body that touches after it touched nothing for so long has landed.
inline constexpr double kLeastFlight_s = 0.08;

/// What the carrier has carried for so long is caught.
inline constexpr double kCaught_s = 0.1;
/// And so long it may be in the air and still be: from the bottom of a bucket of 15 cm to its rim and back.
inline constexpr double kLost_s = 0.35;

class RigidLoop final : public PeriodicTask {
  public:
    /// Refuses what `validate` does. Of `lesson` commands are taken, place, drop and hide, the snapshot and events are told: null where nobody
    /// listens. One channel a hand. All outlive the loop.
    [[nodiscard]] static Expected<std::unique_ptr<RigidLoop>> create(
        const RigidLoopPlan& plan, WorldChannels* lesson, std::span<RigidChannels* const> hands);
    ~RigidLoop() override;

    /// One round at `now_s` of the run's clock. The world moves by the time since it last moved, kShortestRigidStep_s to kLongestRigidStep_s;
    /// where less has passed, or the clock goes backwards, it stands still. A time that is not finite is no round.
    void step(double now_s) noexcept override;
    /// Bodies have no force of their own: nothing is left to silence.
    void silence(double now_s) noexcept override;

    /// For the loop's own thread.
    [[nodiscard]] const RigidWorld& world() const noexcept { return *world_; }

  private:
    struct Told {
        std::int32_t scene_body = kNoBody;
        std::uint32_t n_placements = 0;
        bool is_present = true;
        bool is_held = false;  // gripped by a hand
        bool touches = false;  // anything, in this step
        bool stays = false;
        bool is_stopped = false;    // it touches what stays
        bool meets_caught = false;  // it touches the carrier, or what is caught in it
        bool is_carried = false;    // by the carrier
        bool is_caught = false;     // and was for a while
        double changing_s =
            0.0;  // for how long it has been carried and not caught, or the other way round
        double caught_m_per_s = 0.0;  // its speed when it came into the carrier
        double in_air_s = 0.0;        // for how long it has touched nothing
        double speed_m_per_s = 0.0;   // before this step
        double earlier_speed_m_per_s =
            0.0;  // before the last one, which may have ended at the touch
    };
    RigidLoop(const RigidLoopPlan& plan, std::unique_ptr<RigidWorld> world, WorldChannels* lesson,
              std::span<RigidChannels* const> hands);
    void take_commands() noexcept;
    void apply(const WorldCommand& command) noexcept;
    void take_pushes(double now_s) noexcept;
    void take_push(const RigidPush& push) noexcept;
    [[nodiscard]] std::int32_t body_of_solid(std::int32_t solid) const noexcept;
    [[nodiscard]] Wrench find_push_W(const RigidPush& push, const Vector3& at_W) const noexcept;
    /// Whether the pair's first body lies on the second, or the second on the first.
    [[nodiscard]] bool bears(const ContactPair& pair, bool is_second) const noexcept;
    void find_touching() noexcept;
    void find_carried() noexcept;
    void notice_catches(double now_s, double dt_s) noexcept;
    void notice_landings(double now_s, double dt_s) noexcept;
    void put(std::int32_t body, const Pose& shape_W, const Twist& velocity_W) noexcept;
    void hide_carried() noexcept;
    void tell_hands(double now_s) noexcept;
    void tell_lesson(double now_s) noexcept;
    [[nodiscard]] Twist velocity_W(std::int32_t body) const noexcept;

    std::unique_ptr<RigidWorld> world_;
    double period_s_;
    std::vector<Told> told_;                   // one a body of the world
    std::vector<std::int32_t> body_of_scene_;  // kMaxBodies
    std::vector<std::int32_t> solids_;
    std::int32_t carrier_;
    Vector3 up_W_;  // zero where nothing is heavy
    WorldChannels* lesson_;
    std::vector<RigidChannels*> hands_;
    RigidFrame frame_{};
    WorldSnapshot snapshot_{};
    bool started_ = false;
    double now_s_ = 0.0;
    double due_s_ = 0.0;     // time that the world has not moved by
    double passed_s_ = 0.0;  // in which that came together
};

}  // namespace fulcrum
