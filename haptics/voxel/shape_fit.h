// Whether a kept shape can be that of a mesh: what bytes say that are whole and right by their checksum, but were made by somebody
// else than the makers.
//
//   field       holds the mesh in its ball; at the corners of the triangles, which lie on the surface, F is -h (0 for a solid) to
//               within what F may be off (distance_field.h)
//   voxels      the outermost are free; some push; no corner of a triangle lies in a free or braking voxel
//   pointshell  every point lies in the mesh's box, and some away from the middle of all
//   moments     by integrals: those of the mesh, to rounding. By samples: the centre in the mesh's box, of edges e, the volume
//               V from what the samples can tell up to the box's, and along each axis, whatever the solid's form,
//                 V (V e_i / (e_1 e_2 e_3))^2 / 12 <= S_ii <= V e_i^2 / 4     a slab across the axis; half at either end
// What passes may still be another shape than that of the mesh. It is one that a tool can be held by, with all its numbers in range.
//
// Thread: load. Cost: 20 ns a triangle, of at most 20 000 corners 30 ns each; 5 ns a point.
#pragma once

#include "haptics/geometry/solid_moments.h"
#include "haptics/voxel/distance_field.h"
#include "haptics/voxel/pointshell.h"
#include "haptics/voxel/voxel_grid.h"

namespace fulcrum {

[[nodiscard]] bool can_be_of(const DistanceField& field, const TriangleMesh& mesh) noexcept;
[[nodiscard]] bool can_be_of(const VoxelGrid& grid, const TriangleMesh& mesh) noexcept;
[[nodiscard]] bool can_be_of(const Pointshell& shell, const TriangleMesh& mesh) noexcept;
[[nodiscard]] bool can_be_of(const MeasuredSolid& solid, const TriangleMesh& mesh) noexcept;

}  // namespace fulcrum
