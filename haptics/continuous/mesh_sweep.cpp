#include "haptics/continuous/mesh_sweep.h"

#include "haptics/continuous/swept_boxes.h"
#include "haptics/continuous/triangle_sweep.h"

#include <algorithm>

namespace fulcrum {
namespace {

// A piece of time shorter than this is not halved.
constexpr double kShortestPiece = 0x1.0p-40;

// Two nodes over a piece of time.
struct NodePair {
    std::int32_t fixed = 0;
    std::int32_t moving = 0;
    double begin = 0.0;
    double end = 1.0;
};

// Walks down both trees and time. `Visit` is asked for two leaves over a piece of time, and tells how much of the way is still of interest.
class Descent {
  public:
    Descent(const SweptMesh& fixed, const SweptMesh& moving, const InBetweenMotion& motion,
            double near_m) noexcept
        : fixed_(fixed.boxes()), moving_(moving.boxes()), motion_(motion), near_m_(near_m) {
        waiting_[0] = {fixed.root(), moving.root(), 0.0, 1.0};
    }

    // Over [begin, end]; false where there was no room for what waits.
    template <class Visit>
    bool walk(double begin, double end, Visit&& visit) noexcept {
        waiting_[0].begin = begin;
        waiting_[0].end = end;
        n_waiting_ = 1;
        while (n_waiting_ > 0) {
            NodePair pair = waiting_[--n_waiting_];
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
    // A tree of n triangles is at most log(n) / log(8/7) deep, time 40 halves: two trees of 2^31 triangles fit, and time.
    static constexpr std::size_t kWaiting = 512;

    SweptBoxes look_at(const NodePair& pair) noexcept {
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
    bool split(const NodePair& pair, bool is_mostly_motion) noexcept {
        if (n_waiting_ + 2 > kWaiting) {
            return false;
        }
        NodePair first = pair;
        NodePair second = pair;
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
    std::array<NodePair, kWaiting> waiting_;  // filled as it grows
};

// The triangles of two leaves over a piece of time; what is found goes into `found` where it is earlier.
void sweep_leaves(const SweptMesh& fixed, const SweptMesh& moving, const InBetweenMotion& motion,
                  const SweepSettings& settings, const NodePair& leaves,
                  MeshSweep& found) noexcept {
    for (const std::int32_t i : fixed.boxes().triangles_of(leaves.fixed)) {
        for (const std::int32_t j : moving.boxes().triangles_of(leaves.moving)) {
            ++found.n_triangle_pairs;
            const TriangleSweep told = sweep_triangles(
                motion, fixed.triangle(i), MovingTriangle::of(motion, moving.triangle(j)), settings,
                leaves.begin, leaves.end);
            const bool is_first =
                found.outcome == SweepOutcome::free || told.contact.time < found.contact.time;
            if (told.outcome != SweepOutcome::free && is_first) {
                found.outcome = told.outcome;
                found.contact = told.contact;
                found.fixed_triangle = i;
                found.moving_triangle = j;
            }
        }
    }
}

double find_near_m(const SweptMesh& fixed, const SweptMesh& moving, const InBetweenMotion& motion,
                   double within_m) noexcept {
    const SweepBounds bounds =
        SweepBounds::of(motion, moving.reach_m() + motion.pivot_B().norm(), fixed.reach_m(),
                        {.touch_m = within_m, .tolerance_m = within_m});
    return bounds.touch_m + bounds.slack_m;
}

}  // namespace

MeshSweep sweep_meshes(const SweptMesh& fixed, const SweptMesh& moving,
                       const InBetweenMotion& motion, const SweepSettings& settings) noexcept {
    MeshSweep found;
    if (!motion.is_valid() || !is_valid(settings)) {
        found.outcome = SweepOutcome::invalid;
        return found;
    }
    Descent descent(fixed, moving, motion, find_near_m(fixed, moving, motion, settings.touch_m));
    const bool is_whole = descent.walk(0.0, 1.0, [&](const NodePair& leaves, double end) {
        sweep_leaves(fixed, moving, motion, settings, leaves, found);
        return found.outcome == SweepOutcome::free ? end : std::min(end, found.contact.time);
    });
    found.n_box_pairs = descent.n_box_pairs();
    if (!is_whole) {
        found.outcome = SweepOutcome::invalid;
    }
    return found;
}

bool collect_near(const SweptMesh& fixed, const SweptMesh& moving, const InBetweenMotion& motion,
                  double t, double within_m, BoundedList<NearTriangles>& near) noexcept {
    near.clear();
    if (!motion.is_valid() || !(t >= 0.0 && t <= 1.0) || !(within_m >= 0.0)) {
        return false;
    }
    const SineCosine turn = motion.turn_at(t);
    bool has_room = true;
    Descent descent(fixed, moving, motion, find_near_m(fixed, moving, motion, within_m));
    const bool is_whole = descent.walk(t, t, [&](const NodePair& leaves, double end) {
        for (const std::int32_t i : fixed.boxes().triangles_of(leaves.fixed)) {
            for (const std::int32_t j : moving.boxes().triangles_of(leaves.moving)) {
                const MovingTriangle triangle = MovingTriangle::of(motion, moving.triangle(j));
                const NearFeatures features =
                    find_nearest_features(fixed.triangle(i), triangle.find_place(motion, t, turn));
                if (features.distance_m <= within_m) {
                    has_room = near.add({i, j, features}) && has_room;
                }
            }
        }
        return has_room ? end : -1.0;
    });
    return has_room && is_whole;
}

}  // namespace fulcrum
