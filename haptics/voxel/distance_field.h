// How far from a mesh each point of a block is, and on which side: a signed distance field that is exact near the surface
// and knows little more than how near it is elsewhere.
//
//   F(p)   between the lattice corners of VoxelFrame, trilinear; at a corner the distance d to the mesh, above 0 outside, clamped to
//          the band -b..b and kept in 16 bits, steps of b / 32767
//   |F(p) - d(p)| <= sqrt(3)/2 s + b / 65534   within the band, for every mesh (s the voxel: d changes by at most the way walked)
//                 <= s^2 / (4 r) + b / 65534   round a sphere's centre from r on, while the cell's corners are within the band
//   |F(p) - F(q)| <= L |p - q|                 L is measured over all cells while building; a little above 1, sqrt(3) at worst
// F is continuous everywhere: bricks of 8^3 cells are kept where the surface is within the band of a corner, all others are +b or
// -b throughout, and so is the shared face. Its slope, exact for F, jumps from cell to cell by the surface's bend.
//
// Two bounds look farther than the band. Each brick's table entry holds its centre's distance; outside the block, with q the
// block's point nearest to p, d(p)^2 >= |p - q|^2 + d(q)^2, as the block is convex and holds the mesh, and d(p) is at least the
// distance to a ball that holds it.
//
// Deeper than the band a depth D goes on, so that what lies there is pushed out too; with C between the bricks' centres, trilinear,
// where the depth is known exactly,
//   D = d + t K    d = max(-F, 0),  K = max(C - b, 0),  t = 4 d/b - 3 within 0 to 1
// D is d down to 3/4 of the band, and continuous everywhere: the slope of D^2 / 2 is a force by which no closed way gains energy. Within
// 8 voxels of the places from which two ways out are equally long, C is flatter than the depth, or level: no push from there.
//
// Sides are by winding number (brick_sides.h): meshes with holes, doubled or loose triangles have them too. A hole is closed by
// the membrane where the winding number is 1/2; F jumps there, as no triangle is near, and what the two bounds call free may
// lie in it: they and L hold for closed meshes. `tell_holes` has a sentence for who loads one.
// An open mesh has two outsides. As a sheet it is solid within h of its triangles and nowhere else: d is |distance| - h, holes
// are holes, and all bounds hold, whatever the mesh.
//
// Thread: build at load, on a few threads; questions from any thread. Cost: a point 10 ns in the cache; memory 1472 bytes a
// brick near the surface, 12 a brick of the block: 512^3 round a ball 41 MB. Kernels for many points: distance_field_batch.h.
// Source: K. Museth 2013, VDB: high-resolution sparse volumes with dynamic topology, ACM TOG 32(3), section 3: here one level
// of bricks, each with an apron, and a flat table above it.
#pragma once

#include "haptics/base/parallel_for.h"
#include "haptics/geometry/triangle_mesh.h"
#include "haptics/voxel/distance_band.h"
#include "haptics/voxel/voxel_frame.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace fulcrum {

struct DistanceFieldSettings {
    double band_voxels = 3.0;  ///< b / s, 2 to 16
    double sheet_voxels =
        0.0;            ///< h / s: 0, a solid; or 1 to the band, a sheet of twice that thickness
    int n_threads = 2;  ///< 1 to 64, for building alone
};

/// Checks all fields.
[[nodiscard]] Expected<void> validate(const DistanceFieldSettings& settings);

/// Refuses a frame whose cells are no multiples of 8 from 8 to 2048, that has no size or place, or that leaves the mesh less room
/// on any side than the band, with the sheet, and a voxel.
[[nodiscard]] Expected<void> validate(const VoxelFrame& frame, const TriangleMesh& mesh,
                                      double band_voxels);

/// What a build found.
struct DistanceFieldCounts {
    std::int64_t n_bricks = 0;      ///< kept near the surface
    std::int64_t n_open_edges = 0;  ///< of the mesh; 0 where it is closed
};

/// F and its gradient at a point.
struct DistanceSample {
    double value_m = 0.0;            ///< -b to b, above 0 outside
    Vector3 slope{Vector3::Zero()};  ///< metres a metre, object's frame; zero beyond the band
};

/// The same and how the gradient changes within the cell: F is linear along each axis there, so only its mixed second derivatives
/// are not zero.
struct DistanceCurve {
    DistanceSample sample{};
    Vector3 bend{Vector3::Zero()};  ///< by y and z, by x and z, by x and y; 1/m

    /// All second derivatives, 1/m.
    [[nodiscard]] Matrix3 hessian() const noexcept {
        Matrix3 all;
        all << 0.0, bend.z(), bend.y(), bend.z(), 0.0, bend.x(), bend.y(), bend.x(), 0.0;
        return all;
    }
};

/// D, the way out and how that changes.
struct DepthSample {
    double depth_m = 0.0;              ///< 0 outside
    Vector3 way_out{Vector3::Zero()};  ///< minus the gradient of D, metres a metre, object's frame
    Matrix3 hessian{Matrix3::Zero()};  ///< second derivatives of D within its cells, 1/m
};

/// A block of cubes round the mesh: `n_along` cells along its longest side, a multiple of 8 from 16 to 2048, with the margin
/// that a band of `band_voxels` needs; for a sheet, the sum of band and sheet.
[[nodiscard]] Expected<VoxelFrame> make_field_frame(const TriangleMesh& mesh, int n_along,
                                                    double band_voxels = 3.0);

