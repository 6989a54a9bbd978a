#include "assets/make/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace fulcrum::assets {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
/// Corners nearer than this are one corner as far as normals go.
constexpr double kWeld_m = 1e-7;

std::array<long, 3> weld_key(const Vector3& p) {
    return {std::lround(p.x() / kWeld_m), std::lround(p.y() / kWeld_m),
            std::lround(p.z() / kWeld_m)};
}

}  // namespace

void MeshPart::turn_inside_out() {
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        std::swap(indices[i + 1], indices[i + 2]);
    }
    for (Vector3& n : normals) {
        n = -n;
    }
}

void MeshPart::transform(const Affine& X) {
    const Matrix3 for_normals = X.linear().inverse().transpose();
    for (Vector3& p : positions) {
        p = X * p;
    }
    for (Vector3& n : normals) {
        n = (for_normals * n).normalized();
    }
}

void MeshPart::append(const MeshPart& other) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), other.positions.begin(), other.positions.end());
    normals.insert(normals.end(), other.normals.begin(), other.normals.end());
    uvs.insert(uvs.end(), other.uvs.begin(), other.uvs.end());
    for (const std::uint32_t index : other.indices) {
        indices.push_back(first + index);
    }
}

void smooth_normals(MeshPart& part) {
    std::map<std::array<long, 3>, Vector3> sums;
    for (std::size_t i = 0; i < part.indices.size(); i += 3) {
        const Vector3& a = part.positions[part.indices[i]];
        const Vector3& b = part.positions[part.indices[i + 1]];
        const Vector3& c = part.positions[part.indices[i + 2]];
        const Vector3 across = (b - a).cross(c - a);  // twice the area long
        for (const Vector3* p : {&a, &b, &c}) {
            sums.try_emplace(weld_key(*p), Vector3::Zero()).first->second += across;
        }
    }
    part.normals.clear();
    for (const Vector3& p : part.positions) {
        const auto found = sums.find(weld_key(p));
        const bool has_area = found != sums.end() && found->second.norm() > 0.0;
        part.normals.push_back(has_area ? Vector3(found->second.normalized()) : Vector3::UnitY());
    }
}

MeshPart tessellate(const Surface& surface, int columns, int rows) {
    MeshPart part;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const double u = static_cast<double>(column) / columns;
            const double v = static_cast<double>(row) / rows;
            part.positions.push_back(surface(u, v));
            part.uvs.emplace_back(u, v);
        }
    }
    const auto add = [&part](int a, int b, int c) {
        const auto key = [&](int i) {
            return weld_key(part.positions[static_cast<std::size_t>(i)]);
        };
        if (key(a) == key(b) || key(b) == key(c) || key(c) == key(a)) {
            return;  // at a pole the rectangle is one triangle
        }
        for (const int i : {a, b, c}) {
            part.indices.push_back(static_cast<std::uint32_t>(i));
        }
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int corner = row * (columns + 1) + column;
            const int below = corner + columns + 1;
            add(corner, below, below + 1);
            add(corner, below + 1, corner + 1);
        }
    }
    smooth_normals(part);
    return part;
}

Bulk bulk_of(const MeshPart& part) {
    Bulk bulk;
    for (std::size_t i = 0; i < part.indices.size(); i += 3) {
        const Vector3& a = part.positions[part.indices[i]];
        const Vector3& b = part.positions[part.indices[i + 1]];
        const Vector3& c = part.positions[part.indices[i + 2]];
        const double volume = a.dot(b.cross(c)) / 6.0;  // of the tetrahedron with the origin
        bulk.volume_m3 += volume;
        bulk.centroid += volume * (a + b + c) / 4.0;
    }
    if (bulk.volume_m3 != 0.0) {
        bulk.centroid /= bulk.volume_m3;
    }
    return bulk;
}

Surface revolve(std::function<Vector2(double v)> profile) {
    return [profile = std::move(profile)](double u, double v) {
        const Vector2 p = profile(v);
        const double angle = kTwoPi * (u == 1.0 ? 0.0 : u);
        return Vector3(p.x() * std::sin(angle), p.y(), p.x() * std::cos(angle));
    };
}

Vector2 curve_through(const std::vector<Vector2>& points, double t) {
    const auto last = static_cast<int>(points.size()) - 1;
    const double along = std::clamp(t, 0.0, 1.0) * last;
    const int i = std::min(static_cast<int>(along), last - 1);
    const double f = along - i;
    const auto at = [&](int k) { return points[static_cast<std::size_t>(std::clamp(k, 0, last))]; };
    const Vector2 a = at(i - 1);
    const Vector2 b = at(i);
    const Vector2 c = at(i + 1);
    const Vector2 d = at(i + 2);
    return 0.5 * (2.0 * b + (c - a) * f + (2.0 * a - 5.0 * b + 4.0 * c - d) * f * f +
                  (3.0 * b - a - 3.0 * c + d) * f * f * f);
}

Surface tube(std::function<Vector3(double t)> curve, std::function<double(double t)> radius) {
    return [curve = std::move(curve), radius = std::move(radius)](double u, double v) {
        constexpr double kStep = 1e-4;
        const Vector3 along =
            (curve(std::min(v + kStep, 1.0)) - curve(std::max(v - kStep, 0.0))).normalized();
        // Curves of ours stay in or near the plane z = 0: its normal is never along them.
        const Vector3 side = Vector3::UnitZ().cross(along).normalized();
        const Vector3 front = along.cross(side);
        const double angle = kTwoPi * (u == 1.0 ? 0.0 : u);
        return Vector3(curve(v) + radius(v) * (std::cos(angle) * side + std::sin(angle) * front));
    };
}

Surface ellipsoid(const Vector3& radii_m) {
    return [radii_m](double u, double v) {
        const double around = kTwoPi * (u == 1.0 ? 0.0 : u);
        const double ring = v == 1.0 ? 0.0 : std::sin(std::numbers::pi * v);
        return Vector3(Vector3(ring * std::sin(around), std::cos(std::numbers::pi * v),
                               ring * std::cos(around))
                           .cwiseProduct(radii_m));
    };
}

}  // namespace fulcrum::assets
