#include "haptics/voxel/triangle_clusters.h"

#include "haptics/geometry/bounding_tree.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

namespace {

double compute_square_distance_to_edge(const Vector3& p, const Vector3& from,
                                       const Vector3& to) noexcept {
    const Vector3 along = to - from;
    const Vector3 away = p - from;
    const double square = along.squaredNorm();
    const double t = square > 0.0 ? std::clamp(away.dot(along) / square, 0.0, 1.0) : 0.0;
    return (away - t * along).squaredNorm();
}

}  // namespace

double compute_square_distance(const Vector3& p, const TriangleAt& triangle) noexcept {
    const auto& [a, b, c] = triangle;
    const Vector3 ab = b - a;
    const Vector3 ac = c - a;
    const Vector3 normal = ab.cross(ac);
    const double square = normal.squaredNorm();
    const Vector3 ap = p - a;
    // The foot in the plane is a + v ab + w ac.
    const double v = ap.cross(ac).dot(normal);
    const double w = ab.cross(ap).dot(normal);
    constexpr double kSliver = 1.0e-20;  // sine of an angle, squared: its plane is mere rounding
    if (v >= 0.0 && w >= 0.0 && v + w <= square &&
        square > kSliver * ab.squaredNorm() * ac.squaredNorm()) {
        const double height = ap.dot(normal);
        return height * height / square;
    }
    return std::min({compute_square_distance_to_edge(p, a, b),
                     compute_square_distance_to_edge(p, b, c),
                     compute_square_distance_to_edge(p, c, a)});
}

TriangleClusters::TriangleClusters(const TriangleMesh& mesh) {
    const BoundingTree tree(mesh);
    triangles_.reserve(tree.order().size());
    for (const std::int32_t index : tree.order()) {
        const TriangleCorners& corners = mesh.triangles()[static_cast<std::size_t>(index)];
        const auto vertex = [&](std::size_t i) {
            return mesh.vertices_B()[static_cast<std::size_t>(corners[i])];
        };
        triangles_.push_back({vertex(0), vertex(1), vertex(2)});
    }
    build_leaves();
    build_parents();
}

void TriangleClusters::build_leaves() {
    for (std::size_t first = 0; first < triangles_.size(); first += kWidth) {
        const std::size_t end = std::min(triangles_.size(), first + kWidth);
        TriangleCluster cluster;
        double weight = 0.0;
        for (std::size_t i = first; i < end; ++i) {
            const TriangleAt& t = triangles_[i];
            const Vector3 area = t.area_vector();
            cluster.area_vector_B += area;
            cluster.centre_B += area.norm() / 3.0 * (t.a + t.b + t.c);
            weight += area.norm();
        }
        cluster.centre_B = weight > 0.0 ? Vector3(cluster.centre_B / weight) : triangles_[first].a;
        for (std::size_t i = first; i < end; ++i) {
            for (const Vector3& corner : {triangles_[i].a, triangles_[i].b, triangles_[i].c}) {
                cluster.radius_m = std::max(cluster.radius_m, (corner - cluster.centre_B).norm());
            }
        }
        clusters_.push_back(cluster);
    }
    level_first_[1] = static_cast<std::int32_t>(clusters_.size());
    n_levels_ = 1;
}

void TriangleClusters::build_parents() {
    while (count_at(n_levels_ - 1) > 1) {
        const std::int32_t n_below = count_at(n_levels_ - 1);
        for (std::int32_t first = 0; first < n_below; first += kWidth) {
            const std::int32_t end = std::min(n_below, first + kWidth);
            TriangleCluster parent;
            double weight = 0.0;
            for (std::int32_t i = first; i < end; ++i) {
                const TriangleCluster& child = cluster_at(n_levels_ - 1, i);
                const double share = child.radius_m * child.radius_m;  // about as its area
                parent.centre_B += share * child.centre_B;
                parent.area_vector_B += child.area_vector_B;
                weight += share;
            }
            parent.centre_B = weight > 0.0 ? Vector3(parent.centre_B / weight)
                                           : cluster_at(n_levels_ - 1, first).centre_B;
            for (std::int32_t i = first; i < end; ++i) {
                const TriangleCluster& child = cluster_at(n_levels_ - 1, i);
                parent.radius_m = std::max(
                    parent.radius_m, (child.centre_B - parent.centre_B).norm() + child.radius_m);
            }
            clusters_.push_back(parent);
        }
        ++n_levels_;
        level_first_[static_cast<std::size_t>(n_levels_)] =
            static_cast<std::int32_t>(clusters_.size());
    }
}

double TriangleClusters::find_distance(const Vector3& p_B, double at_most,
                                       double slack) const noexcept {
    std::array<Place, kStack> stack{};
    std::size_t n = 0;
    stack[n++] = root();
    double nearest = at_most;
    double nearest_square = at_most * at_most;
    double least_left_out = at_most;
    while (n > 0) {
        const Place place = stack[--n];
        if (place.bound >= (1.0 - slack) * nearest) {
            least_left_out = std::min(least_left_out, place.bound);
            continue;
        }
        const auto [first, end] = children_of(place);
        if (place.level == 0) {
            for (std::int32_t i = first; i < end; ++i) {
                nearest_square =
                    std::min(nearest_square,
                             compute_square_distance(p_B, triangles_[static_cast<std::size_t>(i)]));
            }
            nearest = std::sqrt(nearest_square);
            continue;
        }
        // Kept so that the nearest ball lies on top.
        const std::size_t bottom = n;
        for (std::int32_t i = first; i < end; ++i) {
            const TriangleCluster& child = cluster_at(place.level - 1, i);
            const double bound = (p_B - child.centre_B).norm() - child.radius_m;
            std::size_t at = n++;
            for (; at > bottom && stack[at - 1].bound < bound; --at) {
                stack[at] = stack[at - 1];
            }
            stack[at] = {place.level - 1, i, bound};
        }
    }
    return std::min(nearest, least_left_out);
}

}  // namespace fulcrum
