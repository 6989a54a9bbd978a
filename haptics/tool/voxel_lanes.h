// The inner loop of voxel sampling: a pointshell against a voxmap, eight points side by side. Private to voxel_sampling.
//
// Lengths are counted in voxels, places of points in the tool's frame T from its origin. For each point p with inward normal n:
//   g = R p + t               its place in the lattice of the map; the voxel is floor(g), its centre c = floor(g) + 1/2
//   e = c - g,  d = (R n).e   how far it lies beneath the plane through c with normal R n
//   surface, d > d_least      adds  d n  and  d (p x n)                       d_least = 0, or none
//   proximity, n.u < 0        adds  -k u,  p x -k u  and  k = -n.u/|u|        u = v + w x p
// Blocks of 64 points are carried into the lattice first, then looked up, then those eights that hit anything are added up: a
// look at a byte cannot be done side by side, and the two halves keep out of each other's way.
//
// Sums are single within 2048 points and double beyond. A place in the lattice is off by at most
// 2^-24 (3 |p| + n) voxels, n the map's voxels along its longest side: 3e-5 at 512. A point that lies nearer than that to the
// wall between two voxels may count for the other one.
//
// Thread: that of the step. Cost: about 0.6 ns a point that touches nothing, 3 ns more for each eight that do.
#pragma once

#include "haptics/math/spatial.h"
#include "haptics/math/wrench_jacobian.h"
#include "haptics/voxel/voxmap.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace fulcrum::voxel_lanes {

// The compilers we know lower these to whatever the processor has.
using Floats = float __attribute__((vector_size(32)));
using Ints = std::int32_t __attribute__((vector_size(32)));
using Bytes = std::uint8_t __attribute__((vector_size(8)));

inline constexpr std::size_t kLanes = 8;
inline constexpr std::size_t kBlock = 64;
inline constexpr std::size_t kChunk = 2048;  ///< points that are summed in single precision

/// A pointshell in voxels, padded with points that are never in the map.
struct Shell {
    std::array<std::vector<float>, 3> place, normal;
    std::size_t n_points = 0;

    [[nodiscard]] std::size_t padded_size() const noexcept { return place[0].size(); }
};

/// The tool's pose and motion as the map sees them.
struct Motion {
    std::array<std::array<float, 3>, 3> turn{};  ///< R
    std::array<float, 3> shift{};                ///< t
    std::array<float, 3> last{};  ///< greatest place that counts, in the outermost voxel
    std::array<float, 3> velocity_T{}, spin_T{};  ///< voxels/s, rad/s
    float least_depth = 0.0F;
    bool brakes = false;
};

/// What the points add up to; frame T, voxels.
struct Sums {
    std::array<double, 6> push{};   ///< d n, d (p x n)
    double fullness = 0.0;          ///< min(2 |d|, 1) over the pushing points
    std::array<double, 6> brake{};  ///< -k u, p x -k u
    double brake_share = 0.0;       ///< k
    std::int64_t n_surface = 0, n_interior = 0, n_proximity = 0;
    // With derivatives only: what d and the brakes change by with the tool's pose and velocity (wrench_jacobian.h).
    Matrix6 push_by_pose{Matrix6::Zero()};  ///< without that of n and p x n themselves
    Vector6 fullness_by_pose{Vector6::Zero()};
    WrenchJacobian brake_by{};
};

/// Where a block of points lies.
struct Block {
    alignas(32) std::array<std::array<float, kBlock>, 3> place;
    alignas(32) std::array<std::array<std::int32_t, kBlock>, 3> cell;
    alignas(32) std::array<std::uint8_t, kBlock> kind;
};

/// A byte a voxel.
class GridMap {
  public:
    explicit GridMap(const VoxelGrid& grid) noexcept
        : cells_(grid.cells.data()), nx_(grid.frame.n_cells[0]), ny_(grid.frame.n_cells[1]) {}
    /// Reads the kinds of the block's cells.
    void look_up(Block& block) const noexcept {
        for (std::size_t i = 0; i < kBlock; i += kLanes) {
            Ints x, y, z;
            std::memcpy(&x, &block.cell[0][i], sizeof x);
            std::memcpy(&y, &block.cell[1][i], sizeof y);
            std::memcpy(&z, &block.cell[2][i], sizeof z);
            x += (z * ny_ + y) * nx_;
            std::memcpy(&block.cell[0][i], &x, sizeof x);
        }
        for (std::size_t i = 0; i < kBlock; ++i) {
            block.kind[i] = static_cast<std::uint8_t>(cells_[block.cell[0][i]]);
        }
    }

  private:
    const VoxelClass* cells_;
    std::int32_t nx_, ny_;
};

/// A 512-tree.
class TreeMap {
  public:
    explicit TreeMap(const Voxmap& map) noexcept : map_(&map) {}
    void look_up(Block& block) const noexcept {
        for (std::size_t i = 0; i < kBlock; ++i) {
            block.kind[i] = static_cast<std::uint8_t>(
                map_->find_class({block.cell[0][i], block.cell[1][i], block.cell[2][i]}));
        }
    }

  private:
    const Voxmap* map_;
};

