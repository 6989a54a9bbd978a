#include "haptics/voxel/shell_tree.h"

#include "haptics/base/parallel_for.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace fulcrum {

namespace {

constexpr float kNoBall = -1.0e30F;
constexpr std::size_t kThreads = 2;

Vector3f place_of(const Pointshell& shell, std::int32_t i) {
    const auto at = static_cast<std::size_t>(i);
    return {shell.x_m[at], shell.y_m[at], shell.z_m[at]};
}

// A ball round points from `at(0)` to `at(n - 1)`, a few parts in a hundred larger than the least.
struct Ball {
    Vector3 centre;
    double radius;
};
template <class At>
Ball enclose_points(std::size_t n, const At& at) {
    Vector3 lower = at(0);
    Vector3 upper = lower;
    for (std::size_t i = 1; i < n; ++i) {
        lower = lower.cwiseMin(at(i));
        upper = upper.cwiseMax(at(i));
    }
    Vector3 centre = 0.5 * (lower + upper);
    Ball best{centre, HUGE_VAL};
    // Towards the farthest point, by less each time (Badoiu and Clarkson 2003); the best centre is kept.
    constexpr int kRounds = 12;
    for (int round = 0; round < kRounds; ++round) {
        std::size_t farthest = 0;
        double square = -1.0;
        for (std::size_t i = 0; i < n; ++i) {
            const double other = (at(i) - centre).squaredNorm();
            farthest = other > square ? i : farthest;
            square = std::max(square, other);
        }
        if (square < best.radius * best.radius) {
            best = {centre, std::sqrt(square)};
        }
        centre += (at(farthest) - centre) / (round + 3.0);
    }
    return best;
}

}  // namespace

Expected<ShellTree> ShellTree::build(const Pointshell& shell) {
    if (shell.size() == 0) {
        return fail("a tool without points", {}, "give its shell points");
    }
    for (std::size_t i = 0; i < shell.size(); ++i) {
        if (!shell.position_T(i).allFinite() || !shell.normal_T(i).allFinite()) {
            return fail("point " + std::to_string(i) + " of a tool's shell is no number", {},
                        "make the shell again");
        }
    }
    ShellTree tree;
    tree.put_in_order(shell);
    tree.thin_out(shell);
    tree.enclose();
    return tree;
}

void ShellTree::put_in_order(const Pointshell& shell) {
    order_.resize(shell.size());
    std::iota(order_.begin(), order_.end(), 0);
    using At = std::vector<std::int32_t>::iterator;
    std::vector<std::pair<At, At>> parts{{order_.begin(), order_.end()}};
    while (!parts.empty()) {
        const auto [first, end] = parts.back();
        parts.pop_back();
        const auto n = static_cast<std::size_t>(end - first);
        if (n <= kLeafPoints) {
            continue;
        }
        Vector3f lower = place_of(shell, *first);
        Vector3f upper = lower;
        for (At i = first; i != end; ++i) {
            lower = lower.cwiseMin(place_of(shell, *i));
            upper = upper.cwiseMax(place_of(shell, *i));
        }
        int axis = 0;
        (upper - lower).maxCoeff(&axis);
        // The first part is as many whole leaves as a power of two, so that parts are nodes.
        const std::size_t n_leaves = (n + kLeafPoints - 1) / kLeafPoints;
        const At middle =
            first + static_cast<std::ptrdiff_t>(kLeafPoints * std::bit_floor(n_leaves - 1));
        std::nth_element(first, middle, end, [&](std::int32_t i, std::int32_t j) {
            const float a = place_of(shell, i)[axis];
            const float b = place_of(shell, j)[axis];
            return a < b || (a == b && i < j);
        });
        parts.emplace_back(first, middle);
        parts.emplace_back(middle, end);
    }
}

