// How the force of field_sampling.h changes with the tool's pose. For a point at r from the tool's origin, g = -grad D the way out,
// H the second derivatives of D, B = (I; [r]) what a force at the point is as a wrench:
//   slopes    f = k D g        dW = -k B (g g^T + D H) B^T dx + (0; [f][r] dtheta)
//   normals   f = k D n        dW = -k (n; r x n) (g; r x g)^T dx, and f turns with the tool
#include "haptics/math/turned_slopes.h"
#include "haptics/tool/field_sampling.h"

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

// Of one point's force by slopes, over the stiffness.
void add_depth_slopes(const DepthSample& at, const Vector3& arm_O, Matrix6& slopes) noexcept {
    const Matrix3 by_position = -at.way_out * at.way_out.transpose() - at.depth_m * at.hessian;
    const Matrix3 arm = compute_skew(arm_O);
    add_point_slopes(arm, at.depth_m * at.way_out, by_position, -by_position * arm, slopes);
}

}  // namespace

void FieldSampler::add_slopes(std::size_t thinning, std::size_t leaf, const FieldPlace& place,
                              const Pose& X_OT) noexcept {
    const ShellPoints points = shell_->points(thinning, leaf);
    std::array<float, kLeafPoints> values{};
    kernels_->sample(bounds_.view, place, points, kLeafPoints, values.data(), nullptr);
    const std::size_t n = shell_->count_in(thinning, leaf);
    for (std::size_t i = 0; i < n; ++i) {
        if (!(values[i] < 0.0F)) {
            continue;
        }
        const Vector3 arm_O = X_OT.orientation * Vector3(points.x[i], points.y[i], points.z[i]);
        const DepthSample depth = field_->sample_depth(X_OT.position + arm_O);
        if (settings_.along == ForceAlong::slopes) {
            add_depth_slopes(depth, arm_O, *slopes_O_);
        } else {
            const Vector3 n_O =
                X_OT.orientation * Vector3(points.nx[i], points.ny[i], points.nz[i]);
            *slopes_O_ -= at_arm(arm_O, n_O) * at_arm(arm_O, depth.way_out).transpose();
        }
    }
}

void FieldSampler::add_all_slopes(const FieldPlace& place, const Pose& X_OT) noexcept {
    const auto thinning =
        static_cast<std::size_t>(std::countr_zero(static_cast<std::uint64_t>(touch_.weight)));
    const bool has_budget = settings_.budget_us > 0.0;
    const double before_us = has_budget ? elapsed_us() : 0.0;
    const std::size_t stride = find_slopes_stride();
    for (std::size_t i = 0; i < touched_.size(); i += stride) {
        add_slopes(thinning, static_cast<std::size_t>(touched_.begin()[i]), place, X_OT);
        ++touch_.n_sloped;
    }
    if (has_budget && touch_.n_sloped > 0) {
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
