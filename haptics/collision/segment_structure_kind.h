// The names of structures that find the first triangle a segment meets (segment_structure.h).
//
// Thread: any.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace fulcrum {

enum class SegmentStructureKind : std::uint8_t {
    bounding_tree,  ///< the mesh's own tree of 8-fold boxes (bounding_tree.h)
    h_collide,      ///< a hashed grid of trees of oriented boxes (h_collide.h)
    brute_force,    ///< every triangle: the reference
};

/// "bounding_tree", "h_collide", "brute_force".
[[nodiscard]] std::string_view name_of(SegmentStructureKind kind) noexcept;
/// The kind of that name, if there is one.
[[nodiscard]] std::optional<SegmentStructureKind> find_segment_structure(
    std::string_view name) noexcept;

}  // namespace fulcrum
