// Many points of a rigid tool against a distance field at once: values, slopes, and the sums that a penalty force needs.
//
//   g = A p + b          a point's place in voxels of the field, A = R_OT / s, b = (t_OT - lower) / s
//   index and weights in vectors, four 32-bit loads a point (a pair of neighbours along x each), interpolation in vectors
//   D                    the depth of distance_field.h, max(-F, 0) but for what lies deeper than the band; steps of 16 bits
//   by normals:  sum of D n, sum of p x D n                  frame T, n the points' own normals: continuous wherever F is
//   by slopes:   sum of -D grad D, sum of -A p x D grad D    frame O: minus the derivative of sum D^2 / 2, so no loop gains energy
//   and how that changes with the tool's pose (distance_field_slope_kernel.h)
// Points that lie in free bricks or outside the block read the same constant brick, so there is no branch a point.
//
// Places are single precision: off by at most 2.4e-7 (|A p| + |b|) voxels, 2.5e-4 in a block of 1024. Every version adds the same
// numbers in the same order, point i in lane i mod 16, so the plain one, that for AVX2 and that for AVX-512 agree to the bit.
//
// Thread: any; no state. Cost: 2 to 4 ns a point in the cache, by AVX2; the best is taken that the processor has.
// Source: the gather by scalar loads instead of gather instructions: A. Fog 2024, Optimizing subroutines in assembly language,
// section 13.6; sums as in W. McNeely, K. Puterbaugh, J. Troy 1999, section 4.
#pragma once

#include "haptics/math/wrench_jacobian.h"
#include "haptics/voxel/distance_field.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace fulcrum {

/// Points are taken in leaves of this many; kernels read whole leaves.
inline constexpr std::size_t kLeafPoints = 32;

/// Where points lie and which way the tool's inside is: arrays of one length, metres, tool's frame T; unit normals into the tool.
struct ShellPoints {
    const float* x = nullptr;
    const float* y = nullptr;
    const float* z = nullptr;
    const float* nx = nullptr;
    const float* ny = nullptr;
    const float* nz = nullptr;

    [[nodiscard]] ShellPoints from(std::size_t i) const noexcept {
        return {x + i, y + i, z + i, nx + i, ny + i, nz + i};
    }
};

/// A field as kernels read it; the field must live longer.
struct FieldView {
    explicit FieldView(const DistanceField& field) noexcept;

    const DistanceField::Entry* table;
    const std::int16_t* values;
    std::int32_t row, layer;   ///< entries along x, and in x and y
    std::int32_t outside;      ///< the entry behind the last
    std::array<float, 3> end;  ///< cells along each axis, a rounding less
    const float* depths;       ///< of the bricks' centres, voxels
    std::array<std::int32_t, 3> n_bricks;
    float band_voxels;
};

/// From the tool's frame to voxels of the field.
struct FieldPlace {
    FieldPlace(const DistanceField& field, const Pose& X_OT) noexcept;

    std::array<float, 9> A;  ///< row by row
    std::array<float, 3> b;
};

/// Sixteen partial sums of each component; steps, metres or voxels.
struct ContactLanes {
    static constexpr std::size_t kLanes = 16;
    alignas(64) std::array<std::array<float, kLanes>, 3> force{};
    alignas(64) std::array<std::array<float, kLanes>, 3> torque{};
    alignas(64) std::array<std::int32_t, kLanes> count{};
};

/// Sixteen partial sums of how the force along slopes changes (distance_field_slope_kernel.h); steps and voxels, frame O.
struct SlopeLanes {
    using Lanes = std::array<float, ContactLanes::kLanes>;
    /// Symmetric: xx, yy, zz, then yz, xz, xy.
    using Symmetric = std::array<Lanes, 6>;
    using Rows = std::array<Lanes, 9>;  ///< of a matrix, one after the other
    alignas(64) Symmetric place{};
    alignas(64) Rows turn{};
    alignas(64) Symmetric torque{};
    alignas(64) Rows arm_force{};
};

enum class ForceAlong : std::uint8_t { normals, slopes };

/// Leaves that follow each other; kernels read kLeafPoints of each.
struct LeafRun {
    const ShellPoints* leaves = nullptr;
    std::size_t n = 0;
    std::size_t n_in_last = kLeafPoints;  ///< points of the last leaf that count
    std::size_t most_touching = 0;        ///< behind as many that touch the run ends; at least 1
};

struct EightBalls;
struct SlackBounds;

/// One version of the kernels.
struct FieldKernels {
    std::string_view name;
    /// F of `n` points in steps to `values`; where `slopes` is not null, steps a voxel to slopes[0..2], frame O. Any n.
    void (*sample)(const FieldView&, const FieldPlace&, const ShellPoints&, std::size_t n,
                   float* values, float* const* slopes) noexcept;
    /// Adds the contacts of leaves to the sums, one after the other, and writes each one's least F, in steps, or minus its
    /// largest D, to `least`; how many leaves it took: all, or those up to the last that may touch.
    std::size_t (*sum_leaves)(const FieldView&, const FieldPlace&, const LeafRun&, ForceAlong,
                              ContactLanes&, float* least) noexcept;
    /// Writes the numbers of those of `n` values that are below 0; how many. `hits` has room for all and one more.
    std::size_t (*collect_hits)(const float* values, std::size_t n, std::int32_t* hits) noexcept;
    /// Adds to the sums what the first `n` points of a leaf have that touch and are no deeper than 3/4 of the band; a bit for each of
    /// those that are deeper, which are left to the caller.
    std::uint32_t (*sum_slopes)(const FieldView&, const FieldPlace&, const ShellPoints& leaf,
                                std::size_t n, SlopeLanes&) noexcept;
    /// The slacks of eight balls, voxels (ball_slack.h).
    void (*find_slacks)(const SlackBounds&, const FieldPlace&, const EightBalls&,
                        std::array<float, 8>& slacks) noexcept;
};

/// The best that this processor has.
[[nodiscard]] const FieldKernels& best_field_kernels() noexcept;
/// The plain one, that for AVX2 and that for AVX-512, null where the processor has none of it or the compiler could not build it.
[[nodiscard]] std::array<const FieldKernels*, 3> all_field_kernels() noexcept;

/// Force and torque about the tool's origin, and how many points touch. Divided by a stiffness: metres and square metres.
struct ContactSums {
    Vector3 force{Vector3::Zero()};
    Vector3 torque{Vector3::Zero()};
    std::int64_t n_touching = 0;
};

/// How much the sixteen partial sums differ, of points that follow each other in turn: were they drawn by chance, this would be
/// the variance of their sum. Square metres, and m^4 of the torque.
struct ContactSpread {
    double force_square = 0.0;
    double torque_square = 0.0;
};
[[nodiscard]] ContactSpread find_spread(const DistanceField& field, ForceAlong along,
                                        const ContactLanes& lanes) noexcept;

/// Adds the lanes, scaled to metres and turned to frame O, to `sums`, and empties them.
void add_lanes(const DistanceField& field, const Pose& X_OT, ForceAlong along, ContactLanes& lanes,
               ContactSums& sums) noexcept;

/// Adds the lanes to the derivatives of force and torque about the tool's origin by its pose, frame O, over the stiffness, and empties
/// them.
void add_slope_lanes(const DistanceField& field, SlopeLanes& lanes, Matrix6& slopes) noexcept;

/// All of `n` points; frame O.
[[nodiscard]] ContactSums sum_contacts(const FieldKernels& kernels, const DistanceField& field,
                                       const Pose& X_OT, const ShellPoints& points, std::size_t n,
                                       ForceAlong along) noexcept;

}  // namespace fulcrum
