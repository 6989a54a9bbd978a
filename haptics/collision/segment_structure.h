// Structures that find the first triangle a segment meets, chosen by name. Whichever is chosen, the answer is the same to the bit.
//
// Thread: made at load; each belongs to one thread, for it may remember the last question. Cost: see each.
#pragma once

#include "haptics/collision/h_collide.h"
#include "haptics/collision/segment_query.h"
#include "haptics/collision/segment_structure_kind.h"

#include <memory>

namespace fulcrum {

class SegmentStructure {
  public:
    SegmentStructure() = default;
    SegmentStructure(const SegmentStructure&) = delete;
    SegmentStructure& operator=(const SegmentStructure&) = delete;
    virtual ~SegmentStructure() = default;

    /// The nearest meeting with the mesh; body frame, `from` and `to` finite. No allocation.
    [[nodiscard]] virtual SegmentHit find_nearest_hit(const Vector3& from_B,
                                                      const Vector3& to_B) noexcept = 0;
    /// On the heap, beyond the mesh and its tree, which are there anyway.
    [[nodiscard]] virtual std::size_t memory_bytes() const noexcept = 0;
};

/// Refuses a mesh that is not there and settings out of range, which only h_collide has.
[[nodiscard]] Expected<std::unique_ptr<SegmentStructure>> make_segment_structure(
    SegmentStructureKind kind, std::shared_ptr<const CollisionMesh> mesh,
    const HCollideSettings& settings = {});

}  // namespace fulcrum
