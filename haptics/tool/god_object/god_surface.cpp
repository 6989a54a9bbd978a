#include "haptics/tool/god_object/god_surface.h"

#include "haptics/geometry/mesh_edges.h"
#include "haptics/math/orientation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace fulcrum {
namespace {

constexpr double kFlat = 1.0e-9;      // the sine between two triangles of one plane
constexpr double kOnBorder = 1.0e-9;  // of an edge's length: a place on it, or at its end
constexpr std::size_t kNoCorner = 3;

bool is_before(const Vector3& a, const Vector3& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

// How far from the line through both, squared.
double square_from_line(const Vector3& at, const Vector3& a, const Vector3& along) {
    return along.cross(at - a).squaredNorm() / along.squaredNorm();
}

}  // namespace

GodSurface::GodSurface(const TriangleMesh& mesh) : swept_(SweptMesh::create(mesh)) {
    number_places(mesh);
    list_edges();
    list_parts();
    share_out();
}

std::shared_ptr<const GodSurface> GodSurface::create(const TriangleMesh& mesh) {
    return std::shared_ptr<const GodSurface>(new GodSurface(mesh));
}

void GodSurface::number_places(const TriangleMesh& mesh) {
    const std::vector<Vector3>& vertices = mesh.vertices_B();
    std::vector<std::int32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0);
    const auto at = [&](std::int32_t i) { return vertices[static_cast<std::size_t>(i)]; };
    std::ranges::sort(order,
                      [&](std::int32_t a, std::int32_t b) { return is_before(at(a), at(b)); });
    std::vector<std::int32_t> place_of_vertex(vertices.size());
    for (const std::int32_t i : order) {
        if (places_B_.empty() || places_B_.back() != at(i)) {
            places_B_.push_back(at(i));
        }
        place_of_vertex[static_cast<std::size_t>(i)] =
            static_cast<std::int32_t>(places_B_.size()) - 1;
    }
    triangles_ = mesh.triangles();
    for (TriangleCorners& triangle : triangles_) {
        for (std::int32_t& corner : triangle) {
            corner = place_of_vertex[static_cast<std::size_t>(corner)];
        }
    }
}

// Two triangles, on either side of their edge, in one plane.
bool GodSurface::is_flat(std::int32_t low, std::int32_t high,
                         std::span<const std::int32_t> wings) const {
    if (wings.size() != 2) {
        return false;
    }
    const auto at = [&](std::int32_t i) -> const Vector3& {
        return places_B_[static_cast<std::size_t>(i)];
    };
    const Vector3 along = (at(high) - at(low)).normalized();
    std::array<Vector3, 2> across;
    for (std::size_t k = 0; k < 2; ++k) {
        const Vector3 to_wing = at(wings[k]) - at(low);
        across[k] = (to_wing - along.dot(to_wing) * along).normalized();
    }
    return across[0].dot(across[1]) < 0.0 && across[0].cross(across[1]).norm() <= kFlat;
}

void GodSurface::list_edges() {
    edges_of_.resize(triangles_.size());
    corner_carries_.assign(places_B_.size(), false);
    const std::vector<MeshEdge> edges = collect_edges(triangles_, places_B_.size());
    std::vector<std::pair<std::int32_t, std::int32_t>> rings;
    for_each_shared_edge(edges, [&](std::span<const MeshEdge> shared) {
        const std::int32_t low = shared.front().low;
        const std::int32_t high = shared.front().high;
        const std::size_t begin = wings_.places.size();
        for (const MeshEdge& edge : shared) {
            const TriangleCorners& t = triangles_[static_cast<std::size_t>(edge.triangle)];
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int32_t next = t[(k + 1) % 3];
                if ((t[k] == low && next == high) || (t[k] == high && next == low)) {
                    wings_.places.push_back(t[(k + 2) % 3]);
                    edges_of_[static_cast<std::size_t>(edge.triangle)][k] =
                        static_cast<std::int32_t>(edge_carries_.size());
                }
            }
        }
        is_closed_ = is_closed_ && shared.size() == 2;
        const bool carries = !is_flat(low, high, std::span(wings_.places).subspan(begin));
        wings_.first.push_back(static_cast<std::int32_t>(wings_.places.size()));
        edge_carries_.push_back(carries);
        for (const std::int32_t end : {low, high}) {
            corner_carries_[static_cast<std::size_t>(end)] =
                corner_carries_[static_cast<std::size_t>(end)] || carries;
        }
        rings.emplace_back(low, high);
        rings.emplace_back(high, low);
    });
    std::ranges::sort(rings);
    for (std::size_t place = 0, i = 0; place < places_B_.size(); ++place) {
        for (; i < rings.size() && rings[i].first == static_cast<std::int32_t>(place); ++i) {
            rings_.places.push_back(rings[i].second);
        }
        rings_.first.push_back(static_cast<std::int32_t>(rings_.places.size()));
    }
}

