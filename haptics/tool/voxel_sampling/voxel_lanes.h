// The inner loop of voxel sampling: a pointshell against a voxmap, eight points side by side. Private to voxel_sampling.
//
// Lengths are counted in voxels, places of points in the tool's frame T from its origin. For each point p with inward normal n:
//   g = R p + t               its place in the lattice of the map; the voxel is floor(g), its centre c = floor(g) + 1/2
//   e = c - g,  d = (R n).e   how far it lies beneath the plane through c with normal R n
//   surface, d > d_least      adds  d n  and  d (p x n)                       d_least = 0, or none
//   proximity, n.u < 0        adds  -k u,  p x -k u  and  k = -n.u/|u|        u = v + w x p
//   looking ahead             only if the voxel of p + a u or p + a u/2 pushes or is interior
// Blocks of 64 points are carried into the lattice first, then looked up, then those eights that hit anything are added up: a
// look at a byte cannot be done side by side, and the two halves keep out of each other's way.
//
// Sums are single within 2048 points and double beyond. A place in the lattice is off by at most
// 2^-24 (3 |p| + n) voxels, n the map's voxels along its longest side: 3e-5 at 512. A point that lies nearer than that to the
// wall between two voxels may count for the other one.
//
// Thread: that of the step. Cost: about 0.6 ns a point that touches nothing, 3 ns more for each eight that do.
#pragma once

#include "haptics/math/wrench_jacobian.h"
#include "haptics/voxel/voxmap.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace fulcrum::voxel_lanes {

inline constexpr std::size_t kLanes = 8;
inline constexpr std::size_t kBlock = 64;

/// A pointshell in voxels, padded with points that are never in the map.
struct Shell {
    std::array<std::vector<float>, 3> place, normal;
    std::size_t n_points = 0;

    [[nodiscard]] std::size_t padded_size() const noexcept { return place[0].size(); }
};

inline constexpr std::size_t kChunk = 2048;  ///< points that are summed in single precision

/// The tool's pose and motion as the map sees them.
struct Motion {
    std::array<std::array<float, 3>, 3> turn{};  ///< R
    std::array<float, 3> shift{};                ///< t
    std::array<float, 3> last{};  ///< greatest place that counts, in the outermost voxel
    std::array<float, 3> velocity_T{}, spin_T{};  ///< as the object sees it; voxels/s, rad/s
    std::array<float, 3> object_spin_T{};         ///< in the world, rad/s; for derivatives alone
    float least_depth = 0.0F;
    bool brakes = false;
    float ahead_s = 0.0F;  ///< brakes act only where what pushes lies so far ahead; 0: everywhere
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

/// One version of the loop, for a byte a voxel and for a 512-tree. `linear`: with derivatives.
struct Kernels {
    std::string_view name;
    void (*sample_grid)(const Shell&, const VoxelGrid&, const Motion&, bool linear, Sums&) noexcept;
    void (*sample_tree)(const Shell&, const Voxmap&, const Motion&, bool linear, Sums&) noexcept;
};

/// The best that this processor has.
[[nodiscard]] const Kernels& best_kernels() noexcept;
/// The plain one and that for AVX2, null where the processor has none of it or the compiler could not build it. Both agree to the bit.
[[nodiscard]] std::array<const Kernels*, 2> all_kernels() noexcept;

/// What the brake of a point at `p` with the normal `n` adds to the derivatives: one by one, in double, for few points brake.
void add_brake_slopes(const Motion& motion, const std::array<float, 3>& p,
                      const std::array<float, 3>& n, Sums& sums) noexcept;

/// Slower than that nothing is braked: squares of single precision vanish. Voxels/s, squared.
inline constexpr float kLeastSquare = 1.0e-30F;

}  // namespace fulcrum::voxel_lanes
