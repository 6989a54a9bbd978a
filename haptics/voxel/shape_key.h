// What a kept shape is made of, as a key: the same mesh and settings have the same one.
//
//   key   SHA-256 over version, kind, the mesh's corners and triangles, and all settings as doubles
//
// Thread: load. Cost: that of the checksum, 5 ns a byte of the mesh.
#pragma once

#include "haptics/base/sha256.h"
#include "haptics/geometry/triangle_mesh.h"

#include <cstdint>
#include <span>

namespace fulcrum {

/// Goes up with every change of the layout, or of what a maker makes of the same settings.
inline constexpr std::uint32_t kShapeVersion = 3;

enum class ShapeKind : std::uint32_t {
    distance_field = 1,
    voxel_grid = 2,
    pointshell = 3,
    solid_moments = 4,
    contact_levels = 5  ///< levels/level_bytes.h
};

/// What a shape is made of: the same mesh and settings have the same key.
[[nodiscard]] Digest compute_shape_key(ShapeKind kind, const TriangleMesh& mesh,
                                       std::span<const double> settings);

}  // namespace fulcrum
