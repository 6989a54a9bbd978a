// The step path of shading.h.
#include "haptics/surface/shading.h"

#include "haptics/math/length.h"

#include <algorithm>

namespace fulcrum {
namespace {}  // namespace

Vector3 ShadedNormals::normal_B(std::int32_t triangle, const Vector3& point_B,
                                const Vector3& side_B) const noexcept {
    const auto p = mesh_->places_B(triangle);
    const Vector3 doubled = (p[1] - p[0]).cross(p[2] - p[0]);
    // Twice the signed areas of the three triangles that the point makes with the sides.
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector3& a = p[(i + 1) % 3];
        const Vector3& b = p[(i + 2) % 3];
        const double area = (a - point_B).cross(b - point_B).dot(doubled);
        sum += std::max(area, 0.0) * corner_normal_B(triangle, i);
    }
    const double sign = side_B.dot(doubled) < 0.0 ? -1.0 : 1.0;
    const Vector3 smooth = compute_direction(sum);
    return smooth.squaredNorm() > 0.5 ? Vector3(sign * smooth)
                                      : Vector3(sign * compute_direction(doubled));
}

}  // namespace fulcrum
