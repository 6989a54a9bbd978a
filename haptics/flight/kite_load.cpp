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

// Central differences of `compute(flow)`, which gives a PlateForce.
template <class Compute>
PlateSlopes differentiate(const Compute& compute, const Vector3& flow) noexcept {
    constexpr double kShare = 1.0e-5;  // of the speed
    constexpr double kLeast_m_per_s = 1.0e-5;
    const double h = kShare * compute_length(flow) + kLeast_m_per_s;
    PlateSlopes slopes;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
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

// Adds what a place's slopes make of those of the body, along its own axes.
void add_slopes(const MotionB& motion, const Vector3& at_B, const PlateSlopes& slopes,
                WrenchJacobian& jacobian) noexcept {
    const Matrix3 arm = compute_skew(at_B);
    const Matrix3 torque = arm * slopes.force + slopes.torque;
    const Matrix3 by_turn =
        compute_skew(motion.compute_flow(at_B)) + compute_skew(motion.spin) * arm;
    jacobian.velocity.topLeftCorner<3, 3>() -= slopes.force;
    jacobian.velocity.bottomLeftCorner<3, 3>() -= torque;
    jacobian.velocity.topRightCorner<3, 3>() += slopes.force * arm;
    jacobian.velocity.bottomRightCorner<3, 3>() += torque * arm;
    jacobian.pose.topRightCorner<3, 3>() += slopes.force * by_turn;
    jacobian.pose.bottomRightCorner<3, 3>() += torque * by_turn;
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
    const auto compute_tail = [&](const Vector3& flow) {
        return PlateForce{compute_tail_force(kite_, density_kg_per_m3_, flow), Vector3::Zero()};
    };
    add_slopes(motion, kite_.foot_B, differentiate(compute_tail, motion.compute_flow(kite_.foot_B)),
               slopes_B);
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
