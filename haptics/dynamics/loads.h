// The loads that most things need: a spring to a point, contacts with planes, a constant force, the coupling to a handle.
//
//   spring     F = -k (p - a) - b u                  at the body's point p = x + R r, u its velocity
//   contact    d = -n.(p - p0) > 0:  f = k d + b s(d) (-n.u),  F = max(f, 0) n;   s(d) = min(d/d_r, 1)
//              u relative to the plane, where that moves. A wall pushes and never holds. With d_r > 0 the damper comes in over that depth, so F is
//              continuous at the touch; d_r = 0 is the plain Kelvin-Voigt law, which jumps there by b |u|, and
//              then an implicit step that ends at the touch may have no solution (StepStatus).
//   coupling   tool_coupling.h, at the grip p = x + R c; the handle moves on from its stamp along its twist
//
// Thread: that of the step. Cost: 20 to 100 ns each, no allocation.
// Source: M. Otaduy, M. Lin 2005, section 6.2, eq. 21 (viscoelastic plane constraint), section 5.1 (coupling at a point c
// of the grasped object). The ramp s is ours, after K. Hunt, F. Crossley 1975, Coefficient of restitution interpreted as
// damping in vibroimpact, whose damping grows with the depth for the same reason.
#pragma once

#include "haptics/coupling/tool_coupling.h"
#include "haptics/dynamics/load.h"

#include <span>

namespace fulcrum {

// No load is deleted as a Load, whose own destructor is protected (load.h says why).
// NOLINTBEGIN(cppcoreguidelines-virtual-class-destructor)

/// A force (N) and torque (Nm, about the centre of mass) that nothing changes: weight, for one. World frame.
class ConstantLoad final : public Load {
  public:
    explicit ConstantLoad(const Wrench& wrench_W) noexcept : wrench_W_(wrench_W) {}
    void add_wrench(const RigidState& state, double time_s, Wrench& wrench) const noexcept override;
    void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                               WrenchJacobian& jacobian) const noexcept override;

  private:
    Wrench wrench_W_;
};

/// A spring and damper between a body's point and a place in the world.
struct PointSpring {
    Vector3 point_B{Vector3::Zero()};   ///< metres from the centre of mass, body frame
    Vector3 anchor_W{Vector3::Zero()};  ///< metres
    double stiffness_N_per_m = 0.0;     ///< 0 or more
    double damping_Ns_per_m = 0.0;      ///< 0 or more
};

class PointSpringLoad final : public Load {
  public:
    explicit PointSpringLoad(const PointSpring& spring) noexcept : spring_(spring) {}
    void add_wrench(const RigidState& state, double time_s, Wrench& wrench) const noexcept override;
    void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                               WrenchJacobian& jacobian) const noexcept override;

  private:
    PointSpring spring_;
};

/// A body's point that may touch a plane.
struct PlaneContact {
    Vector3 point_B{Vector3::Zero()};           ///< metres from the centre of mass, body frame
    Vector3 plane_point_W{Vector3::Zero()};     ///< any place on the plane, metres
    Vector3 normal_W{Vector3::UnitY()};         ///< unit, out of the obstacle
    Vector3 plane_velocity_W{Vector3::Zero()};  ///< of the obstacle where the point is, m/s
    double stiffness_N_per_m = 2000.0;          ///< 0 or more
    double damping_Ns_per_m = 0.0;              ///< 0 or more
    double damping_ramp_m = 1.0e-4;             ///< depth over which the damper comes in, 0 or more
};

/// How deep the contact's point lies behind its plane, metres; negative outside.
[[nodiscard]] double compute_depth_m(const PlaneContact& contact, const Pose& pose_W) noexcept;
/// The push along the normal, newtons, 0 or more.
[[nodiscard]] double compute_push_N(const PlaneContact& contact, const RigidState& state) noexcept;

/// Any number of contacts; refers to them where they lie.
class PlaneContactsLoad final : public Load {
  public:
    explicit PlaneContactsLoad(std::span<const PlaneContact> contacts) noexcept
        : contacts_(contacts) {}
    void add_wrench(const RigidState& state, double time_s, Wrench& wrench) const noexcept override;
    void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                               WrenchJacobian& jacobian) const noexcept override;

  private:
    std::span<const PlaneContact> contacts_;
};

/// The coupling between a tool and its handle.
class ToolCouplingLoad final : public Load {
  public:
    /// Takes settings that `validate` accepted; the grip lies `grip_B` from the centre of mass and is turned as the body.
    explicit ToolCouplingLoad(const ToolCouplingSettings& settings,
                              const Vector3& grip_B = Vector3::Zero()) noexcept
        : settings_(settings), grip_B_(grip_B) {}

    /// The handle as it was at `time_s`; at another time it is that much further along its twist.
    void set_handle(const MovingFrame& handle, double time_s) noexcept;
    /// The wrench on the *hand* about the grip: newtons and newton metres, world frame.
    [[nodiscard]] Wrench compute_felt_wrench(const RigidState& state, double time_s) const noexcept;

    void add_wrench(const RigidState& state, double time_s, Wrench& wrench) const noexcept override;
    void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                               WrenchJacobian& jacobian) const noexcept override;

  private:
    [[nodiscard]] MovingFrame compute_handle(double time_s) const noexcept;
    [[nodiscard]] MovingFrame compute_grip(const RigidState& state) const noexcept;

    ToolCouplingSettings settings_;
    Vector3 grip_B_;
    MovingFrame handle_{};
    double handle_time_s_ = 0.0;
};
// NOLINTEND(cppcoreguidelines-virtual-class-destructor)

}  // namespace fulcrum
