// Down the trees of two meshes, one held and one on its in-between way, and down time, to the pairs of leaves that may come near each other:
// as mesh_sweep.h says it.
//
// Thread: any; no allocation.
#pragma once

#include "haptics/continuous/sweep.h"
#include "haptics/continuous/swept_boxes.h"
#include "haptics/continuous/swept_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace fulcrum {

/// Two nodes over a piece of time.
struct SweptNodes {
    std::int32_t fixed = 0;
    std::int32_t moving = 0;
    double begin = 0.0;
    double end = 1.0;
};

/// Walks down both trees and time. `Visit` is asked for two leaves over a piece of time, and tells how much of the way is still of interest.
class MeshDescent {
  public:
    /// Of what comes within `within_m` of each other.
    MeshDescent(const SweptMesh& fixed, const SweptMesh& moving, const InBetweenMotion& motion,
                double within_m) noexcept
        : fixed_(fixed.boxes()),
          moving_(moving.boxes()),
          motion_(motion),
          near_m_(find_near_m(fixed, moving, motion, within_m)) {
        waiting_[0] = {fixed.root(), moving.root(), 0.0, 1.0};
    }

    /// Over [begin, end]; false where there was no room for what waits.
    template <class Visit>
    bool walk(double begin, double end, Visit&& visit) noexcept {
        waiting_[0].begin = begin;
        waiting_[0].end = end;
        n_waiting_ = 1;
        while (n_waiting_ > 0) {
            SweptNodes pair = waiting_[--n_waiting_];
            if (pair.begin > end) {
                continue;
            }
            pair.end = std::min(pair.end, end);
            const SweptBoxes look = look_at(pair);
            if (!look.may_touch) {
                continue;
            }
            if (fixed_.first_child(pair.fixed) < 0 && moving_.first_child(pair.moving) < 0) {
                end = visit(pair, end);
            } else if (!split(pair, look.is_mostly_motion)) {
                return false;
            }
        }
        return true;
    }
    [[nodiscard]] std::int64_t n_box_pairs() const noexcept { return n_box_pairs_; }

  private:
    static constexpr double kShortestPiece = 0x1.0p-40;  // is not halved
    // A tree of n triangles is at most log(n) / log(8/7) deep, time 40 halves: two trees of 2^31 triangles fit, and time.
    static constexpr std::size_t kWaiting = 512;

    static double find_near_m(const SweptMesh& fixed, const SweptMesh& moving,
                              const InBetweenMotion& motion, double within_m) noexcept {
        const SweepBounds bounds =
            SweepBounds::of(motion, moving.reach_m() + motion.pivot_B().norm(), fixed.reach_m(),
                            {.touch_m = within_m, .tolerance_m = within_m});
        return bounds.touch_m + bounds.slack_m;
    }
    SweptBoxes look_at(const SweptNodes& pair) noexcept {
        ++n_box_pairs_;
        if (pair.begin != piece_.begin || pair.end != piece_.end || n_box_pairs_ == 1) {
            piece_ = TimePiece::of(motion_, pair.begin, pair.end);
        }
        return look_at_boxes(fixed_.box(pair.fixed), moving_.box(pair.moving), motion_.pivot_B(),
                             piece_, near_m_);
    }
    static float size_of(const OrientedBox& box) noexcept {
        return box.half_size[0] * box.half_size[0] + box.half_size[1] * box.half_size[1] +
               box.half_size[2] * box.half_size[2];
    }
    bool split(const SweptNodes& pair, bool is_mostly_motion) noexcept {
        if (n_waiting_ + 2 > kWaiting) {
            return false;
        }
        SweptNodes first = pair;
        SweptNodes second = pair;
        const std::int32_t fixed_child = fixed_.first_child(pair.fixed);
        const std::int32_t moving_child = moving_.first_child(pair.moving);
        if (is_mostly_motion && pair.end - pair.begin > kShortestPiece) {
            first.end = second.begin = 0.5 * pair.begin + 0.5 * pair.end;
        } else if (moving_child < 0 ||
                   (fixed_child >= 0 &&
                    size_of(fixed_.box(pair.fixed)) >= size_of(moving_.box(pair.moving)))) {
            first.fixed = fixed_child;
            second.fixed = fixed_child + 1;
        } else {
            first.moving = moving_child;
            second.moving = moving_child + 1;
        }
        waiting_[n_waiting_++] = second;
        waiting_[n_waiting_++] = first;
        return true;
    }

    const ObbForest& fixed_;
    const ObbForest& moving_;
    const InBetweenMotion& motion_;
    double near_m_;
    TimePiece piece_{};
    std::size_t n_waiting_ = 0;
    std::int64_t n_box_pairs_ = 0;
    std::array<SweptNodes, kWaiting> waiting_;  // filled as it grows
};

}  // namespace fulcrum
