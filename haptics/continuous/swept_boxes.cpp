#include "haptics/continuous/swept_boxes.h"

#include <cmath>

namespace fulcrum {
namespace {

Matrix3 rows_of(const OrientedBox& box) noexcept {
    Matrix3 rows;
    rows << box.axis(0).transpose(), box.axis(1).transpose(), box.axis(2).transpose();
    return rows;
}

Vector3 half_of(const OrientedBox& box) noexcept {
    return {static_cast<double>(box.half_size[0]), static_cast<double>(box.half_size[1]),
            static_cast<double>(box.half_size[2])};
}

// Along the axis i of the held box times the axis j of the moving one: in the held box's frame d between the middles, w the way, m the moving
// one's axes.
bool is_apart_across(int i, int j, const Vector3& d, const Vector3& w, const Matrix3& m,
                     const Matrix3& m_size, const Vector3& t, const Vector3& t_moving,
                     double margin) noexcept {
    const int i1 = (i + 1) % 3;
    const int i2 = (i + 2) % 3;
    const int j1 = (j + 1) % 3;
    const int j2 = (j + 2) % 3;
    const double between = std::abs(d[i2] * m(i1, j) - d[i1] * m(i2, j));
    const double way = std::abs(w[i2] * m(i1, j) - w[i1] * m(i2, j));
    const double reach = t[i1] * m_size(i2, j) + t[i2] * m_size(i1, j) +
                         t_moving[j1] * m_size(i, j2) + t_moving[j2] * m_size(i, j1);
    return between > reach + way + margin;
}

}  // namespace

TimePiece TimePiece::of(const InBetweenMotion& motion, double begin, double end) noexcept {
    TimePiece piece;
    piece.begin = begin;
    piece.end = end;
    // Rounded up, and measured from a middle that is rounded itself.
    piece.half = 0.5 * (end - begin) * (1.0 + 1.0e-12) + 1.0e-15;
    const double middle = 0.5 * begin + 0.5 * end;
    piece.turn = motion.find_rotation(motion.turn_at(middle));
    piece.pivot_A = motion.pivot_start_A() + middle * motion.travel_A();
    piece.velocity_A = motion.travel_A();
    piece.angle_rad = motion.angle_rad();
    piece.spin_A = piece.angle_rad * motion.axis_A();
    return piece;
}

SweptBoxes look_at_boxes(const OrientedBox& fixed, const OrientedBox& moving,
                         const Vector3& pivot_B, const TimePiece& piece, double near_m) noexcept {
    // A box is what lies within its half sizes h in its frame A as that was rounded to single numbers: A = R + D, R a rotation, each of the
    // nine entries of D at most 2^-25, so |D| <= 9e-8, and A^-1 is off A^T by 2 |D| at most, as the product of two of its rows is off the
    // third. Along an axis a box reaches farther than (A l) . h by 2 |D| |h|, both together by 4 e-7 size. Across two axes four more
    // terms are taken from products of rows: 2 |D| sqrt(3) size each box, 6.3e-7 size. That is below 1e-6 of 2 size; the way and what
    // is between the middles are off by 2 |D| in A^-1 and in the products, some 5.4e-7 of their lengths. Roundings in double numbers are
    // 1e-15 of all this.
    constexpr double kFrameError = 1.0e-6;
    const Vector3 t = half_of(fixed);
    const Vector3 t_moving = half_of(moving);
    const Vector3 middle_B(static_cast<double>(moving.centre[0]),
                           static_cast<double>(moving.centre[1]),
                           static_cast<double>(moving.centre[2]));
    const Vector3 arm_A = piece.turn * (middle_B - pivot_B);
    const Vector3 velocity = piece.velocity_A + piece.spin_A.cross(arm_A);
    const Vector3 between = fixed.from_centre(piece.pivot_A + arm_A);
    const double size = std::sqrt(std::max(t.squaredNorm(), t_moving.squaredNorm()));
    const double turned = piece.angle_rad * piece.half;
    const double bend = 0.5 * turned * turned * arm_A.norm() + turned * t_moving.norm();
    const double way = velocity.norm() * piece.half;
    const double margin =
        bend + near_m + kFrameError * (2.0 * size + way + between.cwiseAbs().sum());

    const Matrix3 rows = rows_of(fixed);
    const Matrix3 moving_rows = rows_of(moving) * piece.turn.transpose();
    const Vector3 d = rows * between;
    const Vector3 w = piece.half * (rows * velocity);
    const Matrix3 m = rows * moving_rows.transpose();
    const Matrix3 m_size = m.cwiseAbs();
    SweptBoxes look{.is_mostly_motion = way + bend > size};
    look.may_touch = false;
    const Vector3 reach = t + m_size * t_moving + w.cwiseAbs();
    if ((d.cwiseAbs() - reach).maxCoeff() > margin) {
        return look;
    }
    const Vector3 d_moving = moving_rows * between;
    const Vector3 w_moving = piece.half * (moving_rows * velocity);
    const Vector3 reach_moving = t_moving + m_size.transpose() * t + w_moving.cwiseAbs();
    if ((d_moving.cwiseAbs() - reach_moving).maxCoeff() > margin) {
        return look;
    }
    for (int axes = 0; axes < 9; ++axes) {
        if (is_apart_across(axes / 3, axes % 3, d, w, m, m_size, t, t_moving, margin)) {
            return look;
        }
    }
    look.may_touch = true;
    return look;
}

}  // namespace fulcrum
