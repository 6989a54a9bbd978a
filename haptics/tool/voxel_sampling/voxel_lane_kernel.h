// The loop of voxel_lanes.h in the namespace FULCRUM_KERNEL. Included once for each version of it, after all other headers: compiler
// switches of that version are on here.
//
// Thread: that of the step. Cost: see voxel_lanes.h.
#include "haptics/tool/voxel_sampling/voxel_lane_maps.h"

// NOLINTBEGIN(misc-definitions-in-headers): each version is a set of functions of its own
namespace fulcrum::voxel_lanes::FULCRUM_KERNEL {
namespace {

constexpr std::uint64_t kOnes = 0x0101010101010101ULL;

struct LaneSums {
    std::array<Floats, 6> push{};
    Floats fullness{};
    std::array<Floats, 6> brake{};
    Floats brake_share{};
};

// Of eight points: places in T and normals in T, e in the map.
struct Eight {
    std::array<Floats, 3> p, n, e;
    Floats depth;
    Ints kind;
};

// A motion's numbers eight times each, so that no loop spreads them again.
struct WideMotion {
    std::array<std::array<Floats, 3>, 3> turn{};
    std::array<Floats, 3> shift{}, last{};
    Floats first{};  // 0: as a variable it makes a maximum of one instruction

    explicit WideMotion(const Motion& motion) {
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t column = 0; column < 3; ++column) {
                turn[row][column] = Floats{} + motion.turn[row][column];
            }
            shift[row] = Floats{} + motion.shift[row];
            last[row] = Floats{} + motion.last[row];
        }
    }
};

// Eight places in the lattice along `axis`, clamped to the map. What lies outside, or is no number, counts as an outermost
// voxel, which is free.
inline void compute_place(const WideMotion& wide, std::size_t axis, const Floats& x,
                          const Floats& y, const Floats& z, Floats& g) {
    const auto& row = wide.turn[axis];
    g = row[0] * x + row[1] * y + row[2] * z + wide.shift[axis];
    g = g < wide.first ? wide.first : g;
    g = g < wide.last[axis] ? g : wide.last[axis];
}

template <class Map>
inline void find_cells(const Shell& shell, const Map& map, const WideMotion& wide,
                       std::size_t first, typename Map::Cells& cells) {
    for (std::size_t i = 0; i < kBlock; i += kLanes) {
        Floats x;
        Floats y;
        Floats z;
        std::memcpy(&x, &shell.place[0][first + i], sizeof x);
        std::memcpy(&y, &shell.place[1][first + i], sizeof y);
        std::memcpy(&z, &shell.place[2][first + i], sizeof z);
        Floats gx;
        Floats gy;
        Floats gz;
        compute_place(wide, 0, x, y, z, gx);
        compute_place(wide, 1, x, y, z, gy);
        compute_place(wide, 2, x, y, z, gz);
        map.note(__builtin_convertvector(gx, Ints), __builtin_convertvector(gy, Ints),
                 __builtin_convertvector(gz, Ints), i, cells);
    }
}

// Calls step(0), step(1), step(2) with numbers known to the compiler.
template <class Step>
inline void for_axes(Step&& step) {
    step(std::integral_constant<std::size_t, 0>{});
    step(std::integral_constant<std::size_t, 1>{});
    step(std::integral_constant<std::size_t, 2>{});
}

inline void unpack(PackedKinds packed, Ints& kind) {
    using Halves = std::uint64_t __attribute__((vector_size(32)));
    using Unsigned = std::uint32_t __attribute__((vector_size(32)));
    const Unsigned shift{0, 0, 8, 8, 16, 16, 24, 24};
    const Halves spread = Halves{} + packed;
    Unsigned halves;
    std::memcpy(&halves, &spread, sizeof halves);
    halves = (halves >> shift) & 3U;
    std::memcpy(&kind, &halves, sizeof kind);
}

inline void load_eight(const Shell& shell, const WideMotion& wide, PackedKinds packed,
                       std::size_t first, Eight& eight) {
    unpack(packed, eight.kind);
    for_axes([&](auto axis) {
        std::memcpy(&eight.p[axis], &shell.place[axis][first], sizeof(Floats));
        std::memcpy(&eight.n[axis], &shell.normal[axis][first], sizeof(Floats));
    });
    eight.depth = Floats{};
    for_axes([&](auto axis) {
        // The same arithmetic as before, so the same voxel.
        Floats g;
        compute_place(wide, axis, eight.p[0], eight.p[1], eight.p[2], g);
        const Ints cell = __builtin_convertvector(g, Ints);
        eight.e[axis] = __builtin_convertvector(cell, Floats) + 0.5F - g;
        const auto& row = wide.turn[axis];
        const Floats n_map = row[0] * eight.n[0] + row[1] * eight.n[1] + row[2] * eight.n[2];
        eight.depth += n_map * eight.e[axis];
    });
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
    const Ints brakes = (eight.kind == 3) & (towards < 0.0F) & (square > kLeastSquare);
    Floats share{};
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        share[lane] = brakes[lane] != 0 ? -towards[lane] / std::sqrt(square[lane]) : 0.0F;
    }
    add_moment(eight, {-share * u[0], -share * u[1], -share * u[2]}, sums.brake);
    sums.brake_share += share;
}