namespace details {

inline constexpr std::uint64_t kOnes = 0x0101010101010101ULL;

struct LaneSums {
    std::array<Floats, 6> push{};
    Floats fullness{};
    std::array<Floats, 6> brake{};
    Floats brake_share{};
};

/// Of eight points: places in T and normals in T, e in the map.
struct Eight {
    std::array<Floats, 3> p, n, e;
    Floats depth;
    Ints kind;
};

inline void find_cells(const Shell& shell, const Motion& motion, std::size_t first, Block& block) {
    for (std::size_t i = 0; i < kBlock; i += kLanes) {
        Floats x, y, z;
        std::memcpy(&x, &shell.place[0][first + i], sizeof x);
        std::memcpy(&y, &shell.place[1][first + i], sizeof y);
        std::memcpy(&z, &shell.place[2][first + i], sizeof z);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto& row = motion.turn[axis];
            Floats g = row[0] * x + row[1] * y + row[2] * z + motion.shift[axis];
            // What lies outside counts as the outermost voxel, which is free. No number becomes 0, which is one too.
            g = g > 0.0F ? g : Floats{};
            const Floats last = Floats{} + motion.last[axis];
            g = g < last ? g : last;
            const Ints cell = __builtin_convertvector(g, Ints);
            std::memcpy(&block.place[axis][i], &g, sizeof g);
            std::memcpy(&block.cell[axis][i], &cell, sizeof cell);
        }
    }
}

inline void load_eight(const Shell& shell, const Motion& motion, const Block& block,
                       std::size_t first, std::size_t i, Eight& eight) {
    Bytes kind;
    std::memcpy(&kind, &block.kind[i], sizeof kind);
    eight.kind = __builtin_convertvector(kind, Ints);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::memcpy(&eight.p[axis], &shell.place[axis][first + i], sizeof(Floats));
        std::memcpy(&eight.n[axis], &shell.normal[axis][first + i], sizeof(Floats));
        Floats g;
        std::memcpy(&g, &block.place[axis][i], sizeof g);
        const Ints cell = __builtin_convertvector(g, Ints);
        eight.e[axis] = __builtin_convertvector(cell, Floats) + 0.5F - g;
    }
    eight.depth = Floats{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& row = motion.turn[axis];
        const Floats n_map = row[0] * eight.n[0] + row[1] * eight.n[1] + row[2] * eight.n[2];
        eight.depth += n_map * eight.e[axis];
    }
}

// Adds f and p x f.
inline void add_moment(const Eight& eight, const std::array<Floats, 3>& f,
                       std::array<Floats, 6>& sums) {
    sums[0] += f[0];
    sums[1] += f[1];
    sums[2] += f[2];
    sums[3] += eight.p[1] * f[2] - eight.p[2] * f[1];
    sums[4] += eight.p[2] * f[0] - eight.p[0] * f[2];
    sums[5] += eight.p[0] * f[1] - eight.p[1] * f[0];
}

inline void add_push(const Motion& motion, const Eight& eight, LaneSums& sums) {
    const Floats zero{};
    const Ints pushes = (eight.kind == 2) & (eight.depth > motion.least_depth);
    const Floats d = pushes ? eight.depth : zero;
    add_moment(eight, {d * eight.n[0], d * eight.n[1], d * eight.n[2]}, sums.push);
    const Floats twice = d > zero ? d + d : -d - d;
    sums.fullness += twice < 1.0F ? twice : zero + 1.0F;
}

// One by one: brakes act on few points, and a square root has no operator side by side.
inline void add_brake(const Motion& motion, const Eight& eight, LaneSums& sums) {
    const auto& [vx, vy, vz] = motion.velocity_T;
    const auto& [wx, wy, wz] = motion.spin_T;
    const std::array<Floats, 3> u{vx + (wy * eight.p[2] - wz * eight.p[1]),
                                  vy + (wz * eight.p[0] - wx * eight.p[2]),
                                  vz + (wx * eight.p[1] - wy * eight.p[0])};
    const Floats towards = eight.n[0] * u[0] + eight.n[1] * u[1] + eight.n[2] * u[2];
    const Floats square = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
    const Ints brakes = (eight.kind == 3) & (towards < 0.0F);
    Floats share{};
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        share[lane] = brakes[lane] != 0 ? -towards[lane] / std::sqrt(square[lane]) : 0.0F;
    }
    add_moment(eight, {-share * u[0], -share * u[1], -share * u[2]}, sums.brake);
    sums.brake_share += share;
}

inline double add_lanes(const Floats& lanes) {
    double sum = 0.0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        sum += static_cast<double>(lanes[lane]);
    }
    return sum;
}

inline void add_lanes(const LaneSums& lanes, Sums& sums) {
    for (std::size_t i = 0; i < 6; ++i) {
        sums.push[i] += add_lanes(lanes.push[i]);
        sums.brake[i] += add_lanes(lanes.brake[i]);
    }
    sums.fullness += add_lanes(lanes.fullness);
    sums.brake_share += add_lanes(lanes.brake_share);
}

