#include "haptics/geometry/height_field.h"

#include "haptics/base/range.h"

#include <string>

namespace fulcrum {

namespace {

constexpr double kSmallest_m = 1.0e-12;
constexpr double kLargest_m = 1.0e12;
constexpr double kMostPoints = 4097.0;

}  // namespace

Expected<TriangleMesh> make_height_field(const HeightField& field) {
    const Range ranges[] = {
        {"width in metres", field.width_m, kSmallest_m, kLargest_m},
        {"depth in metres", field.depth_m, kSmallest_m, kLargest_m},
        {"number of points along x", static_cast<double>(field.n_x), 2.0, kMostPoints},
        {"number of points along z", static_cast<double>(field.n_z), 2.0, kMostPoints},
    };
    if (const auto good = check_ranges("the height field's", ranges); !good) {
        return tl::make_unexpected(good.error());
    }
    const auto n_x = static_cast<std::size_t>(field.n_x);
    const auto n_z = static_cast<std::size_t>(field.n_z);
    if (field.heights_m.size() != n_x * n_z) {
        return fail("the height field has " + std::to_string(field.heights_m.size()) +
                        " heights for " + std::to_string(n_x * n_z) + " points",
                    {}, "give it one for each");
    }
    std::vector<Vector3> vertices_B;
    std::vector<TriangleCorners> triangles;
    vertices_B.reserve(n_x * n_z);
    triangles.reserve(2 * (n_x - 1) * (n_z - 1));
    for (std::size_t z = 0; z < n_z; ++z) {
        for (std::size_t x = 0; x < n_x; ++x) {
            const double part_x = static_cast<double>(x) / static_cast<double>(n_x - 1);
            const double part_z = static_cast<double>(z) / static_cast<double>(n_z - 1);
            vertices_B.emplace_back((part_x - 0.5) * field.width_m, field.heights_m[z * n_x + x],
                                    (part_z - 0.5) * field.depth_m);
        }
    }
    for (std::size_t z = 0; z + 1 < n_z; ++z) {
        for (std::size_t x = 0; x + 1 < n_x; ++x) {
            const auto here = static_cast<std::int32_t>(z * n_x + x);
            const auto below = static_cast<std::int32_t>((z + 1) * n_x + x);
            triangles.push_back({here, below, here + 1});
            triangles.push_back({here + 1, below, below + 1});
        }
    }
    return TriangleMesh::build(std::move(vertices_B), std::move(triangles), {.weld_relative = 0.0});
}

}  // namespace fulcrum