// Whether what pushes, or is interior, lies where point `lane` goes.
template <class Map>
inline bool comes_to_surface(const Map& map, const Motion& motion, const Eight& eight,
                             std::size_t lane) {
    const auto& [vx, vy, vz] = motion.velocity_T;
    const auto& [wx, wy, wz] = motion.spin_T;
    const std::array<float, 3> p{eight.p[0][lane], eight.p[1][lane], eight.p[2][lane]};
    const std::array<float, 3> u{vx + (wy * p[2] - wz * p[1]), vy + (wz * p[0] - wx * p[2]),
                                 vz + (wx * p[1] - wy * p[0])};
    for (const float ahead_s : {0.5F * motion.ahead_s, motion.ahead_s}) {
        std::array<std::int32_t, 3> cell{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto& row = motion.turn[axis];
            float g = motion.shift[axis];
            for (std::size_t i = 0; i < 3; ++i) {
                g += row[i] * (p[i] + ahead_s * u[i]);
            }
            g = g > 0.0F ? g : 0.0F;
            cell[axis] = static_cast<std::int32_t>(std::min(g, motion.last[axis]));
        }
        const VoxelClass kind = map.find_class(cell);
        if (kind == VoxelClass::surface || kind == VoxelClass::interior) {
            return true;
        }
    }
    return false;
}

// Points that brake, but go elsewhere, are taken for free ones; whether any brakes.
template <class Map>
inline bool drop_passing(const Map& map, const Motion& motion, Eight& eight) {
    bool any = false;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        if (eight.kind[lane] == 3) {
            const bool stays = comes_to_surface(map, motion, eight, lane);
            eight.kind[lane] = stays ? 3 : 0;
            any = any || stays;
        }
    }
    return any;
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
    for (Index row = 0; row < 6; ++row) {
        const auto i = static_cast<std::size_t>(row);
        for (Index column = 0; column < 6; ++column) {
            sums.push_by_pose(row, column) +=
                add_lanes(lanes.push[i][static_cast<std::size_t>(column)]);
        }
        sums.fullness_by_pose[row] += add_lanes(lanes.fullness[i]);
    }
}

inline void add_brake_slopes(const Motion& motion, const Eight& eight, Sums& sums) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        if (eight.kind[lane] == 3) {
            voxel_lanes::add_brake_slopes(
                motion, {eight.p[0][lane], eight.p[1][lane], eight.p[2][lane]},
                {eight.n[0][lane], eight.n[1][lane], eight.n[2][lane]}, sums);
        }
    }
}

// What a chunk of points adds up to.
struct ChunkSums {
    LaneSums lanes;
    LaneSlopes slopes;
    std::int64_t n_surface = 0, n_interior = 0, n_proximity = 0;
};

// Eight points of which at least one pushes or brakes.
template <bool kLinear, class Map>
inline void add_eight(const Shell& shell, const Map& map, const Motion& motion,
                      const WideMotion& wide, PackedKinds packed, std::size_t first, bool brakes,
                      ChunkSums& chunk, Sums& sums) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled by the next line
    Eight eight;
    load_eight(shell, wide, packed, first, eight);
    if (brakes && motion.ahead_s > 0.0F) {
        brakes = drop_passing(map, motion, eight);
    }
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

template <bool kLinear, class Map>
inline void add_block(const Shell& shell, const Map& map, const Motion& motion,
                      const WideMotion& wide, const Kinds& kinds, std::size_t first,
                      ChunkSums& chunk, Sums& sums) {
    for (std::size_t group = 0; group < kinds.size(); ++group) {
        const PackedKinds packed = kinds[group];
        if (packed == 0) {
            continue;
        }
        // A byte is 01 interior, 10 surface, 11 proximity.
        const std::uint64_t surface = (packed >> 1) & ~packed & kOnes;
        const std::uint64_t proximity = (packed >> 1) & packed & kOnes;
        chunk.n_surface += std::popcount(surface);
        chunk.n_proximity += std::popcount(proximity);
        chunk.n_interior += std::popcount(packed & ~(packed >> 1) & kOnes);
        const bool brakes = motion.brakes && proximity != 0;
        if (surface != 0 || brakes) {
            add_eight<kLinear>(shell, map, motion, wide, packed, first + group * kLanes, brakes,
                               chunk, sums);
        }
    }
}

// Adds up all points. `kLinear`: with derivatives.
template <bool kLinear, class Map>
void sample(const Shell& shell, const Map& map, const Motion& motion, Sums& sums) noexcept {
    const WideMotion wide(motion);
    alignas(32) typename Map::Cells cells{};
    Kinds kinds{};
    for (std::size_t begin = 0; begin < shell.padded_size(); begin += kChunk) {
        const std::size_t end = std::min(begin + kChunk, shell.padded_size());
        ChunkSums chunk;
        for (std::size_t first = begin; first < end; first += kBlock) {
            find_cells(shell, map, wide, first, cells);
            if (map.look_up(cells, kinds)) {
                add_block<kLinear>(shell, map, motion, wide, kinds, first, chunk, sums);
            }
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

void sample_grid(const Shell& shell, const VoxelGrid& grid, const Motion& motion, bool linear,
                 Sums& sums) noexcept {
    linear ? sample<true>(shell, GridMap(grid), motion, sums)
           : sample<false>(shell, GridMap(grid), motion, sums);
}

void sample_tree(const Shell& shell, const Voxmap& map, const Motion& motion, bool linear,
                 Sums& sums) noexcept {
    linear ? sample<true>(shell, TreeMap(map), motion, sums)
           : sample<false>(shell, TreeMap(map), motion, sums);
}

}  // namespace
}  // namespace fulcrum::voxel_lanes::FULCRUM_KERNEL
// NOLINTEND(misc-definitions-in-headers)
