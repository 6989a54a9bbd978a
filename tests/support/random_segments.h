// Segments that try a search over a mesh's triangles: at chance, and of every kind that is likely to go wrong.
#pragma once

#include "haptics/collision/collision_mesh.h"
#include "tests/support/wander.h"

#include <cmath>
#include <utility>

namespace fulcrum {

class RandomSegments {
  public:
    using Segment = std::pair<Vector3, Vector3>;
    static constexpr int kKinds = 12;

    RandomSegments(const CollisionMesh& mesh, unsigned seed)
        : mesh_(mesh), random_(seed), size_m_(mesh.radius_m()) {}

    /// Both ends anywhere about the mesh; every other one is short.
    Segment draw() {
        const Vector3 from = anywhere();
        const bool is_short = random_.integer() % 2 == 0;
        return {from, is_short ? Vector3(from + 0.1 * size_m_ * random_.in_cube()) : anywhere()};
    }

    /// Kind 0 to kKinds - 1: to, through, from corners and edges; along edges and axes; in a plane; without length; from very far.
    Segment draw_hard(int kind) {
        const Vector3 p = anywhere();
        const Vector3 corner = corner_of_any();
        const auto [u, v] = edge();
        switch (kind) {
            case 0:
                return {p, corner};
            case 1:
                return {corner - 0.5 * (p - corner), p};
            case 2:
                return {p, 0.5 * (u + v) + (0.5 * (u + v) - p)};
            case 3:
                return {u, v};
            case 4:
                return {u - 2.0 * (v - u), v + 2.0 * (v - u)};
            case 5:
                return {corner, corner_of_any()};
            case 6:  // parallel to an axis, through a corner
                return {corner - along_axis(), corner + along_axis()};
            case 7:
                return along_line(corner);
            case 8:
                return {corner, corner};
            case 9: {
                const Vector3& middle = random_.integer() % 2 == 0 ? Vector3(0.5 * (u + v)) : p;
                return {middle, middle};
            }
            case 10: {  // from far away through a corner, or past all
                const double far = std::pow(10.0, 7.5 + 6.0 * random_.uniform());
                const Vector3 way = far * size_m_ * random_.direction();
                return {corner - way, random_.integer() % 3 == 0 ? corner : Vector3(corner + way)};
            }
            default: {  // all of it far away
                const Vector3 away = 1.0e3 * size_m_ * random_.direction();
                return {p + away, corner + away};
            }
        }
    }

  private:
    Vector3 anywhere() { return mesh_.centre_B() + 1.3 * size_m_ * random_.in_cube(); }
    Vector3 along_axis() {
        return 3.0 * size_m_ * Vector3::Unit(static_cast<int>(random_.integer() % 3));
    }
    // Both ends on one line parallel to an axis.
    Segment along_line(const Vector3& through) {
        const Vector3 way = along_axis();
        return {through + random_.uniform() * way, through + random_.uniform() * way};
    }
    const TriangleCorners& triangle() {
        return mesh_.corners(static_cast<std::int32_t>(
            random_.integer() % static_cast<std::uint64_t>(mesh_.n_triangles())));
    }
    Vector3 corner_of_any() { return mesh_.vertex_B(triangle()[random_.integer() % 3]); }
    Segment edge() {
        const TriangleCorners& t = triangle();
        const std::size_t i = random_.integer() % 3;
        return {mesh_.vertex_B(t[i]), mesh_.vertex_B(t[(i + 1) % 3])};
    }

    const CollisionMesh& mesh_;
    Random random_;
    double size_m_;
};

}  // namespace fulcrum
