// A simulated arm at the other end of a link, all in one program and under its clock, on which things break by chance, from one seed:
// for finding what nobody thought of, and for having it again.
//
//   haptic loop -> LinkDevice -> FaultyDatagrams -> ArmServer -> simulated arm and hand
// Every few seconds one thing breaks for a while: the line, a sensor, the motor, somebody presses stop at the arm, or the program's computer
// sleeps, so that the arm goes on and the program's clock does not. Where the program's clock jumps, the arm has gone on too. The hand does
// what it likes (random_hand.h). Meanwhile it is watched that no force or torque passes the run's own limits, nor changes faster than they
// allow, and that where it must fade it is gone in kMostFade_s. The same seed and the same calls give the same bits: `hash` is over every
// place, of the handle or of the joints, and every wrench.
//
// Thread: that of the haptic loop. Cost: some microseconds a round; allocates nothing after it was built.
#pragma once

#include "haptics/device/arm/simulated_wam.h"
#include "haptics/device/device.h"
#include "haptics/device/simulated/random_hand.h"
#include "haptics/device/simulated/simulated_arm.h"
#include "haptics/link/arm_server.h"
#include "haptics/link/felt_judge.h"
#include "haptics/link/link_device.h"
#include "haptics/link/link_faults.h"
#include "haptics/link/memory_channel.h"
#include "haptics/math/split_mix.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>

namespace fulcrum {

/// Which arm it is: three axes on a desk, which turn nothing, or Barrett's WAM of seven joints, which turns the hand too.
enum class SpoiledModel : std::uint8_t { desktop, wam };
[[nodiscard]] constexpr const char* name_of(SpoiledModel model) noexcept {
    return model == SpoiledModel::wam ? "wam" : "desktop";
}

/// What breaks.
enum class Spoil : std::uint8_t {
    nothing,
    loss,
    delay,
    jitter,
    doubles,
    damage,
    cut,
    no_pose,
    no_number,
    jump,
    stuck_sensor,
    motor,
    arm_stop,
    sleep
};
inline constexpr std::size_t kSpoils = static_cast<std::size_t>(Spoil::sleep) + 1;
[[nodiscard]] constexpr const char* name_of(Spoil spoil) noexcept {
    constexpr const char* kNames[] = {
        "nothing",         "packets lost",  "a long way",      "packets late",   "packets doubled",
        "packets damaged", "cable pulled",  "no pose",         "no number",      "a jump",
        "a stuck sensor",  "motor refuses", "stop at the arm", "computer asleep"};
    static_assert(std::size(kNames) == kSpoils);
    return kNames[static_cast<std::size_t>(spoil)];
}
/// Whether the force must go while it lasts.
[[nodiscard]] constexpr bool must_fade(Spoil spoil) noexcept {
    return spoil == Spoil::cut || spoil == Spoil::no_pose || spoil == Spoil::no_number ||
           spoil == Spoil::stuck_sensor || spoil == Spoil::motor || spoil == Spoil::arm_stop;
}

/// What was seen so far.
struct SpoiledCounts {
    std::array<std::uint64_t, kSpoils> happened{};  ///< by Spoil
    std::array<std::uint64_t, kSpoils> faded{};  ///< of those that must: from a force that was felt
    std::array<std::uint64_t, kHandDeeds> deeds{};  ///< of the hand, by HandDeed
    std::uint64_t rounds = 0;
    std::uint64_t felt_rounds = 0;       ///< with a force above 0.05 N on the hand
    std::uint64_t turned_rounds = 0;     ///< with a torque above 0.005 Nm
    std::uint64_t fades = 0;             ///< of all kinds
    std::uint64_t missed_fades = 0;      ///< a force or torque was left where none may be
    std::uint64_t broken_limits = 0;     ///< rounds in which a limit was passed
    FeltLimit broken = FeltLimit::none;  ///< the first
    double peak_N = 0.0;
    double peak_Nm = 0.0;
    double force_N = 0.0;    ///< on the hand now
    double torque_Nm = 0.0;  ///< likewise
    bool may_feel =
        true;  ///< nothing is broken now that must take a force away, and the arm tells no fault
    std::uint64_t stamps_back =
        0;  ///< of the sensor: earlier than the one before. No kind of fault does that
    double quiet_s =
        0.0;  ///< for so long nothing has been broken and the hand was not too fast; else 0
    double bad_since_s = -1.0;  ///< when a limit was first broken or a fade missed; negative: never
    Spoil bad_in = Spoil::nothing;  ///< what was broken then
    std::uint64_t hash = 0;
};

/// What of a kind breaks when.
struct FirstSpoil {
    Spoil kind = Spoil::nothing;
    double at_s = 0.0;
};

class SpoiledArm final : public Device {
  public:
    /// What breaks first by this seed.
    [[nodiscard]] static FirstSpoil first_of(std::uint64_t seed) noexcept;

