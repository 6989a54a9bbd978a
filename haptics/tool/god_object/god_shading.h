// A coarse mesh of a smooth body, felt smooth by the god-object's tool: the directions in which its contacts push the hand turn evenly from
// triangle to triangle. Where the tool goes they do not touch: there the true normals hold, and nothing enters.
//
//   a corner of the tool on a face of the object    the object's even normal there (surface/shading.h)
//   a corner of the object on a face of the tool    that of the tool, turned round
//   edge on edge                                    the mean of those whose edge is not a crease; where both are, the line between them
// Faces that are flat as far as their creases, and surfaces without shading, push as they did. A direction that would lie far from the
// line between the features is not taken.
//
// Thread: made at load, then read from any. Cost: O(n log n) at load, 100 bytes a triangle; 50 ns a contact.
// Source: H. Morgenbesser, M. Srinivasan 1996, Force shading for haptic shape perception, ASME DSC 58; D. Ruspini, K. Kolarov, O. Khatib 1997, The haptic
// display of complex graphical environments, SIGGRAPH, section 5. From a point to contacts of all kinds: M. Ortega, S. Redon, S. Coquillart 2007, IEEE
// TVCG 13(3), section 6.
#pragma once

#include "haptics/surface/shading.h"
#include "haptics/surface/surface_plan.h"
#include "haptics/tool/god_object/god_pair.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace fulcrum {

class GodShading {
  public:
    /// Of the mesh that the god-object's surface is made of. Refuses what `validate` of the settings does.
    [[nodiscard]] static Expected<std::shared_ptr<const GodShading>> create(
        const TriangleMesh& mesh, const ShadingSettings& settings);

    /// Unit, on the side that `side_B` is on; triangles as in the mesh.
    [[nodiscard]] Vector3 normal_B(std::int32_t triangle, const Vector3& at_B,
                                   const Vector3& side_B) const noexcept {
        return normals_.normal_B(touched_[static_cast<std::size_t>(triangle)], at_B, side_B);
    }
    /// Not a crease: both its triangles have the same normals at its ends.
    [[nodiscard]] bool is_even(std::int32_t triangle, std::size_t edge) const noexcept {
        return even_[static_cast<std::size_t>(triangle)][edge];
    }
    /// As ShadedNormals::bump_m.
    [[nodiscard]] double bump_m() const noexcept { return normals_.bump_m(); }
    [[nodiscard]] std::int32_t n_triangles() const noexcept {
        return static_cast<std::int32_t>(touched_.size());
    }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    GodShading(const TriangleMesh& mesh, std::shared_ptr<const CollisionMesh> touched,
               double crease_angle_deg);

    std::shared_ptr<const CollisionMesh> mesh_;
    ShadedNormals normals_;
    std::vector<std::int32_t> touched_;      // of the mesh's triangle: that of mesh_
    std::vector<std::array<bool, 3>> even_;  // of its edges, from each corner to the next
};

/// The direction in which a contact pushes the tool, in the object's frame; either may be none.
[[nodiscard]] Vector3 find_felt_normal_O(const GodShading* object, const GodShading* tool,
                                         const GodContact& contact, const Pose& X_OT) noexcept;

}  // namespace fulcrum
