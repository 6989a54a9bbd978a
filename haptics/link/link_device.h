// An arm on another computer, as the haptic loop knows any device: its poses come by datagrams, wrenches go by datagrams.
//
//   unlinked   hello every kHelloEvery_s until an arm says welcome
//   linked     every read takes what has come and gives the newest pose; every write sends a command
//   lost       nothing for lost_after_s: another session, from the beginning
// A pose's stamp is when it would have arrived as usual: an even delay makes no pose stale, for it does not grow older than that;
// what comes late does, and so does silence, and the loop's own timeout fades the force. A delay is made safe by
// energy_balance.h, here on the scene's side: where the scene would take more than the hand has put in, its hand is moved aside
// (the shift), and moved back as soon as that costs nothing. Round trips above most_round_trip_s give no pose at all.
//
// Thread: haptic thread; `status` any. Cost: a few microseconds a round: two system calls, two tags.
// Source: PROTOCOL.md; link_post.h, energy_balance.h.
#pragma once

#include "haptics/base/error.h"
#include "haptics/device/device.h"
#include "haptics/handover/latest_value.h"
#include "haptics/link/energy_balance.h"
#include "haptics/link/link_post.h"
#include "haptics/loop/haptic_plan.h"

#include <atomic>

namespace fulcrum {

struct LinkDeviceSettings {
    double max_force_N = 5.0;         ///< told to the arm, 0.5 to 10
    double max_torque_Nm = 0.3;       ///< likewise, 0 to 1
    double max_slew_N_per_s = 500.0;  ///< likewise, 10 to 5000
    double lost_after_s = 0.5;        ///< silence after which the link begins anew, 0.05 to 10
    double most_round_trip_s = 0.25;  ///< 0.001 to 1
    double return_m_per_s = 0.1;      ///< how fast a shift goes back in free space, 0.001 to 1
    bool balances_energy = true;      ///< false for tests and benchmarks alone
    EnergyBalanceSettings energy{};
};

/// Refuses settings outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const LinkDeviceSettings& settings);

/// How the link does, for people.
struct LinkStatus {
    bool linked = false;
    bool taken = false;         ///< an arm answers, and another program holds it
    bool changed = false;       ///< another arm answers than the one that the run began with
    double offset_s = 0.0;      ///< arm's clock minus ours
    double round_trip_s = 0.0;  ///< the least of the last seconds
    double newest_round_trip_s = 0.0;
    bool too_long =
        false;  ///< the newest round trips have been above most_round_trip_s for kWayFor_s
    double shift_m = 0.0;        ///< how far the scene's hand is moved aside now
    double peak_excess_J = 0.0;  ///< most that the link gave out here beyond what was put in
    std::uint64_t sessions = 0;  ///< how often a link was made
    Fault arm_faults = Fault::none;
    GatePhase arm_gate = GatePhase::waiting;
    LinkCounts counts{};
};

class LinkDevice final : public Device {
  public:
    static constexpr double kHelloEvery_s = 0.05;
    static constexpr double kWayFor_s =
        0.5;  ///< a way is called long, or is not any more, after so long
    static constexpr double kSendEvery_s = 0.45e-3;  ///< at most 2 kHz, whatever the loop's rate

    /// Takes settings that `validate` accepted; the others must outlive the device.
    LinkDevice(const LinkDeviceSettings& settings, Datagrams& datagrams, const Seal& seal,
               SessionNumbers& numbers);
    /// Says bye.
    ~LinkDevice() override;

    /// Load path, before the loop runs: takes what has come and says hello; true once an arm has said welcome, and `traits` are true.
    [[nodiscard]] bool greet(double now_s);

    /// Before the loop steps: what the run lets through, told to the arm from now on.
    void tell_limits(const SafetySettings& run) noexcept;

    /// Says bye and begins anew; the clock of the calls may begin anew as well.
    void part() noexcept;

    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return traits_; }
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override;
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override;

    /// As of the last read; for one thread.
    [[nodiscard]] LinkStatus status() noexcept {
        (void)status_.take();
        return status_.value();
    }

  private:
    void take_packets(double now_s) noexcept;
    void take(double now_s, const OpenedPacket& opened) noexcept;
    void take_state(double now_s, const LinkState& state) noexcept;
    [[nodiscard]] bool follows_lost_row(const PacketHead& head) const noexcept;
    void take_welcome(double now_s, const OpenedPacket& opened) noexcept;
    void say_hello(double now_s) noexcept;
    void begin_link() noexcept;
    [[nodiscard]] Fault find_shut_gate(double now_s) noexcept;
    void balance(double now_s) noexcept;
    void shift_hand(double dt_s) noexcept;
    void watch_way(double now_s) noexcept;
    void publish() noexcept;

    LinkDeviceSettings settings_;
    LinkPost post_;
    DeviceTraits traits_{};
    LinkTraits arm_{};
    bool knows_arm_ = false;
    // Of this link.
    PeerAddress arm_address_{};
    double said_hello_s_ = -1.0;
    double heard_s_ = 0.0;
    bool has_state_ = false;
    std::uint64_t state_number_ = 0;
    std::int64_t state_sent_ns_ = 0;  // arm's clock
    bool lost_row_ = false;           // too many states in a row, before one of this round
    LinkState state_{};
    std::int64_t moved_ns_ = 0;  // when its place was last another, or it did not say that it moves
    double stamp_s_ = 0.0;       // of the state, on the run's clock
    double way_since_s_ = 0.0;   // it is as too_long says
    double shut_since_s_ = 0.0;  // the arm's gate, although a force is asked for
    // What crossed it.
    double sent_s_ = -1.0;
    bool counts_motion_ = false;
    Pose counted_D_{};  // pose up to which energy is counted
    double counted_s_ = 0.0;
    Wrench sent_D_{};
    EnergyBalance force_;
    EnergyBalance torque_;
    Vector3 shift_D_{Vector3::Zero()};
    Vector3 turn_D_{Vector3::Zero()};
    LinkStatus now_{};
    LatestValue<LinkStatus> status_;
};

}  // namespace fulcrum
