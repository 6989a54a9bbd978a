// An arm's numbers as matrices of a library that solves any system, and back: for tests that judge by it.
#pragma once

#include "haptics/device/arm/joint_matrix.h"
#include "haptics/math/to_eigen.h"

namespace fulcrum::arm_test {

inline JointVector to_joints(const Eigen::VectorXd& v) {
    JointVector joints(v.size());
    for (Index i = 0; i < v.size(); ++i) {
        joints(i) = v(i);
    }
    return joints;
}
inline JointMatrix to_joint_matrix(const Eigen::MatrixXd& m) {
    JointMatrix joints(m.rows(), m.cols());
    for (Index j = 0; j < m.cols(); ++j) {
        for (Index i = 0; i < m.rows(); ++i) {
            joints(i, j) = m(i, j);
        }
    }
    return joints;
}

}  // namespace fulcrum::arm_test
