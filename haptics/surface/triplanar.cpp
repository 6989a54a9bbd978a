#include "haptics/surface/triplanar.h"

namespace fulcrum {

BodyOffset feel_on_body(const Texture& texture, const Vector3& place_B, const Vector3& stroke_B,
                        const Vector3& normal_B, double depth_m) noexcept {
    const Vector3 weights = compute_view_weights(normal_B);
    BodyOffset felt;
    double most = 0.0;
    double normal_m = 0.0;
    Vector3 along_B_m = Vector3::Zero();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double weight = weights[static_cast<Index>(axis)];
        if (!(weight > 0.0)) {
            continue;
        }
        const SurfaceVector place = project_on_view(axis, place_B);
        const TextureOffset one = texture.feel(place, project_on_view(axis, stroke_B), depth_m);
        normal_m += weight * one.normal_m;
        felt.height_m += weight * one.height_m;
        along_B_m[kViewAxes[axis][0]] += weight * one.along.u_m;
        along_B_m[kViewAxes[axis][1]] += weight * one.along.v_m;
        if (weight > most) {
            most = weight;
            felt.place = place;
        }
    }
    // - grad h + (grad h . N) N: what leaves the surface is taken out.
    felt.offset_B_m = along_B_m + (normal_m - along_B_m.dot(normal_B)) * normal_B;
    return felt;
}

}  // namespace fulcrum