    static constexpr double kMostFade_s =
        0.15;  ///< 20 ms to notice, 100 ms to fade, and what a packet takes
    static constexpr double kLongestGap_s = 5.0;

    /// `target` is where the lesson's hand wants to be; it outlives the arm. `own` are the arm's own limits.
    SpoiledArm(std::uint64_t seed, LatestValue<HandTarget>& target,
               const SafetySettings& own = ArmServerSettings{}.safety,
               SpoiledModel model = SpoiledModel::desktop);
    ~SpoiledArm() override;

    [[nodiscard]] const DeviceTraits& traits() const noexcept override;
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override;
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override;

    /// Before the loop steps: the run's own limits, as its last gate has them, are told to the arm and watched.
    void keep_limits(const SafetySettings& run) noexcept;
    /// Watched alone: the least of these and the arm's own.
    void watch_limits(const SafetySettings& run) noexcept;
    [[nodiscard]] const FeltLimits& limits() const noexcept { return limits_; }

    [[nodiscard]] const SpoiledCounts& counts() const noexcept { return counts_; }
    [[nodiscard]] const LinkFaultCounts& line_counts() const noexcept;

  private:
    // In one program nothing is secret: a tag that tells damage, and anybody could make.
    class OpenSeal final : public Seal {
      public:
        [[nodiscard]] SealTag make(std::span<const std::byte> message) const noexcept override;
        [[nodiscard]] bool holds(
            std::span<const std::byte> message,
            std::span<const std::byte, kSealBytes> tag) const noexcept override;
    };
    class CountedSessions final : public SessionNumbers {
      public:
        [[nodiscard]] std::uint64_t draw() noexcept override { return ++drawn_; }

      private:
        std::uint64_t drawn_ = 0;
    };
    // The arm's own device: what breaks in it.
    class Arm final : public Device {
      public:
        Arm(SpoiledModel model, LatestValue<HandTarget>& target);
        [[nodiscard]] const DeviceTraits& traits() const noexcept override {
            return device->traits();
        }
        [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override;
        [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override;
        void take_hold(bool holds) noexcept;
        // One of the two, and what it is as a device.
        std::unique_ptr<SimulatedArm> desktop{};
        std::unique_ptr<SimulatedWam> wam{};
        Device* device = nullptr;
        Wrench written_D{};                 // last
        Vector3 handle_D{Vector3::Zero()};  // where it is, whatever the sensor says
        Spoil spoil = Spoil::nothing;
        double stamp_s = 0.0;           // told last
        std::uint64_t stamps_back = 0;  // told that were earlier than the one before
        Vector3 offset_D{Vector3::Zero()};
    };

    void move_hand(double now_s) noexcept;
    void choose(double now_s) noexcept;
    void begin(Spoil spoil, double now_s) noexcept;
    void end() noexcept;
    void sleep(double seconds) noexcept;
    void serve(double now_s) noexcept;
    // The arm's round at `served_s_`; and one in which the program has stood still for so long.
    void serve_round() noexcept;
    void serve_alone(double since_s) noexcept;
    void watch(double now_s) noexcept;
    void watch_fade(double now_s) noexcept;
    void mix_in(double now_s, const Wrench& felt_D) noexcept;
    void mix_in(const double* values, std::size_t n) noexcept;
    [[nodiscard]] bool is_gone() const noexcept;
    void blame(double now_s) noexcept;
    [[nodiscard]] double draw(double low, double high) noexcept;
    [[nodiscard]] static double draw_first(SplitMix& chance) noexcept;
    [[nodiscard]] static Spoil draw_kind(SplitMix& chance) noexcept;

    SplitMix chance_;
    LatestValue<HandTarget>& planned_;
    RandomHand hand_;
    LatestValue<HandTarget> wanted_;
    bool holds_ = true;
    SafetySettings own_;
    OpenSeal seal_;
    CountedSessions numbers_;
    Arm arm_;
    MemoryChannel channel_;
    FaultyDatagrams line_;
    ArmServer server_;
    LinkDevice device_;
    // What is broken now, and when the next thing breaks.
    Spoil spoil_ = Spoil::nothing;
    double from_s_ = 0.0;
    double guarded_s_ = -1.0;  // when the hand was too fast last
    double until_s_ = 0.0;
    double asleep_s_ = 0.0;     // in all: the arm's clock is so much ahead
    double served_s_ = 0.0;     // the arm's last round, on the program's clock
    bool felt_before_ = false;  // a force was there when it broke
    bool saw_gone_ = false;
    double watched_s_ = -0.001;  // the arm's last round, on the arm's clock
    FeltLimits limits_{};
    FeltJudge judge_{};
    Wrench felt_D_{};
    SpoiledCounts counts_{};
};

}  // namespace fulcrum
