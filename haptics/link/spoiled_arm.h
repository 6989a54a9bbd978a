// A simulated arm at the other end of a link, all in one program and under its clock, on which things break by chance, from one seed:
// for finding what nobody thought of, and for having it again.
//
//   haptic loop -> LinkDevice -> FaultyDatagrams -> ArmServer -> simulated arm and hand
// Every few seconds one thing breaks for a while: the line, a sensor, the motor, somebody presses stop at the arm, or the program's computer
// sleeps, so that the arm goes on and the program's clock does not. Where the program's clock jumps, the arm has gone on too. Meanwhile it is
// watched that no force passes the limit nor jumps, and that where the force must fade it is gone in kMostFade_s. The same seed and the
// same calls give the same bits: `hash` is over every pose and force.
//
// Thread: that of the haptic loop. Cost: some microseconds a round; allocates nothing after it was built.
#pragma once

#include "haptics/device/device.h"
#include "haptics/device/simulated/simulated_arm.h"
#include "haptics/link/arm_server.h"
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
    std::uint64_t rounds = 0;
    std::uint64_t felt_rounds = 0;   ///< with a force above 0.05 N on the hand
    std::uint64_t fades = 0;         ///< seen where they had to be, from a force above 0.05 N
    std::uint64_t missed_fades = 0;  ///< a force was left where none may be
    std::uint64_t broken_limits =
        0;  ///< rounds with more force than allowed, or a change faster than the slew
    double peak_N = 0.0;
    double force_N = 0.0;       ///< on the hand now
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

    /// `target` is where the hand wants to be; it outlives the arm.
    SpoiledArm(std::uint64_t seed, LatestValue<HandTarget>& target);
    ~SpoiledArm() override;

    [[nodiscard]] const DeviceTraits& traits() const noexcept override;
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override;
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override;

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
        Arm(const SimulatedArmSettings& settings, LatestValue<HandTarget>& target)
            : arm(settings, target) {}
        [[nodiscard]] const DeviceTraits& traits() const noexcept override { return arm.traits(); }
        [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override;
        [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override;
        SimulatedArm arm;
        Spoil spoil = Spoil::nothing;
        double since_s = 0.0;
        Vector3 offset_D{Vector3::Zero()};
    };

    void choose(double now_s) noexcept;
    void begin(Spoil spoil, double now_s) noexcept;
    void end() noexcept;
    void sleep(double seconds) noexcept;
    void serve(double now_s) noexcept;
    // The arm's round at `served_s_`; and one in which the program has stood still for so long.
    void serve_round() noexcept;
    void serve_alone(double since_s) noexcept;
    void watch(double now_s) noexcept;
    void blame(double now_s) noexcept;
    [[nodiscard]] double draw(double low, double high) noexcept;
    [[nodiscard]] static double draw_first(SplitMix& chance) noexcept;
    [[nodiscard]] static Spoil draw_kind(SplitMix& chance) noexcept;

    SplitMix chance_;
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
    double until_s_ = 0.0;
    double asleep_s_ = 0.0;     // in all: the arm's clock is so much ahead
    double served_s_ = 0.0;     // the arm's last round, on the program's clock
    bool felt_before_ = false;  // a force was there when it broke
    bool saw_gone_ = false;
    Vector3 force_D_{Vector3::Zero()};
    SpoiledCounts counts_{};
};

}  // namespace fulcrum
