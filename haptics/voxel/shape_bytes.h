// Distance fields, voxels, pointshells and a mesh's moments as bytes, so that what took long to make need not be made again; and
// back, checked.
//
//   bytes    mark (8) · version · kind (4 each) · key (32) · length (8) · that many bytes · SHA-256 of all before (32)
//   key      of shape_key.h
// Numbers are little-endian. What is read is believed in nothing: mark, version, kind, key, length and checksum must be right, and
// then every number within the range that the makers give it, so that no question to what was read can reach beyond it: nothing
// farther than the block is long, slopes from 1 to sqrt(3), where a hole is closed by a membrane to 2 sqrt(3) b / s, normals of unit
// length, moments that a body can have. Whether it is the shape that was asked for, of that frame and size, is for who asks. No more
// memory is asked for than the bytes fill; for voxels, which are kept as runs of one kind, no more than 512^3.
//
// Thread: load. Cost: 4 to 5 ns a byte, most of it the checksum: a field of 512^3, 43 MB, 0.2 s.
#pragma once

#include "haptics/geometry/solid_moments.h"
#include "haptics/voxel/byte_walk.h"
#include "haptics/voxel/distance_field.h"
#include "haptics/voxel/pointshell.h"
#include "haptics/voxel/shape_key.h"
#include "haptics/voxel/voxel_grid.h"

#include <cstddef>
#include <span>

namespace fulcrum {

/// How many bytes `encode` makes of it.
[[nodiscard]] std::size_t count_bytes(const DistanceField& field);
[[nodiscard]] std::size_t count_bytes(const VoxelGrid& grid);
[[nodiscard]] std::size_t count_bytes(const Pointshell& shell);
[[nodiscard]] std::size_t count_bytes(const MeasuredSolid& solid);

[[nodiscard]] Bytes encode(const DistanceField& field, const Digest& key);
[[nodiscard]] Bytes encode(const VoxelGrid& grid, const Digest& key);
[[nodiscard]] Bytes encode(const Pointshell& shell, const Digest& key);
[[nodiscard]] Bytes encode(const MeasuredSolid& solid, const Digest& key);

/// Each refuses bytes that are cut off, changed, of another version, kind or key, or that no maker made.
[[nodiscard]] Expected<DistanceField> decode_distance_field(std::span<const std::byte> bytes,
                                                            const Digest& key);
[[nodiscard]] Expected<VoxelGrid> decode_voxel_grid(std::span<const std::byte> bytes,
                                                    const Digest& key);
[[nodiscard]] Expected<Pointshell> decode_pointshell(std::span<const std::byte> bytes,
                                                     const Digest& key);
[[nodiscard]] Expected<MeasuredSolid> decode_measured_solid(std::span<const std::byte> bytes,
                                                            const Digest& key);

}  // namespace fulcrum
