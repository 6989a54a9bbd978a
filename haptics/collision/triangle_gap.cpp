#include "haptics/collision/triangle_gap.h"

#include <cmath>
#include <limits>

namespace fulcrum {

TriangleGap find_gap_to_edges(const TriangleForGap& t, const Vector3& from_a, bool ab, bool ac,
                              bool bc) noexcept {
    Vector3 nearest = from_a;
    TrianglePart nearest_part = TrianglePart::corner;
    double least = std::numeric_limits<double>::infinity();
    const auto ask = [&](const Vector3& from, const Vector3& edge, TrianglePart name) noexcept {
        const Vector3 there = from_a - from;
        const double along = edge.squaredNorm();
        const double part = along > 0.0 ? std::clamp(there.dot(edge) / along, 0.0, 1.0) : 0.0;
        const Vector3 apart = there - part * edge;
        const double square = apart.squaredNorm();
        if (square < least) {
            least = square;
            nearest = apart;
            nearest_part = part > 0.0 && part < 1.0 ? name : TrianglePart::corner;
        }
    };
    if (ab) {
        ask(Vector3::Zero(), t.ab, TrianglePart::ab);
    }
    if (ac) {
        ask(Vector3::Zero(), t.ac, TrianglePart::ac);
    }
    if (bc) {
        ask(t.ab, t.ac - t.ab, TrianglePart::bc);
    }
    const double distance_m = std::sqrt(least);
    // On the edge itself no direction is nearer than another: the front's.
    return {distance_m > 0.0 ? Vector3(nearest / distance_m) : t.normal, distance_m, nearest_part};
}

}  // namespace fulcrum
