// Contact levels as bytes, so that what took seconds to make need not be made again; and back, checked.
//
// Sealed as all kept shapes are (voxel/shape_bytes.h): mark, version, kind, key, length, checksum. What is read is believed in nothing:
// every number lies within the range that the maker gives it, each node but the root is the child of exactly one, which stands before it, and no
// span reaches beyond its list. So every question to what was read ends, and reaches nothing that is not there.
//
// Thread: load. Cost: 5 ns a byte; of 40 k triangles 10 MB. `can_be_of`: 0.3 us a corner of a triangle.
#pragma once

#include "haptics/levels/contact_levels.h"
#include "haptics/voxel/shape_bytes.h"

#include <memory>

namespace fulcrum {

/// How many bytes `encode` makes of it.
[[nodiscard]] std::size_t count_bytes(const ContactLevels& levels);
[[nodiscard]] Bytes encode(const ContactLevels& levels, const Digest& key);

/// Refuses bytes that are cut off, changed, of another version, kind or key, or that no maker made.
[[nodiscard]] Expected<std::shared_ptr<const ContactLevels>> decode_contact_levels(
    std::span<const std::byte> bytes, const Digest& key);

/// Whether they are round that mesh: each triangle lies in the hull of its leaf, and each hull within those above it, but for what the nodes say
/// is outside. Then no triangle is missed, whoever made them.
[[nodiscard]] bool can_be_of(const ContactLevels& levels, const TriangleMesh& mesh);

}  // namespace fulcrum
