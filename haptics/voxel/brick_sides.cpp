#include "haptics/voxel/brick_sides.h"

#include "haptics/geometry/mesh_edges.h"
#include "haptics/voxel/winding_number.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fulcrum {

namespace {

// Distances are single precision; balls that only touch by rounding do not count.
constexpr float kOverlap = 1.001F;
constexpr double kDipoleError = 0.02;  // of compute_winding_number by default
// Beyond this many open edges it is quicker to ask each corner than to bound the slope.
constexpr std::size_t kMostOpenEdges = 2000;

double compute_distance_to_edge(const Vector3& p, const Vector3& from, const Vector3& to) noexcept {
    return std::sqrt(compute_square_distance(p, {from, to, to}));
}

Vector3 place_of(std::int16_t corner) noexcept {
    const int x = corner % kBrickSide;
    const int y = corner / kBrickSide % kBrickSide;
    const int z = corner / (kBrickSide * kBrickSide);
    return Vector3i(x, y, z).cast<double>();
}

}  // namespace

BrickSides::BrickSides(const TriangleMesh& mesh, const TriangleClusters& clusters, double voxel_m)
    : clusters_(clusters), voxel_m_(voxel_m) {
    const std::vector<MeshEdge> edges = collect_edges(mesh.triangles(), mesh.vertices_B().size());
    for_each_shared_edge(edges, [&](std::span<const MeshEdge> shared) {
        int balance = 0;
        for (const MeshEdge& edge : shared) {
            balance += edge.upwards ? 1 : -1;
        }
        const auto at = [&](std::int32_t i) {
            return mesh.vertices_B()[static_cast<std::size_t>(i)];
        };
        open_edges_.insert(open_edges_.end(), static_cast<std::size_t>(std::abs(balance)),
                           {at(shared[0].low), at(shared[0].high)});
    });
}

double BrickSides::bound_slope(const Vector3& corner_B) const noexcept {
    if (open_edges_.size() > kMostOpenEdges) {
        return std::numeric_limits<double>::infinity();
    }
    const double half_edge_m = 0.5 * kBrickCells * voxel_m_;
    const Vector3 middle_B = corner_B + Vector3::Constant(half_edge_m);
    double slope = 0.0;
    for (const OpenEdge& edge : open_edges_) {
        const double near_m = compute_distance_to_edge(middle_B, edge.from_B, edge.to_B) -
                              std::numbers::sqrt3 * half_edge_m;
        if (near_m <= 0.0) {
            return std::numeric_limits<double>::infinity();
        }
        slope += (edge.to_B - edge.from_B).norm() / (4.0 * std::numbers::pi * near_m * near_m);
    }
    return slope;
}

std::size_t BrickSides::collect_part(std::size_t first, const BrickDistances& distances,
                                     Search& search) noexcept {
    constexpr std::array<int, 3> kStride{1, kBrickSide, kBrickSide * kBrickSide};
    std::size_t n = 0;
    search.queue[n++] = static_cast<std::int16_t>(first);
    search.steps[first] = 0;
    for (std::size_t done = 0; done < n; ++done) {
        const int corner = search.queue[done];
        const auto step =
            static_cast<std::int16_t>(search.steps[static_cast<std::size_t>(corner)] + 1);
        const float near = kOverlap - distances[static_cast<std::size_t>(corner)];
        for (const int stride : kStride) {
            const int at = corner / stride % kBrickSide;
            for (const int way : {-1, 1}) {
                if (at + way < 0 || at + way >= kBrickSide) {
                    continue;
                }
                const int neighbour = corner + way * stride;
                const auto other = static_cast<std::size_t>(neighbour);
                if (search.steps[other] < 0 && distances[other] > near) {
                    search.steps[other] = step;
                    search.queue[n++] = static_cast<std::int16_t>(other);
                }
            }
        }
    }
    return n;
}

double BrickSides::count_terms(const Vector3& middle_B, std::size_t n_triangles) const noexcept {
    const double n_asked = open_edges_.size() > kMostOpenEdges
                               ? static_cast<double>(kBrickCorners)
                               : static_cast<double>(std::min(kBrickCorners, 1 + n_triangles));
    return n_asked * count_winding_terms(clusters_, middle_B);
}

bool BrickSides::put_sign(std::span<const std::int16_t> part, std::int16_t n_steps, double slope,
                          const Vector3& corner_B, BrickDistances& distances,
                          WorkWatch* watch) const noexcept {
    const double w =
        std::abs(compute_winding_number(clusters_, corner_B + voxel_m_ * place_of(part.front())));
    const double change = n_steps == 0 ? 0.0 : slope * n_steps * voxel_m_;
    const bool is_one_side = std::abs(w - 0.5) > change + kDipoleError || n_steps == 0;
    for (const std::int16_t corner : part) {
        if (!is_one_side && watch != nullptr && !watch->goes_on()) {
            return false;
        }
        const bool inside = is_one_side
                                ? w >= 0.5
                                : is_wound_round(clusters_, corner_B + voxel_m_ * place_of(corner));
        float& distance = distances[static_cast<std::size_t>(corner)];
        distance = inside ? -distance : distance;
    }
    return watch == nullptr || watch->goes_on();
}

void BrickSides::put_signs(const Vector3& corner_B, BrickDistances& distances,
                           WorkWatch* watch) const noexcept {
    const double slope = bound_slope(corner_B);
    const BrickDistances unsigned_distances = distances;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): the queue is filled as it grows
    Search search;
    search.steps.fill(-1);
    for (std::size_t first = 0; first < kBrickCorners; ++first) {
        if (search.steps[first] < 0) {
            const std::size_t n = collect_part(first, unsigned_distances, search);
            const auto last = static_cast<std::size_t>(search.queue[n - 1]);
            if (!put_sign({search.queue.data(), n}, search.steps[last], slope, corner_B, distances,
                          watch)) {
                return;
            }
        }
    }
}

}  // namespace fulcrum
