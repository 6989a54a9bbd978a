// What a load's derivatives must be, found twice by other ways than its own: by central differences of the load itself, and by automatic
// differentiation of its law, written out plainly once more.
#pragma once

#include "haptics/coupling/tool_coupling.h"
#include "haptics/dynamics/loads.h"
#include "haptics/math/plain_eigen.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/AutoDiff>

namespace fulcrum::test {

inline RigidState perturb(RigidState state, int column, bool velocity, double by) {
    const Vector3 along = by * Vector3::Unit(column % 3);
    if (velocity) {
        (column < 3 ? state.velocity_W.linear : state.velocity_W.angular) += along;
    } else if (column < 3) {
        state.pose_W.position += along;
    } else {
        state.pose_W.orientation = compute_exp(along) * state.pose_W.orientation;
    }
    return state;
}

inline Vector6 find_wrench(const Load& load, const RigidState& state) {
    Wrench wrench;
    load.add_wrench(state, 0.0, wrench);
    return (Vector6() << wrench.force, wrench.torque).finished();
}

/// The largest difference between a load's derivatives and central differences of its wrench, over the largest entry.
inline double find_jacobian_error(const Load& load, const RigidState& state) {
    Wrench wrench;
    WrenchJacobian analytic;
    load.add_linearised_wrench(state, 0.0, wrench, analytic);
    double worst =
        ((Vector6() << wrench.force, wrench.torque).finished() - find_wrench(load, state)).norm();
    constexpr double kStep = 1.0e-6;
    for (const bool velocity : {false, true}) {
        const Matrix6& jacobian = velocity ? analytic.velocity : analytic.pose;
        const double size = std::max(1.0, jacobian.cwiseAbs().maxCoeff());
        for (int column = 0; column < 6; ++column) {
            const Vector6 difference =
                (find_wrench(load, perturb(state, column, velocity, kStep)) -
                 find_wrench(load, perturb(state, column, velocity, -kStep))) /
                (2.0 * kStep);
            worst =
                std::max(worst, (difference - jacobian.col(column)).cwiseAbs().maxCoeff() / size);
        }
    }
    return worst;
}

/// A number with its derivatives by (dx, dtheta, dv, dw).
using Slope = Eigen::Matrix<double, 12, 1>;
using Sloped = Eigen::AutoDiffScalar<Slope>;
using Sloped3 = Eigen::Matrix<Sloped, 3, 1>;
using Sloped33 = Eigen::Matrix<Sloped, 3, 3>;

inline Sloped3 make_constant(const Vector3& v) {
    return {Sloped(v.x(), Slope::Zero()), Sloped(v.y(), Slope::Zero()),
            Sloped(v.z(), Slope::Zero())};
}

inline Sloped3 cross(const Sloped3& a, const Sloped3& b) {
    return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
            a.x() * b.y() - a.y() * b.x()};
}
inline Sloped dot(const Sloped3& a, const Sloped3& b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

/// A rigid state whose pose and velocity may each change a little: R = exp(dtheta) R0, to the first order, which is all that a first
/// derivative sees.
struct SlopedState {
    Sloped3 x, v, w;
    Sloped33 R;

    explicit SlopedState(const RigidState& state)
        : x(make_constant(state.pose_W.position)),
          v(make_constant(state.velocity_W.linear)),
          w(make_constant(state.velocity_W.angular)) {
        Sloped3 turn = make_constant(Vector3::Zero());
        for (int i = 0; i < 3; ++i) {
            x[i].derivatives()[i] = 1.0;
            turn[i].derivatives()[3 + i] = 1.0;
            v[i].derivatives()[6 + i] = 1.0;
            w[i].derivatives()[9 + i] = 1.0;
        }
        const Matrix3 R0 = state.pose_W.orientation.toRotationMatrix();
        for (int column = 0; column < 3; ++column) {
            const Sloped3 axis = make_constant(R0.col(column));
            R.col(column) = axis + cross(turn, axis);
        }
    }
    [[nodiscard]] Sloped3 turned(const Vector3& point_B) const {
        Sloped3 arm = make_constant(Vector3::Zero());
        for (int i = 0; i < 3; ++i) {
            arm += R.col(i) * Sloped(point_B[i], Slope::Zero());
        }
        return arm;
    }
};

struct SlopedWrench {
    Sloped3 force = make_constant(Vector3::Zero());
    Sloped3 torque = make_constant(Vector3::Zero());
};

/// (21) of Otaduy and Lin: F = k d - b u_n along the normal, where d > 0; without a ramp.
inline SlopedWrench find_contact(const PlaneContact& contact, const RigidState& at) {
    const SlopedState state(at);
    const Sloped3 arm = state.turned(contact.point_B);
    const Sloped3 n = make_constant(contact.normal_W);
    const Sloped depth = -dot(n, state.x + arm - make_constant(contact.plane_point_W));
    const Sloped sinking =
        -dot(n, state.v + cross(state.w, arm) - make_constant(contact.plane_velocity_W));
    const Sloped push = Sloped(contact.stiffness_N_per_m, Slope::Zero()) * depth +
                        Sloped(contact.damping_Ns_per_m, Slope::Zero()) * sinking;
    SlopedWrench wrench;
    if (depth.value() > 0.0 && push.value() > 0.0) {
        wrench.force = n * push;
        wrench.torque = cross(arm, wrench.force);
    }
    return wrench;
}

/// The coupling of tool_coupling.h, linear, about the centre of mass: the turn between handle and tool by atan2 of its own quaternion's parts.
inline SlopedWrench find_coupling(const ToolCouplingSettings& settings, const MovingFrame& handle,
                                  const Vector3& grip_B, const RigidState& at) {
    const SlopedState state(at);
    const auto number = [](double value) { return Sloped(value, Slope::Zero()); };
    const Sloped3 arm = state.turned(grip_B);
    const Sloped3 shift = make_constant(handle.pose_W.position) - state.x - arm;
    const Sloped3 along = make_constant(handle.velocity_W.linear) - state.v - cross(state.w, arm);
    SlopedWrench wrench;
    wrench.force = shift * number(settings.shift.stiffness_N_per_m) +
                   along * number(settings.shift.damping_Ns_per_m);
    // R_H R^T: its angle and axis from trace and skew part.
    const Matrix3 R_H = handle.pose_W.orientation.toRotationMatrix();
    Sloped33 between;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            Sloped sum = number(0.0);
            for (int i = 0; i < 3; ++i) {
                sum += number(R_H(row, i)) * state.R(column, i);
            }
            between(row, column) = sum;
        }
    }
    const Sloped3 skew{between(2, 1) - between(1, 2), between(0, 2) - between(2, 0),
                       between(1, 0) - between(0, 1)};
    const Sloped sine = sqrt(dot(skew, skew));                                          // 2 sin
    const Sloped cosine = between(0, 0) + between(1, 1) + between(2, 2) - number(1.0);  // 2 cos
    const Sloped angle = atan2(sine, cosine);
    const Sloped3 phi = skew * (angle / sine);
    // The turn's damper along the tool's axes.
    const Sloped3 spin = make_constant(handle.velocity_W.angular) - state.w;
    Sloped3 damped = make_constant(Vector3::Zero());
    for (int i = 0; i < 3; ++i) {
        const Sloped3 axis = state.R.col(i);
        damped += axis * (number(settings.turn.damping_Nms_per_rad[i]) * dot(axis, spin));
    }
    wrench.torque =
        cross(arm, wrench.force) + phi * number(settings.turn.stiffness_Nm_per_rad) + damped;
    return wrench;
}

/// The largest difference between a load's wrench and derivatives and those of a sloped wrench, over the largest entry.
inline double find_slope_error(const Load& load, const RigidState& state,
                               const SlopedWrench& sloped) {
    Wrench wrench;
    WrenchJacobian jacobian;
    load.add_linearised_wrench(state, 0.0, wrench, jacobian);
    const Vector6 plain = (Vector6() << wrench.force, wrench.torque).finished();
    const double size = std::max(
        {1.0, jacobian.pose.cwiseAbs().maxCoeff(), jacobian.velocity.cwiseAbs().maxCoeff()});
    double worst = 0.0;
    for (int row = 0; row < 6; ++row) {
        const Sloped& one = row < 3 ? sloped.force[row] : sloped.torque[row - 3];
        worst = std::max(worst, std::abs(one.value() - plain[row]));
        for (int column = 0; column < 6; ++column) {
            worst = std::max(
                worst, std::abs(one.derivatives()[column] - jacobian.pose(row, column)) / size);
            worst = std::max(
                worst,
                std::abs(one.derivatives()[6 + column] - jacobian.velocity(row, column)) / size);
        }
    }
    return worst;
}

}  // namespace fulcrum::test
