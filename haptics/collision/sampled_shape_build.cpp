#include "haptics/collision/mesh_copy.h"
#include "haptics/collision/sampled_shape.h"
#include "haptics/geometry/shape.h"
#include "haptics/math/length.h"

#include <algorithm>
#include <string>
#include <utility>

namespace fulcrum {
namespace {

constexpr double kRounding_voxels = 0.03;
constexpr double kCellsABand = 32.0;
// Half a voxel under the surface a field that holds a wall is at least a third of that deep.
constexpr double kDeepVoxels = 0.5;
constexpr double kHeldPart = 0.33;
constexpr double kMostLost = 0.1;  // at edges and tips some are
constexpr double kFeatureShare = 1.0e-3;
constexpr int kSides = 64;         // of a cylinder's samples
constexpr int kRows = 16;          // of a capsule's half balls
constexpr int kBallFrequency = 8;  // of a sphere's

struct MakeSampledMesh {
    Expected<TriangleMesh> operator()(const SphereShape& sphere) const {
        return make_sphere(sphere.radius_m, kBallFrequency);
    }
    Expected<TriangleMesh> operator()(const BoxShape& box) const {
        return make_box(2.0 * box.half_size_m);
    }
    Expected<TriangleMesh> operator()(const CapsuleShape& capsule) const {
        if (!(capsule.half_length_m > 0.0)) {
            return make_sphere(capsule.radius_m, kBallFrequency);
        }
        return make_capsule(capsule.radius_m, 2.0 * capsule.half_length_m, kSides, kRows);
    }
    Expected<TriangleMesh> operator()(const CylinderShape& cylinder) const {
        return make_cylinder(cylinder.radius_m, 2.0 * cylinder.half_height_m, kSides);
    }
    Expected<TriangleMesh> operator()(const HullShape& hull) const {
        return copy_triangles(*hull.mesh);
    }
    Expected<TriangleMesh> operator()(const MeshShape& mesh) const { return copy_triangles(*mesh); }
    template <class Other>
    Expected<TriangleMesh> operator()(const Other& /*other*/) const {
        return fail("a body that others run into is a height field or a distance function", {},
                    "give it a closed mesh, a hull or a shape in closed form");
    }
};

// Of the places on the faces, those that a field too coarse for them has lost: under them nothing is inside.
double find_lost_share(const DistanceField& field, const SurfaceSamples& samples) {
    int n_lost = 0;
    int n_faces = 0;
    for (const SurfaceSample& sample : samples.all()) {
        if (sample.kind != SampleKind::face) {
            continue;
        }
        const DistanceSample near = field.sample(sample.place_B);
        const Vector3 inwards = -compute_direction(near.slope);
        const double deep_m = kDeepVoxels * field.frame().voxel_m;
        const double under_m = field.sample(Vector3(sample.place_B + deep_m * inwards)).value_m;
        ++n_faces;
        n_lost += under_m < -kHeldPart * deep_m ? 0 : 1;
    }
    return static_cast<double>(n_lost) / std::max(n_faces, 1);
}

Expected<DistanceField> make_field(const TriangleMesh& mesh, int n_cells,
                                   const LoadProgress& progress) {
    // As far as a body of 96 cells has it: places that are to slide have to know which way.
    const double band_voxels = std::clamp(n_cells / kCellsABand, 3.0, 16.0);
    const auto frame = make_field_frame(mesh, n_cells, band_voxels);
    if (!frame) {
        return tl::make_unexpected(frame.error());
    }
    auto field = DistanceField::build(mesh, *frame, {.band_voxels = band_voxels}, progress);
    if (field && field->counts().n_open_edges > 0) {
        return fail("its mesh is open, so nothing says what is inside", {},
                    "close its holes, or give it shape = \"hull\"");
    }
    return field;
}

}  // namespace

SampledShape::SampledShape(Distance distance, SurfaceSamples samples)
    : distance_(std::move(distance)), samples_(std::move(samples)) {
    if (const auto* field = std::get_if<DistanceField>(&distance_)) {
        rounding_m_ = kRounding_voxels * field->frame().voxel_m;
        feature_m_ = field->frame().voxel_m;
        return;
    }
    for (const SurfaceSample& sample : samples_.all()) {
        feature_m_ = std::max(feature_m_, kFeatureShare * compute_length(sample.place_B));
    }
}

Expected<std::shared_ptr<const SampledShape>> SampledShape::make(
    const SolidShape& shape, const SampledShapeSettings& settings, const LoadProgress& progress) {
    if (const auto valid = validate(shape); !valid) {
        return tl::make_unexpected(valid.error());
    }
    if (settings.n_cells < 16 || settings.n_cells > 512 || settings.n_cells % 8 != 0) {
        return fail("a body's cells must number 16 to 512 in eights, not " +
                        std::to_string(settings.n_cells),
                    {}, "96 do for most");
    }
    const auto mesh = std::visit(MakeSampledMesh{}, shape);
    if (!mesh) {
        return tl::make_unexpected(mesh.error());
    }
    const bool is_mesh = std::holds_alternative<MeshShape>(shape);
    const int n_places = is_mesh ? settings.n_face_places : settings.n_face_places / 4;
    auto samples = SurfaceSamples::make(*mesh, n_places);
    if (!samples) {
        return tl::make_unexpected(samples.error());
    }
    const auto with = [&](Distance distance) {
        return std::shared_ptr<const SampledShape>(
            new SampledShape(std::move(distance), std::move(*samples)));
    };
    if (is_mesh) {
        auto field = make_field(*mesh, settings.n_cells, progress);
        if (!field) {
            return tl::make_unexpected(field.error());
        }
        if (find_lost_share(*field, *samples) > kMostLost) {
            return fail("a part of it is thinner than one cell of " +
                            std::to_string(1000.0 * field->frame().voxel_m) +
                            " mm, and would let things through",
                        {}, "make its walls thicker, or give it shape = \"hull\"");
        }
        return with(std::move(*field));
    }
    if (std::holds_alternative<HullShape>(shape)) {
        const auto hull = make_contact_shape(shape);
        if (!hull) {
            return tl::make_unexpected(hull.error());
        }
        return with(hull->hull);
    }
    if (const auto* sphere = std::get_if<SphereShape>(&shape)) {
        return with(*sphere);
    }
    if (const auto* box = std::get_if<BoxShape>(&shape)) {
        return with(*box);
    }
    if (const auto* capsule = std::get_if<CapsuleShape>(&shape)) {
        return with(*capsule);
    }
    return with(std::get<CylinderShape>(shape));
}

std::size_t SampledShape::memory_bytes() const noexcept {
    const auto* field = std::get_if<DistanceField>(&distance_);
    return sizeof(*this) + samples_.memory_bytes() + (field ? field->memory_bytes() : 0);
}

}  // namespace fulcrum
