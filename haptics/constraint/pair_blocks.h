// What contacts and rows add to the bodies' matrix: J^T S J of each, as 6 x 6 blocks of block_system.h.
//
// The contacts of one pair of bodies add up before they are moved to where the other body is: with the arms r from b,
//   K = sum [G, -G [r]; [r] G, -[r] G [r]],   G = A S A^T, A the contact's axes, [r] the matrix of the cross product
// and a's twist is b's through X = [1, -[offset]; 0, 1], offset = arm_a - arm_b, which contacts of a pair share.
//
// Thread: that of the solver. Cost: some 100 multiplications a contact, 500 a pair.
#pragma once

#include "haptics/constraint/block_system.h"
#include "haptics/math/rotation.h"

#include <span>

namespace fulcrum {

/// Adds M.
void add_body_blocks(std::span<const ConstrainedBody> bodies, BlockSystem& matrix) noexcept;

class PairStiffness {
  public:
    /// Any G.
    void add(const Matrix3& G, const Vector3& arm) noexcept {
        const Matrix3 skew = compute_skew(arm);
        const Matrix3 turned = skew * G;
        K_.topLeftCorner<3, 3>() += G;
        K_.bottomLeftCorner<3, 3>() += turned;
        K_.topRightCorner<3, 3>() -= G * skew;
        K_.bottomRightCorner<3, 3>() -= turned * skew;
    }
    /// The same for G = D 1, where the products are known.
    void add(double D, const Vector3& arm) noexcept {
        const double square = arm.squaredNorm();
        for (int i = 0; i < 3; ++i) {
            K_(i, i) += D;
            K_(3 + i, 3 + i) += D * square;
            for (int j = 0; j < 3; ++j) {
                K_(3 + i, 3 + j) -= D * arm[i] * arm[j];
            }
        }
        const Matrix3 skew = D * compute_skew(arm);
        K_.bottomLeftCorner<3, 3>() += skew;
        K_.topRightCorner<3, 3>() -= skew;
    }
    [[nodiscard]] const Matrix6& matrix() const noexcept { return K_; }

  private:
    Matrix6 K_ = Matrix6::Zero();
};

/// Adds what the contacts of a pair came to, about b or, where b is the ground, about the point itself.
void add_pair_blocks(const ContactConstraint& contact, const PairStiffness& pair,
                     BlockSystem& matrix) noexcept;

/// Whether two contacts of one pair share the bodies' offset.
[[nodiscard]] bool share_offset(const ContactConstraint& first,
                                const ContactConstraint& other) noexcept;

/// Adds all contacts: `add_slope(i, arm, pair)` adds S of contact i to its pair.
template <class AddSlope>
void add_contact_blocks(std::span<const ContactConstraint> contacts, BlockSystem& matrix,
                        AddSlope&& add_slope) noexcept {
    for (std::size_t i = 0; i < contacts.size();) {
        const ContactConstraint& first = contacts[i];
        PairStiffness pair;
        for (; i < contacts.size() && share_offset(first, contacts[i]); ++i) {
            const ContactConstraint& c = contacts[i];
            add_slope(i, c.body_b == kGround ? c.arm_a : c.arm_b, pair);
        }
        add_pair_blocks(first, pair, matrix);
    }
}

/// Adds a row of this stiffness.
void add_row_blocks(const RowConstraint& row, double stiffness, BlockSystem& matrix) noexcept;

}  // namespace fulcrum
