// The air's wrench on a kite, and the pull of its line, as loads of a rigid body (dynamics/load.h).
//
//   u = W - v - w x a            the air past a plate whose middle lies at a from the centre of mass, W one wind for the whole kite
//   F = sum of F_i(u),  torque = sum of a x F_i + T_i(u)         flat_plate.h, in the body's frame
//   tail: rho/2 (C_D A) |u| u at the foot
// Derivatives: each plate's by u are central differences in the body's frame, G = dF/du, M = dT/du, exact but for rounding where the
// law is a quadratic; then
//   du = -dv + [a] dw,  and by a turn dtheta, along axes that turn with the body,  du = ([u] + [w][a]) dtheta
// and the whole wrench turns with the body (turned_slopes.h). W is the same wherever the kite goes in one step.
//
// The line's pull is linear in the way of the knot, and never a push (line.h).
//
// Thread: that of the step. Cost: 20 ns a plate, with derivatives 150 ns. No allocation.
// Source: strip theory; derivatives as in wrench_jacobian.h.
#pragma once

#include "haptics/dynamics/load.h"
#include "haptics/flight/kite.h"
#include "haptics/flight/line.h"

namespace fulcrum {

// No load is deleted as a Load (load.h says why).
// NOLINTBEGIN(cppcoreguidelines-virtual-class-destructor)
class KiteAirLoad final : public Load {
  public:
    /// The kite outlives it.
    KiteAirLoad(const Kite& kite, const Vector3& wind_W, double density_kg_per_m3) noexcept
        : kite_(kite), wind_W_(wind_W), density_kg_per_m3_(density_kg_per_m3) {}
    void add_wrench(const RigidState& state, double time_s, Wrench& wrench) const noexcept override;
    void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                               WrenchJacobian& jacobian) const noexcept override;

  private:
    const Kite& kite_;
    Vector3 wind_W_;
    double density_kg_per_m3_;
};

class LinePullLoad final : public Load {
  public:
    LinePullLoad(const Vector3& knot_B, const LinePull& pull) noexcept
        : knot_B_(knot_B), pull_(pull) {}
    void add_wrench(const RigidState& state, double time_s, Wrench& wrench) const noexcept override;
    void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                               WrenchJacobian& jacobian) const noexcept override;

  private:
    Vector3 knot_B_;
    LinePull pull_;
};
// NOLINTEND(cppcoreguidelines-virtual-class-destructor)

}  // namespace fulcrum
