// Watches how fast the hand is and how much energy it is given, whatever the forces' own limits allow: nothing that a lesson
// feels like throws a hand about.
//
//   u <- u + (d/T - u) min(T / window, 1)          the hand's mean velocity; |u| > max_speed: Fault::hand_too_fast
//   E <- max(E (1 - T / memory) + A.d + M.w, 0)    energy given and not given back; E > max_energy: Fault::too_much_energy
// A, M: what acted along the motion d and the turn w of the round that has ended. Either fault fades the force; the hand then
// slows down by itself, E is forgotten, and the gate begins anew.
//
// Thread: the loop that owns the device. Cost: a few nanoseconds.
// Source: limits of speed and of energy beside those of force, as ISO/TS 15066:2016, collaborative robots, section 5.5.5 (power
// and force limiting) asks of a machine that people touch; the numbers are a classroom's: see SafetySettings.
#pragma once

#include "haptics/base/fault.h"
#include "haptics/loop/haptic_plan.h"
#include "haptics/math/spatial.h"

namespace fulcrum {

class HandGuard {
  public:
    static constexpr double kWindow_s = 0.02;
    static constexpr double kMemory_s = 1.0;

    /// Takes settings that `validate` accepted.
    explicit HandGuard(const SafetySettings& settings) noexcept
        : max_speed_(settings.max_felt_speed_m_per_s), max_energy_J_(settings.max_energy_J) {}

    /// Counts a round in which `acted` was on the hand while it moved by `motion` (m) and turned by `turn` (rad), all in one
    /// frame. A round that is not finite or of no length is not counted.
    [[nodiscard]] Fault step(const Wrench& acted, const Vector3& motion, const Vector3& turn,
                             double dt_s) noexcept;
    /// The hand has jumped, or is another's.
    void forget() noexcept {
        velocity_.setZero();
        energy_J_ = 0.0;
    }

    [[nodiscard]] double speed_m_per_s() const noexcept { return velocity_.norm(); }
    [[nodiscard]] double energy_J() const noexcept { return energy_J_; }

  private:
    double max_speed_;
    double max_energy_J_;
    Vector3 velocity_{Vector3::Zero()};
    double energy_J_ = 0.0;
};

}  // namespace fulcrum
