// The haptic loop: reads the hand, computes the scene's forces, writes what the last gate lets through.
//
//   take inputs -> read -> estimate -> proxy or tool -> forces -> passivity -> limits -> write -> publish
// Only the stages of the plan are built; a stage that is not in it takes no memory and no time.
// Everything that is stale, missing or not a number becomes a Fault bit, and any fault fades the force
// (safety.h).
//
// Thread: `step` and `silence` on the one haptic thread (or a virtual clock); the constructor
// before it starts.
// Cost: `step` neither allocates, locks, waits, logs nor throws; under a microsecond without a proxy.
#pragma once

#include "haptics/base/error.h"
#include "haptics/base/periodic_task.h"
#include "haptics/coupling/velocity_estimator.h"
#include "haptics/device/device.h"
#include "haptics/handover/channels.h"
#include "haptics/loop/hand_guard.h"
#include "haptics/loop/haptic_plan.h"
#include "haptics/loop/passivity_stage.h"
#include "haptics/loop/round_teller.h"
#include "haptics/loop/safety.h"
#include "haptics/loop/scene_forces.h"
#include "haptics/loop/stage_listener.h"
#include "haptics/point/proxy.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace fulcrum {

inline constexpr double kFastestRinging = 0.4;  ///< of the loop's rate: 2.5 rounds a wave

/// Refuses a plan with anything out of its range: rate, workspace, safety, estimator, weight,
/// fields, solids.
[[nodiscard]] Expected<void> validate(const HapticPlan& plan);
/// Part of it: refuses a tap that rings faster than kFastestRinging of the loop's rate.
[[nodiscard]] Expected<void> validate_ringing(const TransientSettings& tap, double rate_hz);
/// The same, and refuses a device whose steps are too coarse at the plan's scale.
[[nodiscard]] Expected<void> validate(const HapticPlan& plan, const DeviceTraits& traits);

class HapticLoop final : public PeriodicTask {
  public:
    /// Builds the stages of a plan that `validate` accepted; the proxy is a god-object when the
    /// plan has solids, or its tool. Device and channels must outlive the loop.
    HapticLoop(const HapticPlan& plan, Device& device, HapticChannels& channels);
    /// The same with a proxy of the caller's choice, or none.
    HapticLoop(const HapticPlan& plan, Device& device, HapticChannels& channels,
               std::unique_ptr<Proxy> proxy);
    ~HapticLoop() override;

    /// One round. `now_s` is the run's clock; a time that is not later than the last one is the
    /// fault command_invalid. A time that is not finite is not taken over.
    void step(double now_s) noexcept override;
    /// The same round, to the byte, telling `listener` as each stage ends.
    void step_observed(double now_s, StageListener& listener) noexcept;
    /// Zero force to the device; the next round must engage again. An emergency stop stays latched.
    void silence(double now_s) noexcept override;

    /// What was published last.
    [[nodiscard]] const HapticState& state() const noexcept { return state_; }
    /// What the device told last that was a pose.
    [[nodiscard]] const DeviceReading& told() const noexcept { return told_; }
    /// Whether the last round left it stopped, with no force at the device.
    [[nodiscard]] bool is_still() const noexcept { return is_still_; }
    /// For how long it was asked for something to be felt, and what became of it.
    [[nodiscard]] const FeltTime& felt_time() const noexcept { return teller_->felt_time(); }
    /// What may add to the force, in the order of the shares that are told.
    [[nodiscard]] const std::vector<EffectSlot>& effects() const noexcept {
        return teller_->effects();
    }
    /// The last gate's limits: the plan's, and no more than the device can give.
    [[nodiscard]] double max_force_N() const noexcept { return gate_.max_force_N(); }
    [[nodiscard]] double max_torque_Nm() const noexcept { return gate_.max_torque_Nm(); }
    /// What a thread has to run beside the rounds, or whoever calls them after each (beside_thread.h); null where they do all. Lives as
    /// long as the loop.
    [[nodiscard]] BesideTask* beside() const noexcept {
        return scene_.tool() != nullptr ? scene_.tool()->beside() : nullptr;
    }
    /// From now on told when a step of the tool does itself what could run beside. Before the first round.
    void listen_to_rounds(RoundListener* listener) noexcept {
        if (scene_.tool() != nullptr) {
            scene_.tool()->listen_to_rounds(listener);
        }
    }
    /// How old what it told was, of each round with a tool in use; null without one.
    [[nodiscard]] const ContactLateness* contact_lateness() const noexcept {
        return scene_.tool() != nullptr ? scene_.tool()->lateness() : nullptr;
    }
    /// The stages that exist, in the order of the step.
    [[nodiscard]] std::vector<StageInfo> stages() const;

  private:
    template <class Passed>
    void run_round(double now_s, Passed passed) noexcept;
    void begin_round(double now_s) noexcept;
    void take_inputs() noexcept;
    void take_stop() noexcept;
    void read_device() noexcept;
    void estimate_motion() noexcept;
    void watch_hand() noexcept;
    [[nodiscard]] SceneRound make_scene_round() noexcept;
    void keep_passive() noexcept;
    void limit_forces() noexcept;
    void write_device() noexcept;

    [[nodiscard]] bool accept(const DeviceReading& reading) noexcept;
    void forget_motion() noexcept;

    // Fixed by the plan.
    HapticPlan plan_;
    Device& device_;
    HapticChannels& channels_;

    // Stages; those not in the plan are empty.
    VelocityEstimator velocity_;
    AngularVelocityEstimator angular_velocity_;
    SceneForces scene_;
    std::unique_ptr<PassivityStage> passivity_;
    SafetyGate gate_;
    HandGuard guard_;
    std::optional<RoundTeller> teller_;  // of those, so made behind them

    // Begin: time of this round.
    double now_s_ = 0.0;
    double dt_s_ = 0.0;
    bool started_ = false;
    // Take inputs: what was heard last.
    bool heard_lesson_ = false;
    bool heard_world_ = false;
    bool lift_waits_ = false;          // a stop's lifting was asked for in an earlier round
    Fault late_faults_ = Fault::none;  // found after the gate of the last round
    bool is_still_ = false;
    // Read: the newest good pose, and the newest that the device told, for the record.
    DeviceReading reading_{};
    DeviceReading told_{};
    bool has_pose_ = false;
    bool has_new_pose_ = false;        // in this round
    bool is_reading_ = true;           // whether what the device gave in it was one
    Fault told_faults_ = Fault::none;  // what the device told beside it
    Pose watched_D_{};                 // the hand's, when it was watched last
    // Limits.
    Wrench applied_D_{};
    HapticState state_{};
};

}  // namespace fulcrum
