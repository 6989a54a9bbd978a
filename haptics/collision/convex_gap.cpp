#include "haptics/collision/convex_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fulcrum {

namespace {

double with_sign(double size, double sign) noexcept {
    return sign < 0.0 ? -size : size;
}

}  // namespace

Vector3 ConvexCore::find_support(const Vector3& direction) const noexcept {
    switch (kind) {
        case Kind::segment:
            return {0.0, with_sign(half_m.y(), direction.y()), 0.0};
        case Kind::box:
            return {with_sign(half_m.x(), direction.x()), with_sign(half_m.y(), direction.y()),
                    with_sign(half_m.z(), direction.z())};
        case Kind::cylinder: {
            const double across =
                std::sqrt(direction.x() * direction.x() + direction.z() * direction.z());
            const double part = across > 0.0 ? half_m.x() / across : 0.0;
            return {part * direction.x(), with_sign(half_m.y(), direction.y()),
                    part * direction.z()};
        }
        case Kind::cloud:
            return *std::ranges::max_element(
                cloud, {}, [&](const Vector3& point) { return direction.dot(point); });
        case Kind::point:
            break;
    }
    return Vector3::Zero();
}

double ConvexCore::bounding_radius_m() const noexcept {
    double core_m = half_m.norm();
    for (const Vector3& point : cloud) {
        core_m = std::max(core_m, point.norm());
    }
    return core_m + radius_m;
}

bool Simplex::add(const Vector3& point) noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
        if (points_[i] == point) {
            return false;
        }
    }
    points_[count_++] = point;
    return true;
}

void Simplex::keep(std::size_t i) noexcept {
    points_[0] = points_[i];
    count_ = 1;
}

Vector3 Simplex::reduce() noexcept {
    switch (count_) {
        case 1:
            return points_[0];
        case 2:
            return reduce_segment();
        case 3:
            return reduce_triangle();
        default:
            return reduce_tetrahedron();
    }
}

Vector3 Simplex::reduce_segment() noexcept {
    const Vector3 along = points_[1] - points_[0];
    const double square = along.squaredNorm();
    const double t = square > 0.0 ? -points_[0].dot(along) / square : 0.0;
    if (!(t > 0.0)) {
        count_ = 1;
        return points_[0];
    }
    if (t >= 1.0) {
        keep(1);
        return points_[0];
    }
    return points_[0] + t * along;
}

// Over the face if it is over it, else on the nearest of its edges.
Vector3 Simplex::reduce_triangle() noexcept {
    const Vector3 a = points_[0];
    const Vector3 b = points_[1];
    const Vector3 c = points_[2];
    const Vector3 normal = (b - a).cross(c - a);
    const auto is_inside = [&normal](const Vector3& u, const Vector3& v) noexcept {
        return normal.dot((v - u).cross(-u)) > 0.0;
    };
    const double square = normal.squaredNorm();
    if (square > 0.0 && is_inside(a, b) && is_inside(b, c) && is_inside(c, a)) {
        return normal * (normal.dot(a) / square);
    }
    Simplex best;
    Vector3 nearest = Vector3::Zero();
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        Simplex edge;
        edge.points_[0] = u;
        edge.points_[1] = v;
        edge.count_ = 2;
        const Vector3 here = edge.reduce_segment();
        if (here.squaredNorm() < least) {
            least = here.squaredNorm();
            nearest = here;
            best = edge;
        }
    }
    *this = best;
    return nearest;
}

// Zero inside; else the nearest of the faces that the origin is in front of, or of all where rounding leaves none.
Vector3 Simplex::reduce_tetrahedron() noexcept {
    constexpr std::size_t kFaces[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
    constexpr double kFlat = 1.0e-12;  // of an edge: a height of mere rounding has no inside
    Simplex best;
    Vector3 nearest = Vector3::Zero();
    double least = std::numeric_limits<double>::infinity();
    bool is_inside = true;
    for (const auto& face : kFaces) {
        const Vector3& a = points_[face[0]];
        const Vector3 normal = (points_[face[1]] - a).cross(points_[face[2]] - a);
        const double inwards = normal.dot(points_[face[3]] - a);
        const double least_height = kFlat * normal.norm() * (points_[face[3]] - a).norm();
        if (-normal.dot(a) * inwards > 0.0 && std::abs(inwards) > least_height) {
            continue;  // the origin lies on the fourth point's side
        }
        is_inside = false;
        Simplex triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            triangle.points_[i] = points_[face[i]];
        }
        triangle.count_ = 3;
        const Vector3 here = triangle.reduce_triangle();
        if (here.squaredNorm() < least) {
            least = here.squaredNorm();
            nearest = here;
            best = triangle;
        }
    }
    if (is_inside) {
        return Vector3::Zero();
    }
    *this = best;
    return nearest;
}

}  // namespace fulcrum