// From each corner that no part has yet, along all edges.
void GodSurface::list_parts() {
    std::vector<bool> is_taken(places_B_.size(), false);
    std::vector<std::int32_t> waiting;
    for (std::size_t i = 0; i < places_B_.size(); ++i) {
        if (is_taken[i] || rings_.of(i).empty()) {
            continue;
        }
        parts_.push_back(static_cast<std::int32_t>(i));
        is_taken[i] = true;
        waiting.push_back(parts_.back());
        while (!waiting.empty()) {
            const auto place = static_cast<std::size_t>(waiting.back());
            waiting.pop_back();
            for (const std::int32_t other : rings_.of(place)) {
                if (!is_taken[static_cast<std::size_t>(other)]) {
                    is_taken[static_cast<std::size_t>(other)] = true;
                    waiting.push_back(other);
                }
            }
        }
    }
}

void GodSurface::share_out() {
    own_.assign(triangles_.size(), 0);
    std::vector<bool> corner_taken(places_B_.size(), false);
    std::vector<bool> edge_taken(edge_carries_.size(), false);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto corner = static_cast<std::size_t>(triangles_[t][k]);
            const auto edge = static_cast<std::size_t>(edges_of_[t][k]);
            const bool owns_corner = corner_carries_[corner] && !corner_taken[corner];
            const bool owns_edge = edge_carries_[edge] && !edge_taken[edge];
            corner_taken[corner] = true;
            edge_taken[edge] = true;
            own_[t] = static_cast<std::uint8_t>(own_[t] | (owns_corner ? 1U << k : 0U) |
                                                (owns_edge ? 1U << (kEdgeBit + k) : 0U));
        }
    }
}

double GodSurface::find_rise_m(std::span<const std::int32_t> places, const Vector3& at_B,
                               const Vector3& direction_B, double epsilon) const noexcept {
    double most_m = 0.0;
    for (const std::int32_t place : places) {
        const Vector3 to_place = places_B_[static_cast<std::size_t>(place)] - at_B;
        const double rise_m = direction_B.dot(to_place);
        if (rise_m > most_m && rise_m * rise_m > epsilon * epsilon * to_place.squaredNorm()) {
            most_m = rise_m;
        }
    }
    return most_m;
}

double GodSurface::find_rise_m(std::int32_t triangle, const Vector3& at_B,
                               const Vector3& direction_B, double epsilon) const noexcept {
    const TriangleCorners& t = triangles_[static_cast<std::size_t>(triangle)];
    std::size_t edge = kNoCorner;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector3& a = places_B_[static_cast<std::size_t>(t[k])];
        const Vector3 along = places_B_[static_cast<std::size_t>(t[(k + 1) % 3])] - a;
        const double least_square = kOnBorder * kOnBorder * along.squaredNorm();
        if ((at_B - a).squaredNorm() <= least_square) {
            return find_rise_m(rings_.of(place_of(triangle, k)), at_B, direction_B, epsilon);
        }
        if (square_from_line(at_B, a, along) <= least_square) {
            edge = k;
        }
    }
    return edge == kNoCorner
               ? 0.0
               : find_rise_m(wings_.of(edge_of(triangle, edge)), at_B, direction_B, epsilon);
}

// By the number of triangles between there and far away: odd inside. A line that meets an edge says nothing; the next one does.
bool GodSurface::encloses(const Vector3& at_B) const noexcept {
    constexpr double kFarReaches = 4.0;  // reaches
    const std::array<Vector3, 3> directions{Vector3(0.3183, 0.7071, 0.6313),
                                            Vector3(-0.8415, 0.1411, 0.5213),
                                            Vector3(0.1234, -0.9056, 0.4057)};
    if (!is_closed_ || at_B.norm() > swept_->reach_m()) {
        return false;
    }
    for (const Vector3& direction : directions) {
        const Vector3 far = at_B + kFarReaches * swept_->reach_m() * direction;
        int n_met = 0;
        bool is_sure = true;
        swept_->boxes().for_each_met(
            swept_->root(), to_centred(at_B, far), [&](std::int32_t triangle) {
                const Triangle t = swept_->triangle(triangle);
                const int from = orientation(t[0], t[1], t[2], at_B);
                const int to = orientation(t[0], t[1], t[2], far);
                const std::array<int, 3> round{orientation(at_B, far, t[0], t[1]),
                                               orientation(at_B, far, t[1], t[2]),
                                               orientation(at_B, far, t[2], t[0])};
                const auto [least, most] = std::ranges::minmax(round);
                if (from * to > 0 || (least < 0 && most > 0)) {
                    return;
                }
                is_sure = is_sure && from * to < 0 && least * most > 0;
                ++n_met;
            });
        if (is_sure) {
            return n_met % 2 == 1;
        }
    }
    return false;
}

std::size_t GodSurface::memory_bytes() const noexcept {
    const auto bytes_of = [](const Lists& lists) {
        return (lists.first.capacity() + lists.places.capacity()) * sizeof(std::int32_t);
    };
    return swept_->memory_bytes() + places_B_.capacity() * sizeof(Vector3) +
           (triangles_.capacity() + edges_of_.capacity()) * sizeof(TriangleCorners) +
           bytes_of(wings_) + bytes_of(rings_) + parts_.capacity() * sizeof(std::int32_t) +
           (corner_carries_.capacity() + edge_carries_.capacity()) / 8 + own_.capacity();
}

}  // namespace fulcrum
