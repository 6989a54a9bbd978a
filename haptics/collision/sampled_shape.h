// A solid made ready to meet one that is not convex: how far any place is from it, and samples of its surface.
//
//   sphere, box, capsule, cylinder   distance in closed form (shape_gap.h)
//   hull                             the greatest height over its faces' planes: the depth inside; outside a bound of the distance, by the
//                                    normal of a face
//   mesh                             a signed distance field, and where that ends within, the depth that goes on (distance_field.h)
// Samples (surface_samples.h) of round shapes are those of a mesh by rule; what slides along the surface is put back on it by the
// distance itself.
//
// Thread: made at load; distances from any thread. Cost: 5 to 30 ns, of a hull one product a face; a field of a block of 96 some 0.2 s
// and 1 MB.
// Source: meshes against distance fields: E. Guendelman, R. Bridson, R. Fedkiw 2003, Nonconvex rigid bodies with stacking, SIGGRAPH,
// section 5.
#pragma once

#include "haptics/base/parallel_for.h"
#include "haptics/collision/contact_shape.h"
#include "haptics/collision/obstacle.h"
#include "haptics/collision/surface_samples.h"
#include "haptics/voxel/distance_field.h"

#include <memory>
#include <variant>

namespace fulcrum {

struct SampledShapeSettings {
    int n_cells = 96;  ///< of a field along the mesh's longest side, a multiple of 8, 16 to 512
    int n_face_places = 1024;  ///< 64 to 100 000; of all but meshes a quarter of it
};

class SampledShape {
  public:
    /// Refuses what `validate` of a shape does, height fields and distance functions, settings out of range, and meshes that have no
    /// inside or are refused as a field or as samples. An error too where `progress` stops it.
    [[nodiscard]] static Expected<std::shared_ptr<const SampledShape>> make(
        const SolidShape& shape, const SampledShapeSettings& settings = {},
        const LoadProgress& progress = {});

    /// The gap at a place and the unit normal, away from the solid.
    [[nodiscard]] Gap at(const Vector3& p_B) const noexcept;
    /// No place nearer to `p_B` than this is outside if it is inside, or the other way round; below 0 inside. 0 where nothing is known.
    [[nodiscard]] double bound_m(const Vector3& p_B) const noexcept;

    /// By how much a field's surface is off beside an edge: 0.03 voxels; 0 of closed forms.
    [[nodiscard]] double rounding_m() const noexcept { return rounding_m_; }

    /// How near to an edge the normal begins to turn: a voxel, or of closed forms a thousandth of the size.
    [[nodiscard]] double feature_m() const noexcept { return feature_m_; }

    [[nodiscard]] const SurfaceSamples& samples() const noexcept { return samples_; }
    /// Whether it may look inwards somewhere: a mesh.
    [[nodiscard]] bool is_mesh() const noexcept {
        return std::holds_alternative<DistanceField>(distance_);
    }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    using Hull = std::shared_ptr<const HullFaces>;
    using Distance =
        std::variant<SphereShape, BoxShape, CapsuleShape, CylinderShape, Hull, DistanceField>;
    SampledShape(Distance distance, SurfaceSamples samples);

    Distance distance_;
    SurfaceSamples samples_;
    double rounding_m_ = 0.0;
    double feature_m_ = 0.0;
};

}  // namespace fulcrum
