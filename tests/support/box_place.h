// Where a god-object belongs that touches a box from outside, exactly.
//
// It keeps the face through which the hand first went, at the hand's foot on that face's plane, until the foot leaves
// the face or the hand comes out through it; then it is at the hand. As the box is convex, beyond a face's border the way from the foot
// to the hand is free.
#pragma once

#include "haptics/math/spatial.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

class BoxPlace {
  public:
    /// A box of `size_m` about the origin; the hand starts outside.
    BoxPlace(const Vector3& size_m, const Vector3& hand_B)
        : half_m_(0.5 * size_m), hand_B_(hand_B) {}

    /// The hand goes straight on to `hand_B`, in the box's frame; returns the place.
    Vector3 step(const Vector3& hand_B) {
        if (axis_ < 0) {
            find_entry(hand_B);
        }
        hand_B_ = hand_B;
        if (axis_ >= 0 && !is_held(hand_B)) {
            axis_ = -1;
        }
        Vector3 place_B = hand_B;
        if (axis_ >= 0) {
            place_B[axis_] = side_ * half_m_[axis_];
        }
        return place_B;
    }
    [[nodiscard]] bool is_touching() const { return axis_ >= 0; }
    /// Outwards, of the face that is touched; zero when none is.
    [[nodiscard]] Vector3 normal_B() const {
        return axis_ >= 0 ? Vector3(side_ * Vector3::Unit(axis_)) : Vector3(Vector3::Zero());
    }

  private:
    void find_entry(const Vector3& to_B) {
        double enter = 0.0;
        double leave = 1.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double way = to_B[axis] - hand_B_[axis];
            const double side = way > 0.0 ? -1.0 : 1.0;
            const double t_in = (side * half_m_[axis] - hand_B_[axis]) / way;
            const double t_out = (-side * half_m_[axis] - hand_B_[axis]) / way;
            if (way == 0.0) {
                leave = std::abs(to_B[axis]) > half_m_[axis] ? -1.0 : leave;
                continue;
            }
            if (t_in > enter) {
                enter = t_in;
                axis_ = axis;
                side_ = side;
            }
            leave = std::min(leave, t_out);
        }
        axis_ = enter < leave ? axis_ : -1;
    }
    [[nodiscard]] bool is_held(const Vector3& hand_B) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (axis != axis_ && std::abs(hand_B[axis]) > half_m_[axis]) {
                return false;
            }
        }
        return side_ * hand_B[axis_] < half_m_[axis_];
    }

    Vector3 half_m_;
    Vector3 hand_B_;
    int axis_ = -1;
    double side_ = 1.0;
};

}  // namespace fulcrum
