// The load path of shading.h.
#include "haptics/math/length.h"
#include "haptics/surface/shading.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace fulcrum {
namespace {

constexpr double kCancelled = 1.0e-6;  // a sum of unit vectors shorter than this has no direction

// Corners, three a triangle, joined into groups; each group is named by its least corner.
class Groups {
  public:
    explicit Groups(std::size_t n) : parent_(n) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    std::size_t find(std::size_t corner) {
        while (parent_[corner] != corner) {
            parent_[corner] = parent_[parent_[corner]];
            corner = parent_[corner];
        }
        return corner;
    }
    void join(std::size_t a, std::size_t b) {
        const std::size_t root_a = find(a);
        const std::size_t root_b = find(b);
        parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
    }

  private:
    std::vector<std::size_t> parent_;
};

// A side of a triangle: its ends in order, and the corners that lie there.
struct Side {
    std::array<std::int32_t, 2> vertices;
    std::array<std::size_t, 2> corners;
    bool forward;  // runs from the lesser vertex to the greater

    [[nodiscard]] std::size_t triangle() const { return corners[0] / 3; }
};

std::vector<Side> list_sides(const CollisionMesh& mesh) {
    std::vector<Side> sides;
    sides.reserve(3 * static_cast<std::size_t>(mesh.n_triangles()));
    for (std::int32_t t = 0; t < mesh.n_triangles(); ++t) {
        const TriangleCorners& corners = mesh.corners(t);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t next = (i + 1) % 3;
            const std::size_t first = 3 * static_cast<std::size_t>(t);
            Side side{{corners[i], corners[next]}, {first + i, first + next}, true};
            if (side.vertices[0] > side.vertices[1]) {
                std::swap(side.vertices[0], side.vertices[1]);
                std::swap(side.corners[0], side.corners[1]);
                side.forward = false;
            }
            sides.push_back(side);
        }
    }
    std::ranges::stable_sort(sides, {}, &Side::vertices);
    return sides;
}

// Joins the corners at both ends of every edge of two triangles that bends by at most the crease angle.
void join_over_edges(const std::vector<Side>& sides, const std::vector<Vector3>& faces_B,
                     double crease_rad, Groups& groups) {
    for (std::size_t first = 0; first < sides.size();) {
        std::size_t end = first + 1;
        while (end < sides.size() && sides[end].vertices == sides[first].vertices) {
            ++end;
        }
        const Side& a = sides[first];
        const Side& b = sides[end - 1];
        if (end - first == 2 && a.forward != b.forward) {
            const Vector3& n_a = faces_B[a.triangle()];
            const Vector3& n_b = faces_B[b.triangle()];
            if (std::atan2(n_a.cross(n_b).norm(), n_a.dot(n_b)) <= crease_rad) {
                groups.join(a.corners[0], b.corners[0]);
                groups.join(a.corners[1], b.corners[1]);
            }
        }
        first = end;
    }
}

double angle_between(const Vector3& a, const Vector3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

ShadedNormals::ShadedNormals(std::shared_ptr<const CollisionMesh> mesh, double crease_angle_deg)
    : mesh_(std::move(mesh)) {
    const auto n = static_cast<std::size_t>(mesh_->n_triangles());
    std::vector<Vector3> faces_B(n);
    for (std::size_t t = 0; t < n; ++t) {
        const auto p = mesh_->places_B(static_cast<std::int32_t>(t));
        faces_B[t] = compute_direction(Vector3((p[1] - p[0]).cross(p[2] - p[0])));
    }
    Groups groups(3 * n);
    // A bend that is the crease angle itself, but for rounding, is still smooth.
    constexpr double kRounding_rad = 1.0e-9;
    join_over_edges(list_sides(*mesh_), faces_B,
                    crease_angle_deg * std::numbers::pi / 180.0 + kRounding_rad, groups);
    // One normal a group, numbered as they come.
    std::vector<std::int32_t> number(3 * n, -1);
    groups_.resize(n);
    std::vector<std::size_t> face_of_group;
    for (std::size_t corner = 0; corner < 3 * n; ++corner) {
        const std::size_t t = corner / 3;
        const std::size_t i = corner % 3;
        std::int32_t& group = number[groups.find(corner)];
        if (group < 0) {
            group = static_cast<std::int32_t>(normals_B_.size());
            normals_B_.emplace_back(Vector3::Zero());
            face_of_group.push_back(t);
        }
        const auto p = mesh_->places_B(static_cast<std::int32_t>(t));
        const double angle = angle_between(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
        normals_B_[static_cast<std::size_t>(group)] += angle * faces_B[t];
        groups_[t][i] = group;
    }
    for (std::size_t g = 0; g < normals_B_.size(); ++g) {
        const double length = normals_B_[g].norm();
        normals_B_[g] =
            length > kCancelled ? Vector3(normals_B_[g] / length) : faces_B[face_of_group[g]];
    }
    for (std::size_t t = 0; t < n; ++t) {
        const auto p = mesh_->places_B(static_cast<std::int32_t>(t));
        const Vector3 middle_B = (p[0] + p[1] + p[2]) / 3.0;
        double least_m = 0.0;
        double most_m = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector3& normal_B = corner_normal_B(static_cast<std::int32_t>(t), i);
            const Vector3 lean = normal_B - normal_B.dot(faces_B[t]) * faces_B[t];
            const double work_m = 0.5 * lean.dot(p[i] - middle_B);
            least_m = std::min(least_m, work_m);
            most_m = std::max(most_m, work_m);
        }
        bump_m_ = std::max(bump_m_, most_m - least_m);
    }
}

}  // namespace fulcrum
