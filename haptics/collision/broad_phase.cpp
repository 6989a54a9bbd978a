#include "haptics/collision/broad_phase.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

// How much more another axis has to be spread to be taken.
constexpr double kMoreSpread = 2.0;

// Below 0 where they overlap, by the axis along which they do least.
double find_box_gap(const Box& a, const Box& b) noexcept {
    return (a.lower - b.upper).cwiseMax(b.lower - a.upper).maxCoeff();
}

}  // namespace

BroadPhase::BroadPhase(int max_bodies, int max_pairs)
    : order_(max_bodies), near_(max_pairs), pairs_(max_pairs) {}

void BroadPhase::take_order(std::size_t n_boxes) noexcept {
    if (order_.count() == n_boxes) {
        return;
    }
    order_.clear();
    for (std::size_t i = 0; i < n_boxes; ++i) {
        order_.add(static_cast<std::int32_t>(i));
    }
}

void BroadPhase::choose_axis(std::span<const Box> boxes) noexcept {
    Vector3 sum = Vector3::Zero();
    Vector3 squares = Vector3::Zero();
    double n = 0.0;
    for (const Box& box : boxes) {
        const Vector3 middle = 0.5 * (box.lower + box.upper);
        if (middle.allFinite()) {
            sum += middle;
            squares += middle.cwiseAbs2();
            n += 1.0;
        }
    }
    const Vector3 spread = squares * n - sum.cwiseAbs2();
    int widest = 0;
    const double most = spread.maxCoeff(&widest);
    if (most > kMoreSpread * spread[axis_]) {
        axis_ = widest;
    }
}

// By insertion: what is nearly in order costs little.
void BroadPhase::sort(std::span<const Box> boxes) noexcept {
    const auto low_of = [&](std::int32_t i) noexcept {
        const double low = boxes[static_cast<std::size_t>(i)].lower[axis_];
        return std::isnan(low) ? std::numeric_limits<double>::infinity() : low;
    };
    const auto is_before = [&](std::int32_t a, std::int32_t b) noexcept {
        const double low_a = low_of(a);
        const double low_b = low_of(b);
        return low_a < low_b || (low_a == low_b && a < b);
    };
    for (std::size_t i = 1; i < order_.count(); ++i) {
        const std::int32_t body = order_[i];
        std::size_t to = i;
        for (; to > 0 && is_before(body, order_[to - 1]); --to) {
            order_[to] = order_[to - 1];
        }
        order_[to] = body;
    }
}

// Once there is no more room they are a heap, the farthest first, which goes where another one is nearer.
void BroadPhase::add(const NearPair& pair) noexcept {
    if (near_.add(pair)) {
        return;
    }
    const auto all = near_.all();
    if (n_dropped_++ == 0) {
        std::make_heap(all.begin(), all.end());
    }
    if (!all.empty() && pair < all.front()) {
        std::pop_heap(all.begin(), all.end());
        all.back() = pair;
        std::push_heap(all.begin(), all.end());
    }
}

std::span<const BodyPair> BroadPhase::find_pairs(std::span<const Box> boxes,
                                                 std::span<const std::uint8_t> moves,
                                                 std::span<const double> reaches_m) noexcept {
    boxes = boxes.first(std::min(boxes.size(), order_.capacity()));
    const auto reach_of = [&](std::size_t i) noexcept {
        return i < reaches_m.size() ? reaches_m[i] : 0.0;
    };
    near_.clear();
    pairs_.clear();
    n_dropped_ = 0;
    take_order(boxes.size());
    choose_axis(boxes);
    sort(boxes);
    for (std::size_t i = 0; i < order_.count(); ++i) {
        const auto a = static_cast<std::size_t>(order_[i]);
        const Box& box = boxes[a];
        for (std::size_t k = i + 1; k < order_.count(); ++k) {
            const auto b = static_cast<std::size_t>(order_[k]);
            if (boxes[b].lower[axis_] > box.upper[axis_]) {
                break;
            }
            if ((moves[a] != 0 || moves[b] != 0) && box.overlaps(boxes[b])) {
                add({find_box_gap(box, boxes[b]) + reach_of(a) + reach_of(b),
                     {std::min(order_[i], order_[k]), std::max(order_[i], order_[k])}});
            }
        }
    }
    for (const NearPair& pair : near_.all()) {
        pairs_.add(pair.bodies);
    }
    std::sort(pairs_.all().begin(), pairs_.all().end());
    return pairs_.all();
}

}  // namespace fulcrum
