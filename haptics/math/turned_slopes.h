// A wrench's derivatives by the body's pose (wrench_jacobian.h) along other axes, and those of a wrench that turns with the body.
//
//   R J R^T in each 3 x 3 block: rows and columns along W where they were along B
//   F and torque fixed in the body:  dF = dtheta x F = -[F] dtheta,  likewise the torque
//
// Thread: any. Cost: eight products of 3 x 3 matrices; six subtractions.
#pragma once

#include "haptics/math/wrench_jacobian.h"

namespace fulcrum {

/// The derivatives along W, R = R_WB.
[[nodiscard]] inline Matrix6 compute_turned(const Matrix6& slopes_B, const Matrix3& R) noexcept {
    Matrix6 turned;
    for (Index row = 0; row < 6; row += 3) {
        for (Index column = 0; column < 6; column += 3) {
            turned.block<3, 3>(row, column) =
                R * Matrix3(slopes_B.block<3, 3>(row, column)) * R.transpose();
        }
    }
    return turned;
}

/// Adds what comes of the wrench's turning with the body.
inline void add_turning(const Wrench& wrench_W, Matrix6& pose) noexcept {
    pose.topRightCorner<3, 3>() -= compute_skew(wrench_W.force);
    pose.bottomRightCorner<3, 3>() -= compute_skew(wrench_W.torque);
}

}  // namespace fulcrum
