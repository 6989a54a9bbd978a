#include "haptics/flight/kite_load.h"

#include "haptics/math/length.h"
#include "haptics/math/turned_slopes.h"

namespace fulcrum {
namespace {

// A body's motion along its own axes, and the wind's.
struct MotionB {
    Vector3 air;  // past the centre of mass
    Vector3 spin;
    [[nodiscard]] Vector3 compute_flow(const Vector3& at_B) const noexcept {
        return air - spin.cross(at_B);
    }
};

MotionB compute_motion(const RigidState& state, const Vector3& wind_W) noexcept {
    const Quaternion to_B = state.pose_W.orientation.conjugate();
    return {to_B * Vector3(wind_W - state.velocity_W.linear), to_B * state.velocity_W.angular};
}

Vector3 compute_tail_force(const Kite& kite, double density_kg_per_m3,
                           const Vector3& flow) noexcept {
    return 0.5 * density_kg_per_m3 * kite.tail_drag_m2 * compute_length(flow) * flow;
}

// F = c |v| v has the derivatives c (|v| I + v v^T / |v|).
Matrix3 compute_tail_slopes(const Kite& kite, double density_kg_per_m3,
                            const Vector3& flow) noexcept {
    const double speed = compute_length(flow);
    const double c = 0.5 * density_kg_per_m3 * kite.tail_drag_m2;
    Matrix3 slopes = c * speed * Matrix3::Identity();
    if (speed > 0.0) {
        slopes += c * flow * (flow / speed).transpose();
    }
    return slopes;
}

// Central differences of `compute(flow)`, which gives a PlateForce.
template <class Compute>
PlateSlopes differentiate(const Compute& compute, const Vector3& flow) noexcept {
    constexpr double kShare = 1.0e-5;  // of the speed
    constexpr double kLeast_m_per_s = 1.0e-5;
    const double h = kShare * compute_length(flow) + kLeast_m_per_s;
    PlateSlopes slopes;
    for (Index axis = 0; axis < 3; ++axis) {
        Vector3 more = flow;
        Vector3 less = flow;
        more[axis] += h;
        less[axis] -= h;
        const PlateForce above = compute(more);
        const PlateForce below = compute(less);
        slopes.force.col(axis) = (above.force - below.force) / (2.0 * h);
        slopes.torque.col(axis) = (above.torque - below.torque) / (2.0 * h);
    }
    return slopes;
}

void add_at(const Vector3& at_B, const PlateForce& force, Wrench& wrench) noexcept {
    wrench.force += force.force;
    wrench.torque += at_B.cross(force.force) + force.torque;
}

// Adds what a place's slopes make of those of the body, along its own axes: with M a matrix's row, M [r] is M x r, and
//   by the spin M [at]     by turning M ([flow] + [spin][at])
void add_slopes(const MotionB& motion, const Vector3& at_B, const PlateSlopes& slopes,
                WrenchJacobian& jacobian) noexcept {
    const Vector3 flow = motion.compute_flow(at_B);
    const Matrix3 torque = compute_skew(at_B) * slopes.force + slopes.torque;
    jacobian.velocity.topLeftCorner<3, 3>() -= slopes.force;
    jacobian.velocity.bottomLeftCorner<3, 3>() -= torque;
    const auto add_row = [&](int at, const Vector3& row) {
        jacobian.velocity.block<1, 3>(at, 3) += row.cross(at_B).transpose();
        jacobian.pose.block<1, 3>(at, 3) +=
            (row.cross(flow) + row.cross(motion.spin).cross(at_B)).transpose();
    };
    for (int i = 0; i < 3; ++i) {
        add_row(i, slopes.force.row(i).transpose());
        add_row(i + 3, torque.row(i).transpose());
    }
}

}  // namespace

void KiteAirLoad::add_wrench(const RigidState& state, double /*time_s*/,
                             Wrench& wrench) const noexcept {
    const MotionB motion = compute_motion(state, wind_W_);
    Wrench air_B;
    for (const FlatPlate& plate : kite_.plates) {
        add_at(plate.middle,
               compute_plate_force(kite_.law, plate, density_kg_per_m3_,
                                   motion.compute_flow(plate.middle)),
               air_B);
    }
    const Vector3 tail_B =
        compute_tail_force(kite_, density_kg_per_m3_, motion.compute_flow(kite_.foot_B));
    add_at(kite_.foot_B, {tail_B, Vector3::Zero()}, air_B);
    wrench.force += state.pose_W.orientation * air_B.force;
    wrench.torque += state.pose_W.orientation * air_B.torque;
}

void KiteAirLoad::add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                                        WrenchJacobian& jacobian) const noexcept {
    const MotionB motion = compute_motion(state, wind_W_);
    WrenchJacobian slopes_B;
    for (const FlatPlate& plate : kite_.plates) {
        const auto compute = [&](const Vector3& flow) {
            return compute_plate_force(kite_.law, plate, density_kg_per_m3_, flow);
        };
        const Vector3 flow = motion.compute_flow(plate.middle);
        add_slopes(motion, plate.middle,
                   kite_.law == PlateLaw::cross_flow
                       ? compute_cross_flow_slopes(plate, density_kg_per_m3_, flow)
                       : differentiate(compute, flow),
                   slopes_B);
    }
    const Matrix3 tail =
        compute_tail_slopes(kite_, density_kg_per_m3_, motion.compute_flow(kite_.foot_B));
    add_slopes(motion, kite_.foot_B, {tail, Matrix3::Zero()}, slopes_B);
    // Along W, and turning with the body.
    const Matrix3 R = state.pose_W.orientation.toRotationMatrix();
    jacobian.velocity += compute_turned(slopes_B.velocity, R);
    Matrix6 pose = compute_turned(slopes_B.pose, R);
    Wrench air_W;
    add_wrench(state, time_s, air_W);
    add_turning(air_W, pose);
    jacobian.pose += pose;
    wrench.force += air_W.force;
    wrench.torque += air_W.torque;
}

void LinePullLoad::add_wrench(const RigidState& state, double /*time_s*/,
                              Wrench& wrench) const noexcept {
    const Vector3 arm_W = state.pose_W.orientation * knot_B_;
    const Vector3 way_W = state.pose_W.position + arm_W - pull_.from_W;
    add_point_force(arm_W, pull_.compute_at(way_W).force_W, wrench);
}

void LinePullLoad::add_linearised_wrench(const RigidState& state, double /*time_s*/, Wrench& wrench,
                                         WrenchJacobian& jacobian) const noexcept {
    const Vector3 arm_W = state.pose_W.orientation * knot_B_;
    const Vector3 way_W = state.pose_W.position + arm_W - pull_.from_W;
    const LinePull::AtEnd at = pull_.compute_at(way_W);
    add_point_force(arm_W, state.velocity_W.angular, {at.force_W, at.slope_W, Matrix3::Zero()},
                    wrench, jacobian);
}

}  // namespace fulcrum