class DistanceField {
  public:
    static constexpr std::int32_t kFree = 0;    ///< the brick of +b
    static constexpr std::int32_t kInside = 1;  ///< the brick of -b
    static constexpr int kLargestValue = 32767;

    struct Brick {
        // A multiple of a cache line; a pair along x is one 32-bit load.
        alignas(64) std::array<std::int16_t, 736> values{};
    };
    struct Entry {
        std::int32_t brick = kFree;
        float centre_voxels =
            0.0F;  ///< of the brick's centre, d / s rounded towards 0, below 0 inside
    };

    /// Refuses frames and settings that `validate` refuses, and a mesh whose inside would take minutes to find: triangles that cross
    /// each other all over the block, or that are open everywhere. An error too where `progress` stops it.
    [[nodiscard]] static Expected<DistanceField> build(const TriangleMesh& mesh,
                                                       const VoxelFrame& frame,
                                                       const DistanceFieldSettings& settings = {},
                                                       const LoadProgress& progress = {});

    /// F at any point, inside the block or not.
    [[nodiscard]] DistanceSample sample(const Vector3& p_O) const noexcept {
        return sample_curve(p_O).sample;
    }
    /// The same with its second derivatives.
    [[nodiscard]] DistanceCurve sample_curve(const Vector3& p_O) const noexcept;
    /// D and its derivatives at any point.
    [[nodiscard]] DepthSample sample_depth(const Vector3& p_O) const noexcept;
    /// How far from `p_O` F is surely above 0 in all directions; 0 where F is 0 or below.
    [[nodiscard]] double find_free_radius_m(const Vector3& p_O) const noexcept;
    /// A lower bound of the distance to the mesh, with its sign: below 0 inside; 0 where nothing is known.
    [[nodiscard]] double bound_distance_m(const Vector3& p_O) const noexcept;

    [[nodiscard]] const VoxelFrame& frame() const noexcept { return frame_; }
    [[nodiscard]] double band_m() const noexcept { return band_m_; }
    /// L.
    [[nodiscard]] double slope_bound() const noexcept { return slope_bound_; }
    /// How far F is from d within the band at most.
    [[nodiscard]] double error_bound_m() const noexcept;
    /// A ball that holds the mesh.
    [[nodiscard]] const Vector3& ball_centre_O() const noexcept { return ball_centre_O_; }
    [[nodiscard]] double ball_radius_m() const noexcept { return ball_radius_m_; }
    [[nodiscard]] const DistanceFieldCounts& counts() const noexcept { return counts_; }
    /// What a solid's holes lead to and what to do, as one error would say it; nothing where it has none, or is a sheet.
    [[nodiscard]] std::optional<Error> tell_holes() const;
    /// h; 0 for a solid.
    [[nodiscard]] double sheet_m() const noexcept { return sheet_m_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

    /// The share of the band from which on D is more than d.
    static constexpr double kDeepFrom = 0.75;

    /// For kernels: entries x fastest, then y, then z, one of the free outside behind them; bricks.
    [[nodiscard]] const std::vector<Entry>& table() const noexcept { return table_; }
    [[nodiscard]] const std::vector<Brick>& bricks() const noexcept { return bricks_; }
    /// For kernels: of each brick's centre, voxels, above 0 inside, exact there; as the table.
    [[nodiscard]] const std::vector<float>& depths() const noexcept { return depths_; }
    /// Bricks along each axis.
    [[nodiscard]] std::array<std::int32_t, 3> n_bricks() const noexcept {
        return {frame_.n_cells[0] / kBrickCells, frame_.n_cells[1] / kBrickCells,
                frame_.n_cells[2] / kBrickCells};
    }
    /// Metres a step of a brick's values.
    [[nodiscard]] double step_m() const noexcept { return band_m_ / kLargestValue; }

  private:
    friend class DistanceFieldBuilder;
    friend class DistanceFieldBytes;
    // The cell of a point of the block, and where in it.
    struct Place {
        const Entry* entry = nullptr;
        const std::int16_t* corner = nullptr;  // the cell's least
        Vector3 within{Vector3::Zero()};       // 0 to 1
        Vector3 from_centre{Vector3::Zero()};  // of the brick, voxels
    };
    [[nodiscard]] Place find_place(const Vector3& lattice) const noexcept;
    [[nodiscard]] DistanceCurve interpolate(const Place& place) const noexcept;
    // C in voxels at a place in voxels.
    [[nodiscard]] DistanceCurve find_centre_depth(const Vector3& lattice) const noexcept;
    // The block's point nearest to a place, both in voxels.
    [[nodiscard]] Vector3 clamp_to_block(const Vector3& lattice) const noexcept;

    VoxelFrame frame_;
    double band_m_ = 0.0;
    double sheet_m_ = 0.0;
    double slope_bound_ = 1.0;
    DistanceFieldCounts counts_;
    Vector3 ball_centre_O_{Vector3::Zero()};
    double ball_radius_m_ = 0.0;
    std::vector<Entry> table_;
    std::vector<Brick> bricks_;
    std::vector<float> depths_;
};

}  // namespace fulcrum
