#include "haptics/voxel/brick_triangles.h"

#include "haptics/voxel/distance_band.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

constexpr double kHalfDiagonal = 0.5 * std::numbers::sqrt3 * kBrickCells;  // of a brick, voxels

struct Bricks {
    std::array<std::int32_t, 3> n{};

    [[nodiscard]] std::size_t n_all() const noexcept {
        return static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]) *
               static_cast<std::size_t>(n[2]);
    }

    // Calls visit(index) for each that may have a corner within reach of the triangle.
    template <class Visit>
    void for_each_near(const TriangleAt& t, double reach, Visit&& visit) const {
        const Vector3 lower = t.a.cwiseMin(t.b).cwiseMin(t.c) - Vector3::Constant(reach);
        const Vector3 upper = t.a.cwiseMax(t.b).cwiseMax(t.c) + Vector3::Constant(reach);
        std::array<std::int32_t, 3> first{};
        std::array<std::int32_t, 3> last{};
        for (int axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<std::size_t>(axis);
            first[i] =
                std::clamp(static_cast<int>(std::ceil(lower[axis] / kBrickCells)) - 1, 0, n[i] - 1);
            last[i] = std::clamp(static_cast<int>(upper[axis] / kBrickCells), 0, n[i] - 1);
        }
        const double to_centre = reach + kHalfDiagonal;
        for (std::int32_t z = first[2]; z <= last[2]; ++z) {
            for (std::int32_t y = first[1]; y <= last[1]; ++y) {
                for (std::int32_t x = first[0]; x <= last[0]; ++x) {
                    const Vector3 centre =
                        kBrickCells * (Vector3i(x, y, z).cast<double>() + Vector3::Constant(0.5));
                    if (compute_square_distance(centre, t) <= to_centre * to_centre) {
                        visit(x + n[0] * (y + n[1] * z));
                    }
                }
            }
        }
    }
};

struct Pair {
    std::int32_t brick;
    std::int32_t triangle;
};

// Put in order by bricks; `count` has how many the brick before each has.
void sort_pairs(const std::vector<Pair>& pairs, std::vector<std::size_t>& count,
                BrickTriangles& list) {
    for (std::size_t i = 0; i + 1 < count.size(); ++i) {
        if (count[i + 1] > 0) {
            list.bricks.push_back(static_cast<std::int32_t>(i));
            list.first.push_back(count[i]);
        }
        count[i + 1] += count[i];
    }
    list.first.push_back(pairs.size());
    list.triangles.resize(pairs.size());
    for (const Pair& pair : pairs) {
        list.triangles[count[static_cast<std::size_t>(pair.brick)]++] = pair.triangle;
    }
}

}  // namespace

TriangleAt find_lattice_triangle(const TriangleMesh& mesh, const VoxelFrame& frame,
                                 std::size_t index) {
    const TriangleCorners& corners = mesh.triangles()[index];
    const auto at = [&](std::size_t i) {
        return frame.to_lattice(mesh.vertices_B()[static_cast<std::size_t>(corners[i])]);
    };
    return {at(0), at(1), at(2)};
}

std::optional<BrickTriangles> list_brick_triangles(const TriangleMesh& mesh,
                                                   const VoxelFrame& frame, double reach_voxels,
                                                   double most, const LoadProgress& progress) {
    const Bricks block{{frame.n_cells[0] / kBrickCells, frame.n_cells[1] / kBrickCells,
                        frame.n_cells[2] / kBrickCells}};
    BrickTriangles list;
    std::vector<Pair> pairs;
    std::vector<std::size_t> count(block.n_all() + 1, 0);
    const auto n = static_cast<double>(mesh.triangles().size());
    LoadPulse pulse(progress);
    if (!pulse.goes_on_now(0.0)) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
        const double share = static_cast<double>(i) / n;
        if (!pulse.goes_on(share)) {
            return std::nullopt;
        }
        if (list.n_pairs > most) {
            list.n_pairs /= share;
            return list;
        }
        block.for_each_near(find_lattice_triangle(mesh, frame, i), reach_voxels,
                            [&](std::int32_t brick) {
                                pairs.push_back({brick, static_cast<std::int32_t>(i)});
                                ++count[static_cast<std::size_t>(brick) + 1];
                            });
        list.n_pairs = static_cast<double>(pairs.size());
    }
    sort_pairs(pairs, count, list);
    return list;
}

}  // namespace fulcrum
