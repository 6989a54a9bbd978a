#include "haptics/continuous/in_between_motion.h"

#include "haptics/math/rotation.h"

#include <cmath>

namespace fulcrum {
namespace {

constexpr double kUnitTolerance = 1.0e-6;

bool is_place(const Pose& pose) noexcept {
    return pose.position.allFinite() &&
           pose.position.cwiseAbs().maxCoeff() <= InBetweenMotion::kLargest_m &&
           std::abs(pose.orientation.norm() - 1.0) <= kUnitTolerance;
}

Pose with_unit_orientation(const Pose& pose) noexcept {
    return {pose.position, pose.orientation.normalized()};
}

}  // namespace

InBetweenMotion::InBetweenMotion(const Pose& start_AB, const Pose& end_AB,
                                 const Vector3& pivot_B) noexcept
    : pivot_B_(pivot_B) {
    if (!is_place(start_AB) || !is_place(end_AB) || !pivot_B.allFinite() ||
        !(pivot_B.cwiseAbs().maxCoeff() <= kLargest_m)) {
        return;
    }
    start_AB_ = with_unit_orientation(start_AB);
    end_AB_ = with_unit_orientation(end_AB);
    start_turn_ = start_AB_.orientation.toRotationMatrix();
    pivot_start_A_ = start_AB_ * pivot_B;
    const Vector3 pivot_end_A = end_AB_ * pivot_B;
    travel_A_ = pivot_end_A - pivot_start_A_;
    const Vector3 turn =
        compute_log((end_AB_.orientation * start_AB_.orientation.conjugate()).normalized());
    angle_rad_ = turn.norm();
    if (angle_rad_ > 0.0) {
        axis_A_ = (turn / angle_rad_).normalized();
    }
    size_m_ = start_AB.position.norm() + end_AB.position.norm() + pivot_B.norm();
    is_valid_ = axis_A_.allFinite();
}

Pose InBetweenMotion::pose(double t) const noexcept {
    if (t == 0.0) {
        return start_AB_;
    }
    if (t == 1.0) {
        return end_AB_;
    }
    const Quaternion turned =
        (compute_exp(t * angle_rad_ * axis_A_) * start_AB_.orientation).normalized();
    return {pivot_start_A_ + t * travel_A_ - turned * pivot_B_, turned};
}

PointPath InBetweenMotion::find_path(const Vector3& point_B) const noexcept {
    const Vector3 r = start_turn_ * (point_B - pivot_B_);
    const Vector3 along = axis_A_.dot(r) * axis_A_;
    return {pivot_start_A_ + along, r - along, axis_A_.cross(r)};
}

IntervalVector InBetweenMotion::enclose(const PointPath& path, const Interval& t) const noexcept {
    const SineCosineInterval turn = turn_over(t);
    IntervalVector box;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto k = static_cast<Index>(i);
        box[i] = Interval::at(path.a[k]) + travel_A_[k] * t + path.b[k] * turn.cosine +
                 path.c[k] * turn.sine;
    }
    return box;
}

Matrix3 InBetweenMotion::find_rotation(const SineCosine& turn) const noexcept {
    // cos I + (1 - cos) u u^T + sin [u], and the start before it.
    const Matrix3 turned = turn.cosine * Matrix3::Identity() +
                           (1.0 - turn.cosine) * axis_A_ * axis_A_.transpose() +
                           turn.sine * compute_skew(axis_A_);
    return turned * start_turn_;
}

}  // namespace fulcrum