ShellTree::Points ShellTree::collect(const Pointshell& shell,
                                     const std::vector<std::int32_t>& slots) {
    Points points;
    points.n = slots.size();
    const std::array<const std::vector<float>*, 6> from{&shell.x_m, &shell.y_m, &shell.z_m,
                                                        &shell.nx,  &shell.ny,  &shell.nz};
    points.values.reserve(kLeafFloats * points.n_leaves());
    for (std::size_t leaf = 0; leaf < points.n_leaves(); ++leaf) {
        for (const std::vector<float>* const component : from) {
            for (std::size_t i = 0; i < kLeafPoints; ++i) {
                const std::int32_t slot = slots[std::min(leaf * kLeafPoints + i, points.n - 1)];
                points.values.push_back((*component)[static_cast<std::size_t>(slot)]);
            }
        }
    }
    return points;
}

void ShellTree::thin_out(const Pointshell& shell) {
    thinned_.push_back(collect(shell, order_));
    for (std::size_t share = 2; thinned_.back().n > kLeafPoints; share *= 2) {
        std::vector<std::int32_t> kept;
        for (std::size_t first = 0; first < order_.size(); first += share) {
            const std::size_t end = std::min(order_.size(), first + share);
            Vector3 mean = Vector3::Zero();
            for (std::size_t i = first; i < end; ++i) {
                mean +=
                    place_of(shell, order_[i]).cast<double>() / static_cast<double>(end - first);
            }
            const auto distance = [&](std::int32_t i) {
                return (place_of(shell, i).cast<double>() - mean).squaredNorm();
            };
            kept.push_back(*std::min_element(
                order_.begin() + static_cast<std::ptrdiff_t>(first),
                order_.begin() + static_cast<std::ptrdiff_t>(end),
                [&](std::int32_t i, std::int32_t j) { return distance(i) < distance(j); }));
        }
        thinned_.push_back(collect(shell, kept));
    }
}

void ShellTree::enclose() {
    const Points& all = thinned_.front();
    const auto at = [&](std::size_t i) -> Vector3 {
        const ShellPoints leaf = points(0, i / kLeafPoints);
        const std::size_t slot = i % kLeafPoints;
        return {leaf.x[slot], leaf.y[slot], leaf.z[slot]};
    };
    std::size_t n_nodes = n_leaves();
    for (std::size_t span = kLeafPoints;; span *= kWidth) {
        std::vector<EightBalls> groups((n_nodes + kWidth - 1) / kWidth);
        for (EightBalls& group : groups) {
            group.radius.fill(kNoBall);
        }
        parallel_for(n_nodes, kThreads, [&](std::size_t node) noexcept {
            const std::size_t first = node * span;
            const Ball ball = enclose_points(std::min(span, all.n - first),
                                             [&](std::size_t i) { return at(first + i); });
            EightBalls& group = groups[node / kWidth];
            const std::size_t i = node % kWidth;
            group.x[i] = static_cast<float>(ball.centre.x());
            group.y[i] = static_cast<float>(ball.centre.y());
            group.z[i] = static_cast<float>(ball.centre.z());
            // Room for rounding the centre.
            constexpr double kRounding = 4.0e-7;
            group.radius[i] =
                static_cast<float>(ball.radius + kRounding * (ball.radius + ball.centre.norm()));
        });
        levels_.push_back(std::move(groups));
        if (n_nodes <= kWidth) {
            break;
        }
        n_nodes = (n_nodes + kWidth - 1) / kWidth;
    }
    for (std::size_t i = 0; i < all.n; ++i) {
        reach_m_ = std::max(reach_m_, at(i).norm());
    }
}

std::size_t ShellTree::memory_bytes() const noexcept {
    std::size_t bytes = order_.capacity() * sizeof(std::int32_t);
    for (const Points& points : thinned_) {
        bytes += points.values.capacity() * sizeof(float);
    }
    for (const std::vector<EightBalls>& level : levels_) {
        bytes += level.capacity() * sizeof(EightBalls);
    }
    return bytes;
}

}  // namespace fulcrum
