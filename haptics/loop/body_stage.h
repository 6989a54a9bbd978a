// The haptic side of rigid bodies: where they are now, and how the hand pushes them.
//
//   p(t) = p + v r (t - stamp) + w(t) e      as the world's newest frame tells it, moved on by its velocity and the rate r of its time
//   e    = what was felt before that frame came, less what the frame tells;   w falls from 1 to 0 within the time between two frames,
//          or in what was left of it before, where that is longer: what a world that paused has to correct is not hurried by its next frame
// So what is felt moves without leaps and the loop never waits, however seldom the world speaks. What the hand does to a body goes to the
// world as a force at a place, with its slopes, its bounds, and how the hand took the body to be: the world knows it better, and takes the
// push as the hand would have given it there (rigid_loop.h), with the virtual mass that keeps its own steps stable (hand_rows.h). Touch and
// grip together push with no more than the hand may feel.
//
// A grip, while its button is pressed, holds the place of the surface that the cursor touched:
//   F_hand = k (a - x_hand) + b (v_a - v_hand)        a: that place on the body; k, b: the coupling of the solid
//   M_body = k_r log(q_hand q_0 q_body^-1) + b_r (w_hand - w_body)     keeps it turned as it was; k_r = k I / m, b_r = 2 sqrt(k_r I)
// so that the grip begins with the force of the touch. The proxy lets go of a body that is gripped. With a hand that feels no torque M_body
// is given to the body alone, at most what the hand may feel at the arm r = sqrt(I / m), for k_r = k r^2, and no more of it than is left of
// the force: a hand that may feel nothing turns nothing. A push that is cut off has the slopes of its secant. A grip ends with its button,
// when its body is put elsewhere or taken out, and when the hand's motion begins anew; a closed gate holds nothing.
//
// What is held all the time, a bucket, is gripped by its origin and turned as the hand is, with as much force as the hand may ever feel, also
// while the gate is shut: then the hand feels nothing of it. Where the hand's motion begins it is put there at once, with all that lies in it left behind:
// not where a reading alone jumps to, nor before there is one, and again where the hand's motion began anew before the world had answered.
//
// Thread: haptic loop. Cost: 60 ns a body, and the copy of the pushes. No allocation in a step.
// Source: a prediction by the newest velocity as in dead reckoning (IEEE 1278.1, distributed simulation); k_r gives turning the period of
// moving.
#pragma once