// d changes by q.dtheta - n.dx with q = n x e - p x n, all in T.
struct LaneSlopes {
    std::array<std::array<Floats, 6>, 6> push{};
    std::array<Floats, 6> fullness{};
};

inline void add_push_slopes(const Motion& motion, const Eight& eight, LaneSlopes& slopes) {
    const Floats zero{};
    const auto& [p, n, e_map, depth, kind] = eight;
    std::array<Floats, 3> e{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        e[axis] = motion.turn[0][axis] * e_map[0] + motion.turn[1][axis] * e_map[1] +
                  motion.turn[2][axis] * e_map[2];
    }
    std::array<Floats, 6> along{n[0], n[1], n[2]};
    std::array<Floats, 6> by{-n[0], -n[1], -n[2]};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t y = (axis + 1) % 3;
        const std::size_t z = (axis + 2) % 3;
        along[3 + axis] = p[y] * n[z] - p[z] * n[y];
        by[3 + axis] = n[y] * e[z] - n[z] * e[y] - along[3 + axis];
    }
    const Ints pushes = (kind == 2) & (depth > motion.least_depth);
    const Ints fills = pushes & (depth < 0.5F) & (depth > -0.5F);
    for (std::size_t row = 0; row < 6; ++row) {
        const Floats pushed = pushes ? along[row] : zero;
        for (std::size_t column = 0; column < 6; ++column) {
            slopes.push[row][column] += pushed * by[column];
        }
        const Floats twice = depth > zero ? by[row] + by[row] : -by[row] - by[row];
        slopes.fullness[row] += fills ? twice : zero;
    }
}

inline void add_lanes(const LaneSlopes& lanes, Sums& sums) {
    for (Eigen::Index row = 0; row < 6; ++row) {
        const auto i = static_cast<std::size_t>(row);
        for (Eigen::Index column = 0; column < 6; ++column) {
            sums.push_by_pose(row, column) +=
                add_lanes(lanes.push[i][static_cast<std::size_t>(column)]);
        }
        sums.fullness_by_pose[row] += add_lanes(lanes.fullness[i]);
    }
}

// One by one, in double: few points brake.
void add_brake_slopes(const Motion& motion, const Eight& eight, Sums& sums) noexcept;

// What a chunk of points adds up to.
struct ChunkSums {
    LaneSums lanes;
    LaneSlopes slopes;
    std::int64_t n_surface = 0, n_interior = 0, n_proximity = 0;
};

// Eight points of which at least one pushes or brakes.
template <bool kLinear>
inline void add_eight(const Shell& shell, const Motion& motion, const Block& block,
                      std::size_t first, std::size_t i, bool brakes, ChunkSums& chunk, Sums& sums) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled by the next line
    Eight eight;
    load_eight(shell, motion, block, first, i, eight);
    add_push(motion, eight, chunk.lanes);
    if (brakes) {
        add_brake(motion, eight, chunk.lanes);
    }
    if constexpr (kLinear) {
        add_push_slopes(motion, eight, chunk.slopes);
        if (brakes) {
            add_brake_slopes(motion, eight, sums);
        }
    }
}

template <bool kLinear>
inline void add_block(const Shell& shell, const Motion& motion, const Block& block,
                      std::size_t first, ChunkSums& chunk, Sums& sums) {
    for (std::size_t i = 0; i < kBlock; i += kLanes) {
        std::uint64_t kinds = 0;
        std::memcpy(&kinds, &block.kind[i], sizeof kinds);
        if (kinds == 0) {
            continue;
        }
        // A byte is 01 interior, 10 surface, 11 proximity.
        const std::uint64_t surface = (kinds >> 1) & ~kinds & kOnes;
        const std::uint64_t proximity = (kinds >> 1) & kinds & kOnes;
        chunk.n_surface += std::popcount(surface);
        chunk.n_proximity += std::popcount(proximity);
        chunk.n_interior += std::popcount(kinds & ~(kinds >> 1) & kOnes);
        const bool brakes = motion.brakes && proximity != 0;
        if (surface != 0 || brakes) {
            add_eight<kLinear>(shell, motion, block, first, i, brakes, chunk, sums);
        }
    }
}

}  // namespace details

/// Adds up all points. `kLinear`: with derivatives.
template <bool kLinear, class Map>
void sample(const Shell& shell, const Map& map, const Motion& motion, Sums& sums) noexcept {
    using namespace details;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): each entry is written before it is read
    Block block;
    for (std::size_t begin = 0; begin < shell.padded_size(); begin += kChunk) {
        const std::size_t end = std::min(begin + kChunk, shell.padded_size());
        ChunkSums chunk;
        for (std::size_t first = begin; first < end; first += kBlock) {
            find_cells(shell, motion, first, block);
            map.look_up(block);
            add_block<kLinear>(shell, motion, block, first, chunk, sums);
        }
        add_lanes(chunk.lanes, sums);
        if constexpr (kLinear) {
            add_lanes(chunk.slopes, sums);
        }
        sums.n_surface += chunk.n_surface;
        sums.n_interior += chunk.n_interior;
        sums.n_proximity += chunk.n_proximity;
    }
}

}  // namespace fulcrum::voxel_lanes
