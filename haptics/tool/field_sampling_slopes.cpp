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

// The sum of points' derivatives by slopes, over the stiffness. With S = -(g g^T + D H), which is symmetric, row by row:
//   by the place S     by turning T = -S [r], rows r x S_i     and below them T^T and [r] T + [f][r], [f][r] = r f^T - (f . r) I
class SlopeSum {
  public:
    void add(const DepthSample& at, const Vector3& arm_O) noexcept {
        const Vector3 force = at.depth_m * at.way_out;
        std::array<Vector3, 3> turned;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto row = static_cast<int>(i);
            const Vector3 by_place =
                -at.way_out[row] * at.way_out - at.depth_m * at.hessian.col(row);
            turned[i] = arm_O.cross(by_place);
            place_[i] += by_place;
            turn_[i] += turned[i];
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const auto column = static_cast<int>(i);
            const Vector3 of_column(turned[0][column], turned[1][column], turned[2][column]);
            torque_[i] += arm_O.cross(of_column) + force[column] * arm_O;
        }
        along_arm_ += force.dot(arm_O);
    }

    void add_to(Matrix6& slopes) const noexcept {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto at = static_cast<int>(i);
            slopes.block<1, 3>(at, 0) += place_[i].transpose();
            slopes.block<1, 3>(at, 3) += turn_[i].transpose();
            slopes.block<3, 1>(3, at) += turn_[i];
            slopes.block<3, 1>(3, at + 3) += torque_[i];
            slopes(at + 3, at + 3) -= along_arm_;
        }
    }

  private:
    using Rows = std::array<Vector3, 3>;
    static Rows zero() noexcept { return {Vector3::Zero(), Vector3::Zero(), Vector3::Zero()}; }
    Rows place_ = zero();
    Rows turn_ = zero();
    Rows torque_ = zero();  // by turning, column by column
    double along_arm_ = 0.0;
};

}  // namespace

void FieldSampler::add_slopes(std::size_t thinning, std::size_t leaf, const FieldPlace& place,
                              const Pose& X_OT) noexcept {
    const ShellPoints points = shell_->points(thinning, leaf);
    std::array<float, kLeafPoints> values{};
    kernels_->sample(bounds_.view, place, points, kLeafPoints, values.data(), nullptr);
    const std::size_t n = shell_->count_in(thinning, leaf);
    const Matrix3 R_OT = X_OT.orientation.toRotationMatrix();
    SlopeSum sum;
    for (std::size_t i = 0; i < n; ++i) {
        if (!(values[i] < 0.0F)) {
            continue;
        }
        const Vector3 arm_O = R_OT * Vector3(points.x[i], points.y[i], points.z[i]);
        const DepthSample depth = field_->sample_depth(X_OT.position + arm_O);
        if (settings_.along == ForceAlong::slopes) {
            sum.add(depth, arm_O);
        } else {
            const Vector3 n_O = R_OT * Vector3(points.nx[i], points.ny[i], points.nz[i]);
            *slopes_O_ -= at_arm(arm_O, n_O) * at_arm(arm_O, depth.way_out).transpose();
        }
    }
    sum.add_to(*slopes_O_);
}

void FieldSampler::add_all_slopes(const FieldPlace& place, const Pose& X_OT) noexcept {
    const auto thinning =
        static_cast<std::size_t>(std::countr_zero(static_cast<std::uint64_t>(touch_.weight)));
    const double before_us = has_budget() ? elapsed_us() : 0.0;
    const std::size_t stride = find_slopes_stride();
    for (std::size_t i = 0; i < touched_.size(); i += stride) {
        add_slopes(thinning, static_cast<std::size_t>(touched_.begin()[i]), place, X_OT);
        ++touch_.n_sloped;
    }
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
