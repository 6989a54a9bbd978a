// Judges, round by round, whether what a hand was given kept the limits: from what was asked for, what was given and the gate's phase alone,
// with arithmetic of its own, so that a gate that is wrong is found.
//
//   always    |f| and |torque| below their limits; a torque changes no faster than its slew
//   open      b goes towards what was asked for, within the force's limit, as fast as the slew lets it; t = f - b:
//             |t|, I and Q (safety.h) below theirs
//   else      |f_k - f_(k-1)| <= slew dt + |t_(k-1)|: what was beyond b may end at once, and nothing comes beyond it
//
// Thread: any one. Cost: some 50 ns a round; allocates nothing.
#pragma once

#include "haptics/loop/safety.h"

#include <cstdint>
#include <iterator>

namespace fulcrum {

/// What the hand may feel.
struct FeltLimits {
    double force_N = kHardForceCap_N;
    double torque_Nm = kHardTorqueCap_Nm;
    double slew_N_per_s = SafetySettings{}.max_slew_N_per_s;
    double slew_Nm_per_s = SafetySettings{}.max_slew_N_per_s;
    double transient_N = SafetySettings{}.max_transient_N;  ///< beyond what obeys the slew ...
    double transient_Ns = SafetySettings{}.transient_Ns;    ///< ... its impulse ...
    double transient_N2s = SafetySettings{}.transient_N2s;  ///< ... and the integral of its square
};

/// What a gate with these settings lets through.
[[nodiscard]] FeltLimits felt_limits(const SafetySettings& gate) noexcept;
/// The least of both, of each.
[[nodiscard]] FeltLimits least_of(const FeltLimits& one, const FeltLimits& other) noexcept;

/// Which of them was passed.
enum class FeltLimit : std::uint8_t {
    none,
    force,
    slew,
    torque,
    torque_slew,
    transient,
    impulse,
    ringing
};
[[nodiscard]] constexpr const char* name_of(FeltLimit limit) noexcept {
    constexpr const char* kNames[] = {"nothing",
                                      "a force above its limit",
                                      "a force that changed too fast",
                                      "a torque above its limit",
                                      "a torque that changed too fast",
                                      "a force that swung too far beyond what its slew allows",
                                      "a blow of too much impulse",
                                      "a force that swung too much for too long"};
    static_assert(std::size(kNames) == static_cast<std::size_t>(FeltLimit::ringing) + 1);
    return kNames[static_cast<std::size_t>(limit)];
}

/// One round, all in one frame.
struct FeltRound {
    Wrench asked{};  ///< of the gate
    Wrench felt{};   ///< what it let through
    GatePhase gate = GatePhase::waiting;
    double dt_s = 0.001;  ///< since the round before
};

class FeltJudge {
  public:
    /// Which limit the round breaks; all rounds in turn, each once.
    [[nodiscard]] FeltLimit judge(const FeltLimits& limits, const FeltRound& round) noexcept;

  private:
    Wrench felt_before_{};
    Vector3 lasting_N_{Vector3::Zero()};        // b
    Vector3 beyond_before_N_{Vector3::Zero()};  // t of the last round
    double counted_s_ = 0.0;                    // for so long it is counted
    Vector3 impulse_Ns_{Vector3::Zero()};       // I
    double ringing_N2s_ = 0.0;                  // Q
};

}  // namespace fulcrum