#include "haptics/handover/rigid_messages.h"
#include "haptics/loop/haptic_plan.h"
#include "haptics/loop/solid_push.h"

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace fulcrum {

/// The hand in one round.
struct GrippingHand {
    Pose pose_W{};
    Twist twist_W{};
    std::uint32_t buttons = 0;
    bool feels = true;     ///< the gate lets something through
    bool is_there = true;  ///< its place is known, and no jump
};

/// What a grip gives it.
struct GripForce {
    Vector3 force_W{Vector3::Zero()};
    Vector3 spring_W{Vector3::Zero()};  ///< its spring's part
};

class BodyStage {
  public:
    /// Takes a plan that `validate` accepted. `channels` may be null: then bodies stay where they began.
    BodyStage(const HapticPlan& plan, RigidChannels* channels);

    /// First in a round: the poses of all solids, those of rigid bodies as told and moved on to `now_s`. Valid until the next call.
    [[nodiscard]] std::span<const Pose> place(std::span<const Pose> poses_W, double now_s) noexcept;
    /// Bit i: solid i was put elsewhere at once, in the last `place`, or is gripped: nothing touches it.
    [[nodiscard]] std::uint32_t put() const noexcept { return put_; }
    /// How far the stamp of the world's newest frame is from now, before it or after; infinite before the first, 0 without channels.
    [[nodiscard]] double age_s(double now_s) const noexcept;

    /// Then, when the contact is known: what a grip gives the hand.
    [[nodiscard]] GripForce grip(const ProxyContact& contact, const GrippingHand& hand) noexcept;
    /// Ends it; what is held all the time is put to the hand again.
    void let_go() noexcept {
        grip_ = {};
        putting_ = putting_ == Putting::asked || putting_ == Putting::asked_elsewhere
                       ? Putting::asked_elsewhere
                       : Putting::wanted;
    }
    /// Last: tells the world how the hand pushes, with a point, or with a tool: one push a solid of the plan.
    void push(const ProxyContact& contact, const HandPush& hand, double now_s) noexcept;
    void push_by_tool(std::span<const SolidPush> pushes, const MostFelt& most,
                      double now_s) noexcept;

    /// Of the solid that is gripped; kNoBody where none is.
    [[nodiscard]] std::int32_t gripped() const noexcept {
        return held_ == kNothingHeld ? grip_.solid : kNoBody;
    }
    /// Where that is which is held all the time; none where there is no such, or it is not in the hand yet.
    [[nodiscard]] const Pose* held_pose_W() const noexcept {
        return held_ != kNothingHeld && grip_.solid >= 0 ? &poses_W_[bodies_[held_].plan.solid]
                                                         : nullptr;
    }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    struct Body {
        RigidSolidPlan plan{};
        PushSlopes slopes{};    // of a touch
        double friction = 0.0;  // static
        RigidSolid told{};
        Vector3 shift_W{Vector3::Zero()};  // e
        Vector3 turn_W{Vector3::Zero()};
        Twist velocity_W{};
        bool is_known = false;
    };
    struct Grip {
        std::int32_t solid = kNoBody;
        std::size_t body = 0;
        Vector3 place_B{Vector3::Zero()};
        Quaternion turn_TB{Quaternion::Identity()};  // of the body in the hand, as it was
        GripForce force{};
        BodyHold hold{};
        bool holds = false;  // in this round
    };
    // Of what is held all the time, to the hand: the world answers by a placement.
    enum class Putting : std::uint8_t { done, wanted, asked, asked_elsewhere };
    [[nodiscard]] Pose predict(const RigidSolid& told, double now_s) const noexcept;
    [[nodiscard]] Pose find_pose(const Body& body, double now_s, double left_s) const noexcept;
    [[nodiscard]] double find_left_s(double now_s) const noexcept;
    [[nodiscard]] bool is_usable(const RigidFrame& frame) const noexcept;
    void take_frame(double now_s) noexcept;
    void tell_put() noexcept;
    void tell_grip(double most_N) noexcept;
    void hold_on(const GrippingHand& hand) noexcept;
    void feel_grip(const GrippingHand& hand) noexcept;
    void begin_grip(const ProxyContact& contact, const GrippingHand& hand) noexcept;
    void begin_pushes(double now_s) noexcept;
    BodyHold& add_hold(const Body& body) noexcept;
    void add_push(const Body& body, const MostFelt& most, SolidPush push) noexcept;
    void publish() noexcept;

    RigidChannels* channels_;
    double period_s_;
    double cursor_m_;        // from the proxy to where it touches
    double stamp_s_ = -1.0;  // of the newest frame
    double rate_ = 1.0;      // of the world's time in it
    double heard_s_ = 0.0;   // when it came
    double blend_s_ = 0.0;   // within which e goes
    std::vector<Body> bodies_;
    std::array<Pose, kMaxSolids> poses_W_{};
    std::uint32_t put_ = 0;
    static constexpr std::size_t kNothingHeld = SIZE_MAX;
    std::size_t held_ = kNothingHeld;  // all the time
    double most_held_N_ = 0.0;
    Putting putting_ = Putting::wanted;
    GrippingHand hand_{};  // in this round
    Grip grip_{};
    HandPushes pushes_{};
};

/// Refuses solids that there are not, or twice, or on an axle too, and masses and moments that are not above 0.
[[nodiscard]] Expected<void> validate_rigid(const HapticPlan& plan);

/// Null where no solid is a rigid body.
[[nodiscard]] std::unique_ptr<BodyStage> make_body_stage(const HapticPlan& plan,
                                                         RigidChannels* channels);

}  // namespace fulcrum
