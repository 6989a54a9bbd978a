// H-COLLIDE: a hashed uniform grid whose cells hold trees of oriented boxes over the triangles near them.
//
// A triangle belongs to every cell that its box, widened by a thousandth of a cell, overlaps. A segment is answered in three
// phases: the cells along it, found by hash and in order; the boxes of each cell's tree that it may meet; the triangles in them,
// by the exact test. It ends at the first cell beyond the nearest meeting so far: a triangle that would be met
// earlier lies in an earlier cell too. What was met last is asked first, for from one tick to the next little changes.
// The answers are those of brute force, to the bit.
//
// Thread: made at load, then asked from any thread, each with a memory of its own. Cost: build O(n log n); a question O(cells along
// the segment + triangles near it); no allocation. Segments with ends 1e8 times the mesh's size away ask every cell.
// Source: A. Gregory, M. C. Lin, S. Gottschalk, R. Taylor 1999, H-COLLIDE: a framework for fast and accurate collision detection
// for haptic interaction, IEEE Virtual Reality.
#pragma once

#include "haptics/collision/segment_query.h"
#include "haptics/geometry/hash_grid.h"
#include "haptics/geometry/obb_tree.h"

#include <memory>
#include <vector>

namespace fulcrum {

struct HCollideSettings {
    double triangles_a_cell = 8.0;  ///< about how many of the surface's lie in a cell, 1 to 1e6
    int triangles_a_leaf = 4;       ///< boxes with no more are not split, 1 to 1000
};

/// Refuses values out of range.
[[nodiscard]] Expected<void> validate(const HCollideSettings& settings);

class HCollide {
  public:
    /// What one who asks remembers from question to question.
    struct Memory {
        std::int32_t triangle = -1;  ///< met last
        std::uint64_t key = 0;       ///< of the last cell that was looked up
        std::int32_t tree = HashGrid::kNothing;
        bool has_cell = false;
    };

    [[nodiscard]] static Expected<std::shared_ptr<const HCollide>> create(
        std::shared_ptr<const CollisionMesh> mesh, const HCollideSettings& settings = {});

    /// The nearest meeting with the mesh; body frame, `from` and `to` finite.
    [[nodiscard]] SegmentHit find_nearest_hit(const Vector3& from_B, const Vector3& to_B,
                                              Memory& memory) const noexcept;
    [[nodiscard]] std::int32_t n_cells() const noexcept { return n_cells_; }
    [[nodiscard]] double cell_m() const noexcept { return grid_.cell_m(); }
    /// On the heap, without the mesh.
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    // A triangle in a cell.
    struct Entry {
        std::uint64_t key;
        std::int32_t triangle;
    };

    HCollide(std::shared_ptr<const CollisionMesh> mesh, const HCollideSettings& settings);
    [[nodiscard]] bool list_entries(std::vector<Entry>& entries) const;
    void plant(const std::vector<Entry>& entries);
    [[nodiscard]] std::int32_t find_tree(std::uint64_t key, Memory& memory) const noexcept;

    std::shared_ptr<const CollisionMesh> mesh_;
    HashGrid grid_;
    ObbForest forest_;
    std::vector<std::int32_t> roots_;  // of all trees
    std::int32_t n_cells_ = 0;
};

}  // namespace fulcrum
