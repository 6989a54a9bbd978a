// Makes a mesh into voxels of four kinds, as McNeely does; open, cracked and self-intersecting meshes too.
//
//   1  every voxel that a triangle touches is surface (exactly: triangle_box.h)
//   2  what can be reached from outside the mesh's box through faces of voxels that are not surface is free
//   3  all other voxels are interior: nothing leaks, whatever the mesh, for a hole wider than a voxel only makes the
//      inside free
//   4  the layers outwards: L(v) is 0 for surface, and for a free voxel 1 + the least L of its 26 neighbours. With k
//      offset and n proximity layers:  L < k interior, L = k surface (it pushes), k < L <= k + n proximity, the rest free
// A place that is not interior is at least (k - 1) s from the mesh, s the voxel: between its own voxel and the
// surface's there are k - 1 others along one axis. So the tool's and the object's true surfaces cannot meet while no point of the tool is
// in the interior, if every place of the tool's surface is within (k - 1) s of one of its points: with k = 2 for points from
// voxels of up to 2/sqrt(3) s (pointshell.h), for points on the mesh where they lie that dense. With k = 0 or 1 they can.
//
// Thread: load. Cost: 80^3 about 10 ms, 512^3 about 1.5 s and 300 MB while it runs.
// Source: W. McNeely, K. Puterbaugh, J. Troy 1999, Six degree-of-freedom haptic rendering using voxel sampling, section
// 4.1 (the kinds, scan conversion, free space from outside, interior by remainder) and 4.2, figure 5 (offset layers).
#pragma once

#include "haptics/base/error.h"
#include "haptics/base/parallel_for.h"
#include "haptics/geometry/triangle_mesh.h"
#include "haptics/voxel/voxel_grid.h"

namespace fulcrum {

struct VoxeliseSettings {
    double voxel_m =
        0.005;  ///< edge of a voxel, 1e-9 to 1e3; at most 512 along an axis, layers included
    int offset_layers = 0;     ///< k: how far the layer that pushes is moved outwards, 0 to 8
    int proximity_layers = 1;  ///< n: how thick the layer that brakes is, 0 to 8
};

/// The voxel size with which the mesh's longest side fills `n_cells` voxels but for a quarter at both ends, layers not
/// counted; n_cells from 1.
[[nodiscard]] double compute_voxel_m(const TriangleMesh& mesh, int n_cells) noexcept;

/// Refuses settings outside their ranges, NaN included.
[[nodiscard]] Expected<void> validate(const VoxeliseSettings& settings);

/// The block of voxels that the mesh needs with its layers and a free one outside them; refuses what `voxelise` refuses.
[[nodiscard]] Expected<VoxelFrame> make_voxel_frame(const TriangleMesh& mesh,
                                                    const VoxeliseSettings& settings);

/// The mesh as voxels, its frame that of the mesh; the outermost voxels are free. Refuses settings that `validate` refuses
/// and a mesh that needs more than 512 voxels along an axis; an error too where `progress`, asked after each step, stops it.
[[nodiscard]] Expected<VoxelGrid> voxelise(const TriangleMesh& mesh,
                                           const VoxeliseSettings& settings,
                                           const LoadProgress& progress = {});

}  // namespace fulcrum
