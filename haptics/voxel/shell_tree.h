// A tool's points so ordered that whatever touches is found without looking at the rest.
//
// Points are put in order by splitting at the middle leaf across the longest side; 32 that follow each other are a leaf, 8 leaves
// that follow each other a node, 8 of those a node above, up to one group of 8 at most. No pointers: node j of level l + 1
// holds the nodes 8 j to 8 j + 7 of level l; level 0 is that of the leaves. Each has a ball round its points.
//
// For a budget of time the same shell is there thinned out: of each 2, 4, 8, ... points that follow each other, the one nearest to
// their mean, so that leaf i of thinning m stands for the leaves i 2^m to (i + 1) 2^m - 1.
//
// Thread: build at load, on two threads; read from any. Cost: build O(n log n), 1 us a point; memory 24 bytes a point, as much
// again for what is thinned out, 0.6 for balls.
// Source: nested points and balls by level: J. Barbic, D. James 2008, Six-DoF haptic rendering of contact between geometrically
// complex reduced deformable models, IEEE Trans. Haptics 1(1), section 4.2.
#pragma once

#include "haptics/voxel/distance_field_batch.h"
#include "haptics/voxel/pointshell.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace fulcrum {

/// Balls of eight nodes that follow each other, frame T, metres; a node that is not there has a radius far below 0.
struct alignas(64) EightBalls {
    std::array<float, 8> x{}, y{}, z{}, radius{};
};

class ShellTree {
  public:
    static constexpr std::size_t kWidth = 8;

    /// Refuses a shell without points or with places that are no numbers.
    [[nodiscard]] static Expected<ShellTree> build(const Pointshell& shell);

    [[nodiscard]] std::size_t n_points() const noexcept { return thinned_.front().n; }
    [[nodiscard]] std::size_t n_leaves() const noexcept { return thinned_.front().n_leaves(); }
    /// For each slot the shell's point that lies there.
    [[nodiscard]] const std::vector<std::int32_t>& order() const noexcept { return order_; }

    /// Levels of balls: the last has one group.
    [[nodiscard]] std::size_t n_levels() const noexcept { return levels_.size(); }
    [[nodiscard]] const std::vector<EightBalls>& level(std::size_t l) const noexcept {
        return levels_[l];
    }
    /// Thinnings: number m keeps one point in 2^m; number 0 is the shell itself.
    [[nodiscard]] std::size_t n_thinnings() const noexcept { return thinned_.size(); }
    [[nodiscard]] std::size_t n_leaves(std::size_t thinning) const noexcept {
        return thinned_[thinning].n_leaves();
    }
    [[nodiscard]] ShellPoints points(std::size_t thinning, std::size_t leaf) const noexcept {
        const std::size_t n = kLeafPoints;
        const float* const x = thinned_[thinning].values.data() + kLeafFloats * leaf;
        return {x, x + n, x + 2 * n, x + 3 * n, x + 4 * n, x + 5 * n};
    }
    /// Points of a leaf that count.
    [[nodiscard]] std::size_t count_in(std::size_t thinning, std::size_t leaf) const noexcept {
        return std::min(kLeafPoints, thinned_[thinning].n - leaf * kLeafPoints);
    }
    /// How far the farthest point is from the tool's origin.
    [[nodiscard]] double reach_m() const noexcept { return reach_m_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    // Leaf by leaf x, y, z, nx, ny, nz, so that a leaf is one piece of memory; the last padded.
    struct Points {
        std::size_t n = 0;
        std::vector<float> values;
        [[nodiscard]] std::size_t n_leaves() const noexcept {
            return (n + kLeafPoints - 1) / kLeafPoints;
        }
    };
    static constexpr std::size_t kLeafFloats = 6 * kLeafPoints;
    static Points collect(const Pointshell& shell, const std::vector<std::int32_t>& slots);
    void put_in_order(const Pointshell& shell);
    void thin_out(const Pointshell& shell);
    void enclose();

    std::vector<std::int32_t> order_;
    std::vector<Points> thinned_;
    std::vector<std::vector<EightBalls>> levels_;
    double reach_m_ = 0.0;
};

}  // namespace fulcrum
