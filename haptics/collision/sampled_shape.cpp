#include "haptics/collision/sampled_shape.h"

#include "haptics/collision/shape_gap.h"
#include "haptics/math/length.h"

#include <limits>

namespace fulcrum {
namespace {

Gap to_hull_gap(const HullFaces& hull, const Vector3& p_B) noexcept {
    Gap gap{.gap_m = -std::numeric_limits<double>::infinity()};
    for (const HullFaces::Face& face : hull.faces) {
        const double over_m = face.normal_B.dot(p_B - hull.vertices_B[hull.corners[face.first]]);
        if (over_m > gap.gap_m) {
            gap = {.normal_B = face.normal_B, .gap_m = over_m};
        }
    }
    return gap;
}

Gap to_field_gap(const DistanceField& field, const Vector3& p_B) noexcept {
    const DistanceSample near = field.sample(p_B);
    if (near.value_m > -DistanceField::kDeepFrom * field.band_m()) {
        const bool has_slope = near.slope.squaredNorm() > 0.0;
        return {.normal_B = has_slope ? compute_direction(near.slope) : Vector3(Vector3::UnitY()),
                .gap_m = near.value_m};
    }
    const DepthSample deep = field.sample_depth(p_B);
    const bool has_way = deep.way_out.squaredNorm() > 0.0;
    return {.normal_B = has_way ? compute_direction(deep.way_out) : Vector3(Vector3::UnitY()),
            .gap_m = -deep.depth_m};
}

}  // namespace

// One after the other: std::visit may throw.
Gap SampledShape::at(const Vector3& p_B) const noexcept {
    if (const auto* field = std::get_if<DistanceField>(&distance_)) {
        return to_field_gap(*field, p_B);
    }
    if (const auto* hull = std::get_if<Hull>(&distance_)) {
        return to_hull_gap(**hull, p_B);
    }
    if (const auto* box = std::get_if<BoxShape>(&distance_)) {
        return find_gap(*box, p_B);
    }
    if (const auto* cylinder = std::get_if<CylinderShape>(&distance_)) {
        return find_gap(*cylinder, p_B);
    }
    if (const auto* capsule = std::get_if<CapsuleShape>(&distance_)) {
        return find_gap(*capsule, p_B);
    }
    const auto* sphere = std::get_if<SphereShape>(&distance_);
    return sphere != nullptr ? find_gap(*sphere, p_B) : Gap{};
}

double SampledShape::bound_m(const Vector3& p_B) const noexcept {
    if (const auto* field = std::get_if<DistanceField>(&distance_)) {
        return field->bound_distance_m(p_B);
    }
    return at(p_B).gap_m;
}

}  // namespace fulcrum
