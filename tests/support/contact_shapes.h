// Bodies of every shape that may touch another, and how far they are apart by trying directions.
#pragma once

#include "haptics/collision/contact_axis.h"
#include "tests/support/wander.h"

#include <cmath>
#include <vector>

namespace fulcrum {

/// One of each kind, about `size_m` across; the hull has triangles, a quadrilateral and a pentagon.
inline std::vector<ContactShape> make_contact_shapes(double size_m) {
    const double s = size_m;
    std::vector<Vector3> corners{{0.4, 0.3, 0.5},   {-0.5, 0.3, 0.4},  {-0.4, 0.3, -0.5},
                                 {0.5, 0.3, -0.4},  {0.0, 0.3, 0.6},   {0.3, -0.5, 0.3},
                                 {-0.3, -0.4, 0.3}, {0.0, -0.6, -0.4}, {0.1, -0.2, 0.55}};
    for (Vector3& corner : corners) {
        corner *= s;
    }
    return {make_contact_shape(SphereShape{0.5 * s}).value(),
            make_contact_shape(CapsuleShape{0.3 * s, 0.4 * s}).value(),
            make_contact_shape(BoxShape{s * Vector3(0.5, 0.3, 0.4)}).value(),
            make_contact_shape(CylinderShape{0.4 * s, 0.3 * s}).value(),
            make_contact_shape(make_hull_shape(corners).value()).value()};
}

/// The gap of the bodies along a unit vector.
inline double find_gap_along(const PlacedShape& a, const PlacedShape& b, const Vector3& n) {
    return n.dot(a.find_support(-n) - b.find_support(n)) - a.shape->core.radius_m -
           b.shape->core.radius_m;
}

/// The greatest of all gaps along directions: of 2000 over the sphere, then near the best in steps that shrink.
inline double search_gap_m(const PlacedShape& a, const PlacedShape& b) {
    Vector3 best = Vector3::UnitY();
    constexpr int kOnSphere = 2000;
    for (int i = 0; i < kOnSphere; ++i) {
        const double y = 1.0 - 2.0 * (i + 0.5) / kOnSphere;
        const double turn = 2.399963229728653 * i;
        const double r = std::sqrt(1.0 - y * y);
        const Vector3 n(r * std::cos(turn), y, r * std::sin(turn));
        best = find_gap_along(a, b, n) > find_gap_along(a, b, best) ? n : best;
    }
    Random random(7);
    double width = 0.1;
    for (int i = 0; i < 400; ++i, width *= 0.97) {
        const Vector3 n = (best + width * random.in_cube()).normalized();
        best = find_gap_along(a, b, n) > find_gap_along(a, b, best) ? n : best;
    }
    return find_gap_along(a, b, best);
}

}  // namespace fulcrum
