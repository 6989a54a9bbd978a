#include "tests/support/nearest_point.h"

#include <algorithm>

namespace fulcrum {

Vector3 find_nearest_on_triangle(const Vector3& p, const Vector3& a, const Vector3& b,
                                 const Vector3& c) {
    const Vector3 normal = (b - a).cross(c - a);
    const auto beside = [&](const Vector3& u, const Vector3& v) {
        return normal.dot((v - u).cross(p - u)) < 0.0;
    };
    const auto on_edge = [&p](const Vector3& u, const Vector3& v) -> Vector3 {
        return u + std::clamp((p - u).dot(v - u) / (v - u).squaredNorm(), 0.0, 1.0) * (v - u);
    };
    if (!beside(a, b) && !beside(b, c) && !beside(c, a)) {
        return p - normal * (normal.dot(p - a) / normal.squaredNorm());
    }
    Vector3 nearest = on_edge(a, b);
    for (const Vector3& other : {on_edge(b, c), on_edge(c, a)}) {
        nearest = (other - p).norm() < (nearest - p).norm() ? other : nearest;
    }
    return nearest;
}

Vector3 find_nearest_on_mesh(const CollisionMesh& mesh, const Vector3& p) {
    Vector3 nearest = mesh.vertex_B(0);
    for (std::int32_t i = 0; i < mesh.n_triangles(); ++i) {
        const TriangleCorners& t = mesh.corners(i);
        const Vector3 here = find_nearest_on_triangle(p, mesh.vertex_B(t[0]), mesh.vertex_B(t[1]),
                                                      mesh.vertex_B(t[2]));
        nearest = (here - p).norm() < (nearest - p).norm() ? here : nearest;
    }
    return nearest;
}

Vector2 find_nearest_in_polygon(const std::vector<Vector2>& corners, const Vector2& p) {
    bool inside = true;
    Vector2 nearest = corners.front();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vector2& u = corners[i];
        const Vector2 along = corners[(i + 1) % corners.size()] - u;
        const Vector2 from_u = p - u;
        inside = inside && along.x() * from_u.y() - along.y() * from_u.x() >= 0.0;
        const Vector2 here =
            u + std::clamp(from_u.dot(along) / along.squaredNorm(), 0.0, 1.0) * along;
        nearest = (here - p).norm() < (nearest - p).norm() ? here : nearest;
    }
    return inside ? p : nearest;
}

}  // namespace fulcrum
