// How the force of points along slopes changes with the tool's pose, point by point in double precision: what lies deeper than the
// kernels of distance_field_batch.h know, and what they are measured against.
//
// For a point at r from the tool's origin, g the way out, H the second derivatives of the depth D, f = D g, over the stiffness:
//   by the place   S = -(g g^T + D H), symmetric
//   by turning     T = -S [r], rows r x S_i     and below them T^T and [r] T + [f][r], [f][r] = r f^T - (f . r) I
//
// Thread: any; no state but the sum. Cost: 0.1 us a point, with the look at the field.
#pragma once

#include "haptics/math/wrench_jacobian.h"
#include "haptics/voxel/distance_field.h"

#include <array>

namespace fulcrum {

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

}  // namespace fulcrum
