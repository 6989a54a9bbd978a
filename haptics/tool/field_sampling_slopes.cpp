// How the force of field_sampling.h changes with the tool's pose. For a point at r from the tool's origin, g = -grad D the way out,
// H the second derivatives of D, B = (I; [r]) what a force at the point is as a wrench:
//   slopes    f = k D g        dW = -k B (g g^T + D H) B^T dx + (0; [f][r] dtheta)      in vectors; slope_sum.h row by row
//   normals   f = k D n        dW = -k (n; r x n) (g; r x g)^T dx, and f turns with the tool
#include "haptics/math/turned_slopes.h"
#include "haptics/tool/field_sampling.h"
#include "haptics/tool/slope_sum.h"

#include <array>
#include <bit>

namespace fulcrum {
namespace {

// A force at the arm as a wrench.
Vector6 at_arm(const Vector3& arm, const Vector3& force) noexcept {
    Vector6 wrench;
    wrench << force, arm.cross(force);
    return wrench;
}

}  // namespace

// Of a leaf by slopes: in vectors, and one by one what lies too deep for them.
void FieldSampler::add_slopes(const ShellPoints& points, std::size_t n, const FieldPlace& place,
                              const Pose& X_OT, SlopeLanes& lanes) noexcept {
    std::uint32_t deep = kernels_->sum_slopes(bounds_.view, place, points, n, lanes);
    if (deep == 0) {
        return;
    }
    SlopeSum sum;
    for (; deep != 0; deep &= deep - 1U) {
        const auto i = static_cast<std::size_t>(std::countr_zero(deep));
        const Vector3 arm_O = X_OT.orientation * Vector3(points.x[i], points.y[i], points.z[i]);
        sum.add(field_->sample_depth(X_OT.position + arm_O), arm_O);
    }
    sum.add_to(*slopes_O_);
}

void FieldSampler::add_slopes_by_normals(const ShellPoints& points, std::size_t n,
                                         const FieldPlace& place, const Pose& X_OT) noexcept {
    std::array<float, kLeafPoints> values{};
    kernels_->sample(bounds_.view, place, points, kLeafPoints, values.data(), nullptr);
    const Matrix3 R_OT = X_OT.orientation.toRotationMatrix();
    for (std::size_t i = 0; i < n; ++i) {
        if (values[i] < 0.0F) {
            const Vector3 arm_O = R_OT * Vector3(points.x[i], points.y[i], points.z[i]);
            const Vector3 n_O = R_OT * Vector3(points.nx[i], points.ny[i], points.nz[i]);
            const Vector3 way_out = field_->sample_depth(X_OT.position + arm_O).way_out;
            *slopes_O_ -= at_arm(arm_O, n_O) * at_arm(arm_O, way_out).transpose();
        }
    }
}

void FieldSampler::add_all_slopes(const FieldPlace& place, const Pose& X_OT) noexcept {
    constexpr std::int64_t kMostInLanes = 128;  // leaves whose sums single precision may hold
    const auto thinning =
        static_cast<std::size_t>(std::countr_zero(static_cast<std::uint64_t>(touch_.weight)));
    const double before_us = has_budget() ? elapsed_us() : 0.0;
    const std::size_t stride = find_slopes_stride();
    SlopeLanes lanes;
    for (std::size_t i = 0; i < touched_.size(); i += stride) {
        const auto leaf = static_cast<std::size_t>(touched_.begin()[i]);
        const ShellPoints points = shell_->points(thinning, leaf);
        const std::size_t n = shell_->count_in(thinning, leaf);
        if (settings_.along == ForceAlong::normals) {
            add_slopes_by_normals(points, n, place, X_OT);
        } else {
            add_slopes(points, n, place, X_OT, lanes);
        }
        if (++touch_.n_sloped % kMostInLanes == 0) {
            add_slope_lanes(*field_, lanes, *slopes_O_);
        }
    }
    add_slope_lanes(*field_, lanes, *slopes_O_);
    if (has_budget() && touch_.n_sloped > 0) {
        const auto n = static_cast<double>(touch_.n_sloped);
        learn(slopes_us_, find_lap_us(before_us, n * slopes_us_),
              static_cast<std::size_t>(touch_.n_sloped));
        *slopes_O_ *= static_cast<double>(touched_.size()) / n;
    }
}

FieldTouch FieldSampler::step_linearised(const Pose& X_WO, const Pose& X_WT,
                                         Matrix6& by_pose_W) noexcept {
    Matrix6 slopes_O = Matrix6::Zero();
    slopes_O_ = &slopes_O;
    const FieldTouch touch = step(X_WO, X_WT);
    slopes_O_ = nullptr;
    if (touch.n_touching > 0) {
        const double k = settings_.stiffness_N_per_m * static_cast<double>(touch.weight);
        by_pose_W += k * compute_turned(slopes_O, X_WO.orientation.toRotationMatrix());
        if (settings_.along == ForceAlong::normals) {
            add_turning(touch.wrench_W, by_pose_W);
        }
    }
    return touch;
}

}  // namespace fulcrum
