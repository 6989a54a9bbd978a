// The way between two poses of a rigid body that is known at its ends only: straight on for one point of it, and a turn at constant rate
// about an axis through that point.
//
//   p(t) = c_0 + t d + R(t) r,   R(t) r = (r.u) u + cos(w t) (r - (r.u) u) + sin(w t) u x r,   0 <= t <= 1
// c_0 the pivot at the start, d its way, r = R_0 (p_B - pivot_B), u the axis and 0 <= w <= pi the angle of the shorter turn from start to end.
// So every point's path is four vectors,
//   p(t) = a + t d + cos(w t) b + sin(w t) c,
// and along any direction its second derivative is at most w^2 sqrt((k.b)^2 + (k.c)^2): that is what the sweeps live on.
//
// Frames: A, the frame of the body that is held; B, the moving body's. Where both move, this is the motion of one as seen from the other
// between two of their relative poses: some rigid way between the same ends, as good as any where only the ends are known. A body that
// turned by more than pi is given in pieces.
//
// What is rounded: `pose` gives back both ends to the last bit. A path's four vectors are rounded when they are made; `slack_m` bounds how
// far p(t) of these vectors, in exact arithmetic, may be from X_AB(0) p_B and X_AB(1) p_B at the ends and from a rigid motion on the way.
// Neighbours have a shared corner's path in common, so no crack opens.
//
// Thread: any. Cost: 0.2 us to make; a path 20 ns.
// Source: S. Redon, A. Kheddar, S. Coquillart 2002, Fast continuous collision detection between rigid bodies, Computer Graphics Forum
// 21(3), Eurographics, section on in-between motions: R(t) = cos(wt) A + sin(wt) B + C.
#pragma once

#include "haptics/continuous/interval.h"
#include "haptics/math/spatial.h"

namespace fulcrum {

/// A point's way; in frame A, metres. The part in `t d` is the motion's own.
struct PointPath {
    Vector3 a{Vector3::Zero()};  ///< on the axis
    Vector3 b{Vector3::Zero()};  ///< from there to the point, at the start
    Vector3 c{Vector3::Zero()};  ///< along its turn, as long as b
};

class InBetweenMotion {
  public:
    /// Lengths beyond are refused, metres: what is made of products of four of them stays a number.
    static constexpr double kLargest_m = 1.0e30;

    /// No motion: at the origin.
    InBetweenMotion() noexcept : InBetweenMotion(Pose{}, Pose{}) {}
    /// From one pose to the other, the pivot going straight. Orientations may be off unit length by 1e-6. Poses that are not finite or
    /// not rotations make an invalid motion.
    InBetweenMotion(const Pose& start_AB, const Pose& end_AB,
                    const Vector3& pivot_B = Vector3::Zero()) noexcept;

    [[nodiscard]] bool is_valid() const noexcept { return is_valid_; }
    /// t from 0 to 1: both ends as they were given (their orientations of unit length).
    [[nodiscard]] Pose pose(double t) const noexcept;

    [[nodiscard]] PointPath find_path(const Vector3& point_B) const noexcept;
    /// Where the point is at the turn that `turn_at(t)` gives.
    [[nodiscard]] Vector3 find_place(const PointPath& path, double t,
                                     const SineCosine& turn) const noexcept {
        return path.a + t * travel_A_ + turn.cosine * path.b + turn.sine * path.c;
    }
    /// Its velocity, metres for the whole way.
    [[nodiscard]] Vector3 find_rate(const PointPath& path, const SineCosine& turn) const noexcept {
        return travel_A_ + angle_rad_ * (turn.cosine * path.c - turn.sine * path.b);
    }
    [[nodiscard]] SineCosine turn_at(double t) const noexcept {
        return compute_sine_cosine(t * angle_rad_);
    }
    [[nodiscard]] SineCosineInterval turn_over(const Interval& t) const noexcept {
        return enclose_sine_cosine(angle_rad_ * t);
    }
    /// All places of the point over the times `t`, within 0 and 1.
    [[nodiscard]] IntervalVector enclose(const PointPath& path, const Interval& t) const noexcept;

    /// R(t) R_0 with the turn at t.
    [[nodiscard]] Matrix3 find_rotation(const SineCosine& turn) const noexcept;

    [[nodiscard]] const Vector3& pivot_B() const noexcept { return pivot_B_; }
    /// The pivot where it starts.
    [[nodiscard]] const Vector3& pivot_start_A() const noexcept { return pivot_start_A_; }
    [[nodiscard]] const Vector3& travel_A() const noexcept { return travel_A_; }
    [[nodiscard]] const Vector3& axis_A() const noexcept { return axis_A_; }
    [[nodiscard]] double angle_rad() const noexcept { return angle_rad_; }
    /// How far any point within `reach_m` of the pivot goes at most.
    [[nodiscard]] double find_longest_way_m(double reach_m) const noexcept {
        return (travel_A_.norm() + angle_rad_ * reach_m) * (1.0 + 1.0e-12);
    }
    /// See above, of points within `reach_m` of the pivot.
    [[nodiscard]] double find_slack_m(double reach_m) const noexcept {
        constexpr double kRoundings = 0x1.0p-46;  // 64 roundings of 2^-52
        return kRoundings * (size_m_ + reach_m);
    }
    [[nodiscard]] double distance_to_pivot_m(const Vector3& point_B) const noexcept {
        return (point_B - pivot_B_).norm();
    }

  private:
    Pose start_AB_;
    Pose end_AB_;
    Vector3 pivot_B_{Vector3::Zero()};
    Vector3 pivot_start_A_{Vector3::Zero()};
    Vector3 travel_A_{Vector3::Zero()};
    Vector3 axis_A_{Vector3::UnitX()};
    Matrix3 start_turn_{Matrix3::Identity()};
    double angle_rad_ = 0.0;
    double size_m_ = 0.0;  // of all lengths that went into it
    bool is_valid_ = false;
};

}  // namespace fulcrum
