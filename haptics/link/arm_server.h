// The arm's side of the link: serves one program at a time with any device, and trusts nobody.
//
//   take packets -> read the arm -> faults -> energy -> command, brake -> gate -> write -> state
// Whatever the program does, the force stays within this side's own limits, slew and soft start (loop/safety.h), and fades when no
// fresh command has come for command_timeout_s, when the arm tells nonsense, when the hand is too fast or given too much energy
// (loop/hand_guard.h), when a sensor is frozen or shakes (sensor_guard.h),
// and when somebody here presses stop. Where the link has given the hand more than the scene put in, the
// hand is braked and what would give it more is left out (energy_balance.h); soon after nothing is asked for, nothing brakes it.
// Command and brake together stay within the least of this side's limits and the command's, and so does how fast they change.
//
// Sessions. While nobody holds the arm, a command that names the number this side speaks under now makes its sender the holder:
// the number was drawn at random, so the command cannot be older. Others get a welcome that says taken. After lost_after_s without
// a packet, or a bye, the holder is forgotten and the number drawn anew, so that nothing of the old session counts again.
//
// Thread: `step`, `silence` on the arm's thread; `stop`, `rearm` any; `status` one other.
// Cost: a few microseconds and the device's own.
// Source: PROTOCOL.md.
#pragma once

#include "haptics/base/error.h"
#include "haptics/base/periodic_task.h"
#include "haptics/coupling/velocity_estimator.h"
#include "haptics/device/device.h"
#include "haptics/device/watched/sensor_guard.h"
#include "haptics/handover/channels.h"
#include "haptics/handover/latest_value.h"
#include "haptics/link/energy_balance.h"
#include "haptics/link/link_post.h"
#include "haptics/link/seen_way.h"
#include "haptics/loop/hand_guard.h"
#include "haptics/loop/safety.h"

#include <array>
#include <atomic>
#include <cstddef>

namespace fulcrum {

struct ArmServerSettings {
    double rate_Hz = 1000.0;  ///< of `step`, 500 to 2000
    /// The arm's own; command_timeout_s and device_timeout_s at 0.02 each as the protocol has them.
    SafetySettings safety{.max_force_N = 10.0, .max_torque_Nm = 1.0, .command_timeout_s = 0.02};
    double lost_after_s = 0.5;      ///< a holder that is silent for so long is none, 0.05 to 10
    double handle_mass_kg = 0.045;  ///< the lightest that may hang on it, 0.001 to 10
    double handle_inertia_kg_m2 = 1.0e-5;  ///< likewise, 1e-8 to 1
    bool balances_energy = true;           ///< false for tests and benchmarks alone
    EnergyBalanceSettings energy{};
    SensorLife sensor{};  ///< of the arm
    Vector3 reach_m{
        Vector3::Constant(0.2)};  ///< told to the program: half extents, 0.01 to 10 each
};

/// Refuses settings outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const ArmServerSettings& settings);

/// How the arm does, for people.
struct ArmServerStatus {
    bool held = false;
    std::uint64_t sessions = 0;
    Fault faults = Fault::none;  ///< of the last step
    GatePhase gate = GatePhase::waiting;
    Pose pose_D{};
    Wrench asked_D{};  ///< of the gate
    Wrench applied_D{};
    double round_trip_s = 0.0;
    double offset_s = 0.0;  ///< program's clock minus ours
    double excess_J = 0.0;  ///< given to the hand beyond what was put in, and not yet braked
    double peak_excess_J = 0.0;
    double peak_force_N = 0.0;
    double gone_after_s = 0.0;  ///< from the newest command until the force was zero, the last time
    std::uint64_t trips = 0;    ///< how often the force began to fade
    LinkCounts counts{};
};

class ArmServer final : public PeriodicTask {
  public:
    /// Takes settings that `validate` accepted; the others must outlive the server.
    ArmServer(const ArmServerSettings& settings, Device& arm, Datagrams& datagrams,
              const Seal& seal, SessionNumbers& numbers);
    ~ArmServer() override;

    void step(double now_s) noexcept override;
    /// The arm without force at once, and bye.
    void silence(double now_s) noexcept override;

    /// Emergency stop: the force fades and stays away until `rearm`.
    void stop() noexcept { stop_.press(); }
    void rearm() noexcept {
        stop_.release();
        rearm_wanted_.store(true, std::memory_order_release);
    }
    /// The same for a signal's handler.
    [[nodiscard]] StopSwitch& stop_switch() noexcept { return stop_; }

    /// As of the last step; for one thread.
    [[nodiscard]] const ArmServerStatus& status() noexcept {
        (void)status_.take();
        return status_.value();
    }

  private:
    void begin_round(double now_s) noexcept;
    void take_packets() noexcept;
    void take(const OpenedPacket& opened) noexcept;
    void take_command(const OpenedPacket& opened) noexcept;
    void welcome(const OpenedPacket& opened) noexcept;
    void take_stops() noexcept;
    void read_arm() noexcept;
    void forget_holder() noexcept;
    void count_energy() noexcept;
    [[nodiscard]] Wrench brake() noexcept;
    [[nodiscard]] Vector3 approach(const Vector3& torque_Nm) const noexcept;
    void drive() noexcept;
    void tell_state() noexcept;
    void publish() noexcept;

    ArmServerSettings settings_;
    Device& arm_;
    LinkPost post_;
    LinkTraits traits_{};
    SafetyGate gate_;
    HandGuard guard_;
    SensorGuard sensor_;
    VelocityEstimator velocity_;
    AngularVelocityEstimator angular_velocity_;
    StopSwitch stop_;
    std::atomic<bool> rearm_wanted_{false};
    bool lift_waits_ = false;  // it was wanted in an earlier round

    // This round.
    double now_s_ = 0.0;
    double dt_s_ = 0.0;
    bool started_ = false;
    Fault faults_ = Fault::none;
    Fault late_faults_ = Fault::none;  // found after the gate of the last round
    // The holder.
    double heard_s_ = 0.0;
    struct Greeted {
        std::uint64_t session = 0;
        double at_s = 0.0;
    };
    std::array<Greeted, 16> greeted_{};  // answered last
    std::size_t next_greeted_ = 0;
    int n_welcomes_ = 0;  // in this round
    bool has_command_ = false;
    std::uint64_t command_number_ = 0;
    double command_age_from_s_ = 0.0;  // when the newest command came, or would have as usual
    LinkCommand command_{};
    double asked_s_ = -1.0;  // when a force was asked for last
    // The arm.
    bool has_pose_ = false;
    DeviceReading reading_{};
    Vector3 motion_D_{Vector3::Zero()};  // of this round
    Vector3 turn_D_{Vector3::Zero()};
    SeenWay way_;  // of the hand
    SeenWay turn_way_;
    Wrench applied_D_{};
    EnergyBalance force_;
    EnergyBalance torque_;
    ArmServerStatus now_{};
    LatestValue<ArmServerStatus> status_;
};

}  // namespace fulcrum
