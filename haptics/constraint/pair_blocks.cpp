#include "haptics/constraint/pair_blocks.h"

namespace fulcrum {
namespace {

constexpr double kSameOffset = 1.0e-9;  // metres

// K X: what b's twist is when a's is given.
Matrix6 move_columns(const Matrix6& K, const Vector3& offset) noexcept {
    const Matrix3 skew = compute_skew(offset);
    Matrix6 moved = K;
    moved.rightCols<3>() -= K.leftCols<3>() * skew;
    return moved;
}
// X^T K.
Matrix6 move_rows(const Matrix6& K, const Vector3& offset) noexcept {
    const Matrix3 skew = compute_skew(offset);
    Matrix6 moved = K;
    moved.bottomRows<3>() += skew * K.topRows<3>();
    return moved;
}

}  // namespace

void add_body_blocks(std::span<const ConstrainedBody> bodies, BlockSystem& matrix) noexcept {
    int i = 0;
    for (const ConstrainedBody& body : bodies) {
        Matrix6& block = matrix.diagonal(i++);
        block.topLeftCorner<3, 3>().diagonal() += Vector3::Constant(body.mass_kg);
        block.bottomRightCorner<3, 3>() += body.inertia_W;
    }
}

bool share_offset(const ContactConstraint& first, const ContactConstraint& other) noexcept {
    if (first.body_a != other.body_a || first.body_b != other.body_b) {
        return false;
    }
    return first.body_a == kGround || first.body_b == kGround ||
           (other.arm_a - other.arm_b - first.arm_a + first.arm_b).cwiseAbs().maxCoeff() <=
               kSameOffset;
}

void add_pair_blocks(const ContactConstraint& contact, const PairStiffness& pair,
                     BlockSystem& matrix) noexcept {
    const Matrix6& K = pair.matrix();
    if (contact.body_a == kGround || contact.body_b == kGround) {
        // Each about its own arm, so there is nothing to move.
        matrix.diagonal(contact.body_a == kGround ? contact.body_b : contact.body_a) += K;
        return;
    }
    const Vector3 offset = contact.arm_a - contact.arm_b;
    const Matrix6 across = move_columns(K, offset);
    matrix.diagonal(contact.body_b) += K;
    matrix.diagonal(contact.body_a) += move_rows(across, offset);
    matrix.add(contact.body_b, contact.body_a, -across, -move_rows(K, offset).transpose());
}

void add_row_blocks(const RowConstraint& row, double stiffness, BlockSystem& matrix) noexcept {
    const Vector6 a = stiffness * row.jacobian_a;
    const Vector6 b = stiffness * row.jacobian_b;
    if (row.body_a != kGround) {
        matrix.diagonal(row.body_a) += a * row.jacobian_a.transpose();
    }
    if (row.body_b != kGround) {
        matrix.diagonal(row.body_b) += b * row.jacobian_b.transpose();
    }
    if (row.body_a != kGround && row.body_b != kGround) {
        const Matrix6 across = b * row.jacobian_a.transpose();
        matrix.add(row.body_b, row.body_a, across, across);
    }
}

}  // namespace fulcrum
