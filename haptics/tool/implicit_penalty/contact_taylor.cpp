#include "haptics/tool/implicit_penalty/contact_taylor.h"

#include "haptics/math/rotation.h"

#include <algorithm>

namespace fulcrum {
namespace {

// As an object sees it.
RigidState see(const MovingFrame& object, const RigidState& state) noexcept {
    const Quaternion q_OW = object.pose_W.orientation.conjugate();
    return {object.pose_W.inverse() * state.pose_W,
            {q_OW * Vector3(state.velocity_W.linear -
                            compute_velocity_at(object, state.pose_W.position)),
             q_OW * Vector3(state.velocity_W.angular - object.velocity_W.angular)}};
}

Vector6 as_vector(const Vector3& first, const Vector3& second) noexcept {
    Vector6 both;
    both << first, second;
    return both;
}

// The same derivatives, rows and columns turned by R.
Matrix6 turn(const Matrix3& R, const Matrix6& by) noexcept {
    Matrix6 turned;
    for (int row = 0; row < 6; row += 3) {
        for (int column = 0; column < 6; column += 3) {
            turned.block<3, 3>(row, column) = R * by.block<3, 3>(row, column) * R.transpose();
        }
    }
    return turned;
}

}  // namespace

void ContactTaylor::learn(const ContactModel& model) noexcept {
    n_ = 0;
    for (const ToldContact& told : model.all()) {
        const auto end = series_.begin() + static_cast<std::ptrdiff_t>(n_);
        auto at = std::find_if(series_.begin(), end,
                               [&](const Series& one) { return one.object == told.object; });
        if (at == end) {
            if (n_ == series_.size()) {
                continue;
            }
            *at = {.object = told.object, .at = {told.X_OT, told.velocity_O}};
            ++n_;
        }
        // The plane in the object's own frame.
        const ContactCluster& cluster = told.cluster;
        const PlaneContact plane{
            .point_B = cluster.point_T,
            .plane_point_W = cluster.place_O + settings_.within_m * cluster.normal_O,
            .normal_W = cluster.normal_O,
            .stiffness_N_per_m = cluster.strength * settings_.stiffness_N_per_m,
            .damping_Ns_per_m = cluster.strength * settings_.damping_Ns_per_m};
        PlaneContactsLoad({&plane, 1}).add_linearised_wrench(at->at, 0.0, at->wrench, at->by);
    }
}

void ContactTaylor::begin_step(std::span<const MovingFrame> objects) noexcept {
    for (std::size_t i = 0; i < n_; ++i) {
        Series& one = series_[i];
        one.is_here = static_cast<std::size_t>(one.object) < objects.size();
        if (one.is_here) {
            one.frame = objects[static_cast<std::size_t>(one.object)];
        }
    }
}

Wrench ContactTaylor::compute_wrench_O(const Series& series,
                                       const RigidState& state_O) const noexcept {
    if (settings_.model == PenaltyModel::held) {
        return series.wrench;
    }
    const Vector6 moved = as_vector(
        state_O.pose_W.position - series.at.pose_W.position,
        compute_log(state_O.pose_W.orientation * series.at.pose_W.orientation.conjugate()));
    const Vector6 faster = as_vector(state_O.velocity_W.linear - series.at.velocity_W.linear,
                                     state_O.velocity_W.angular - series.at.velocity_W.angular);
    const Vector6 change = series.by.pose * moved + series.by.velocity * faster;
    return {series.wrench.force + change.head<3>(), series.wrench.torque + change.tail<3>()};
}

Wrench ContactTaylor::compute_wrench_of(std::int32_t object,
                                        const RigidState& state) const noexcept {
    for (std::size_t i = 0; i < n_; ++i) {
        if (series_[i].object == object && series_[i].is_here) {
            const Quaternion& q_WO = series_[i].frame.pose_W.orientation;
            const Wrench here = compute_wrench_O(series_[i], see(series_[i].frame, state));
            return {q_WO * here.force, q_WO * here.torque};
        }
    }
    return {};
}

void ContactTaylor::add_wrench(const RigidState& state, double /*time_s*/,
                               Wrench& wrench) const noexcept {
    for (std::size_t i = 0; i < n_; ++i) {
        const Wrench one = compute_wrench_of(series_[i].object, state);
        wrench.force += one.force;
        wrench.torque += one.torque;
    }
}

void ContactTaylor::add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                                          WrenchJacobian& jacobian) const noexcept {
    add_wrench(state, time_s, wrench);
    if (settings_.model == PenaltyModel::held) {
        return;
    }
    for (std::size_t i = 0; i < n_; ++i) {
        const Series& one = series_[i];
        if (!one.is_here) {
            continue;
        }
        const Matrix3 R = one.frame.pose_W.orientation.toRotationMatrix();
        // The log turns with the pose by its own Jacobian; an object's spin carries the tool's place into its velocity.
        const RigidState seen = see(one.frame, state);
        const Vector3 phi =
            compute_log(seen.pose_W.orientation * one.at.pose_W.orientation.conjugate());
        Matrix6 by_pose = one.by.pose;
        by_pose.rightCols<3>() = one.by.pose.rightCols<3>() * compute_right_jacobian_inverse(-phi);
        const Matrix3 spin_O = R.transpose() * compute_skew(one.frame.velocity_W.angular) * R;
        by_pose.leftCols<3>() -= one.by.velocity.leftCols<3>() * spin_O;
        jacobian.pose += turn(R, by_pose);
        jacobian.velocity += turn(R, one.by.velocity);
    }
}

}  // namespace fulcrum
