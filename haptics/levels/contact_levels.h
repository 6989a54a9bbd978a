// A mesh as contact levels of detail: convex hulls in a tree that bounds the mesh and is, from the leaves up, ever simpler instead of it.
//
// The leaves are the mesh's convex pieces. The surface is simplified (filtered_collapse.h); each time that half of the pieces are left, each
// piece becomes a node over the nodes of those that became it: a level. When no edge may end any more, what is left is put together in pairs
// by place. Each node tells, of the piece of the simplified surface that it is:
//   r     resolution, 1/m: 1 / the longest edge that ended before the level
//   s     deviation: how far its hull stands out of the mesh, by points of the hull's faces that are in front of the mesh's nearest triangle; 3 to 12
//         of a face, and above a tenth of the diagonal no longer measured. 0 of what is convex
//   D     support area: how much of the mesh around lies within d of a plane that touches it there, by the mean over the leaves below of the area,
//         in the tangent plane, of the triangles in one piece with a corner and no deeper than d below it (256 at most)
//   phi   s / r^2, the volume of the detail that was taken away; infinite of a node that was put together by place: it stands for nothing
// A node's hull is that of the mesh below it, not of its piece: so it bounds, and tightly: five times fewer pairs are near by it than by
// simplified hulls with what reaches out of these; and told instead of the mesh it lets nothing through. What is not in it is h, some
// ten-millionth of the size, for pieces are flat to that.
//
// Thread: made at load; read from any thread. Cost: 40 k triangles in 2 to 9 s; 0.2 to 0.3 kB a triangle.
// Source: M. Otaduy, M. Lin 2003, CLODs: dual hierarchies for multiresolution collision detection, Symposium on Geometry Processing; M. Otaduy,
// M. Lin 2003, Sensation preserving simplification for haptic rendering, SIGGRAPH, sections 4.4 and 4.5. There each hull is the
// simplified piece's, and h the directed Hausdorff distance.
#pragma once

#include "haptics/base/load_progress.h"
#include "haptics/geometry/mesh_report.h"
#include "haptics/levels/hull_pair.h"
#include "haptics/levels/level_node.h"

#include <memory>
#include <span>
#include <vector>

namespace fulcrum {

/// Fixed at load.
struct ContactLevelSettings {
    double within_m = 1.0e-3;  ///< d, how near is contact, 1e-6 to 1
};

/// Refuses settings outside their ranges, NaN included.
[[nodiscard]] Expected<void> validate(const ContactLevelSettings& settings);

class ContactLevels {
  public:
    /// Refuses settings that `validate` does, and an end by `progress`.
    [[nodiscard]] static Expected<std::shared_ptr<const ContactLevels>> create(
        const TriangleMesh& mesh, const ContactLevelSettings& settings = {},
        const LoadProgress& progress = {});

    /// The root is the first; children come after their parent.
    [[nodiscard]] std::span<const LevelNode> nodes() const noexcept { return nodes_; }
    [[nodiscard]] const LevelNode& node(std::int32_t node) const noexcept {
        return nodes_[static_cast<std::size_t>(node)];
    }
    [[nodiscard]] HullView hull(std::int32_t node) const noexcept;
    /// The mesh's triangles below a node.
    [[nodiscard]] std::span<const std::int32_t> triangles_of(std::int32_t node) const noexcept;
    /// A sphere round all hulls.
    [[nodiscard]] const Vector3& centre_B() const noexcept { return nodes_.front().centre_B; }
    /// Half of the mesh's diagonal: what tolerances are told in parts of.
    [[nodiscard]] double size_m() const noexcept { return size_m_; }
    /// From the origin to the mesh's farthest corner.
    [[nodiscard]] double reach_m() const noexcept { return reach_m_; }
    [[nodiscard]] std::int32_t n_levels() const noexcept { return n_levels_; }
    [[nodiscard]] std::int32_t n_pieces() const noexcept { return n_pieces_; }
    [[nodiscard]] const ContactLevelSettings& settings() const noexcept { return settings_; }
    /// What was found wrong with the mesh; `to_sentence` says it.
    [[nodiscard]] const MeshReport& report() const noexcept { return report_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    friend class ContactLevelsBuilder;
    friend class ContactLevelsBytes;
    ContactLevels() = default;
    struct Span {
        std::int32_t first = 0;
        std::int32_t count = 0;
    };

    ContactLevelSettings settings_;
    MeshReport report_;
    std::vector<LevelNode> nodes_;
    std::vector<Span> points_of_;     // a node's, in points_
    std::vector<Span> links_of_;      // a node's, in first_links_: count 0 where it has none
    std::vector<Span> triangles_of_;  // a node's, in triangles_
    std::vector<Vector3> points_;
    std::vector<std::int32_t> first_links_;
    std::vector<std::int32_t>
        links_;  // a node's own begin where its first first_link says, counted over all
    std::vector<std::int32_t> triangles_;
    double size_m_ = 0.0;
    double reach_m_ = 0.0;
    std::int32_t n_levels_ = 0;
    std::int32_t n_pieces_ = 0;
};

}  // namespace fulcrum
