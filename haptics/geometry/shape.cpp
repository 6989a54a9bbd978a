#include "haptics/geometry/shape.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

namespace fulcrum {

namespace {

constexpr double kLargestSize_m = 1.0e15;
constexpr double kSmallestSize_m = 1.0e-15;
constexpr int kMaxRows = 4096;
constexpr int kMaxFrequency = 512;
const MeshBuildSettings kNoWeld{.weld_relative = 0.0};
const MeshBuildSettings kSeparate{.weld_relative = 0.0, .crack_relative = 0.0};

bool is_size(double size_m) {
    return size_m >= kSmallestSize_m && size_m <= kLargestSize_m;
}
bool is_count(int n, int least, int most) {
    return n >= least && n <= most;
}

tl::unexpected<Error> refuse(const std::string& shape) {
    return fail("the measures of the " + shape + " are out of range", {},
                "give sizes in metres above zero and counts as documented");
}

// Two triangles a cell of a grid of points; seen from the front the four corners run
// counter-clockwise.
void add_quad(std::vector<TriangleCorners>& triangles, std::int32_t a, std::int32_t b,
              std::int32_t c, std::int32_t d) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
}

void add_ring(std::vector<Vector3>& vertices, double radius_m, double y_m, int n_round) {
    for (int column = 0; column < n_round; ++column) {
        const double turn = 2.0 * std::numbers::pi * column / n_round;
        vertices.emplace_back(radius_m * std::sin(turn), y_m, radius_m * std::cos(turn));
    }
}

// Between an upper and a lower pole, the first and the last vertex, rings of n_round each from above.
Expected<TriangleMesh> build_rings(std::vector<Vector3> vertices, int n_round) {
    std::vector<TriangleCorners> triangles;
    const auto south = static_cast<std::int32_t>(vertices.size()) - 1;
    const std::int32_t last = south - n_round;
    for (int column = 0; column < n_round; ++column) {
        const int next = (column + 1) % n_round;
        triangles.push_back({0, 1 + column, 1 + next});
        for (std::int32_t upper = 1; upper < last; upper += n_round) {
            const std::int32_t lower = upper + n_round;
            add_quad(triangles, upper + column, lower + column, lower + next, upper + next);
        }
        triangles.push_back({last + next, last + column, south});
    }
    return TriangleMesh::build(std::move(vertices), std::move(triangles), kNoWeld);
}

struct Icosahedron {
    std::array<Vector3, 12> corners;
    std::array<TriangleCorners, 20> faces{};
};

Icosahedron make_icosahedron() {
    const double g = std::numbers::phi;
    return {{Vector3(-1, g, 0), Vector3(1, g, 0), Vector3(-1, -g, 0), Vector3(1, -g, 0),
             Vector3(0, -1, g), Vector3(0, 1, g), Vector3(0, -1, -g), Vector3(0, 1, -g),
             Vector3(g, 0, -1), Vector3(g, 0, 1), Vector3(-g, 0, -1), Vector3(-g, 0, 1)},
            {{{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
              {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
              {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}}};
}

// Each face has points of its own; the weld joins them along the faces' edges, where they differ by
// rounding.
void divide_face(const std::array<Vector3, 3>& corners, int frequency,
                 std::vector<Vector3>& directions, std::vector<TriangleCorners>& triangles) {
    const auto first = static_cast<std::int32_t>(directions.size());
    // Row i has i + 1 points and starts after 1 + 2 + ... + i of them.
    const auto at = [first](int row, int column) { return first + row * (row + 1) / 2 + column; };
    for (int row = 0; row <= frequency; ++row) {
        for (int column = 0; column <= row; ++column) {
            const Vector3 point =
                (frequency - row) * corners[0] + (row - column) * corners[1] + column * corners[2];
            directions.push_back(point.normalized());
            if (row > 0 && column < row) {
                triangles.push_back({at(row - 1, column), at(row, column), at(row, column + 1)});
            }
            if (row > 1 && column > 0 && column < row) {
                triangles.push_back(
                    {at(row - 1, column - 1), at(row, column), at(row - 1, column)});
            }
        }
    }
}

Expected<TriangleMesh> make_star_shaped(int frequency,
                                        const std::function<double(const Vector3&)>& radius_m) {
    const Icosahedron base = make_icosahedron();
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    for (const TriangleCorners& face : base.faces) {
        divide_face({base.corners[static_cast<std::size_t>(face[0])],
                     base.corners[static_cast<std::size_t>(face[1])],
                     base.corners[static_cast<std::size_t>(face[2])]},
                    frequency, vertices, triangles);
    }
    for (Vector3& vertex : vertices) {
        vertex *= radius_m(vertex);
    }
    // Far below the shortest edge (about 1e-3 of the size at the highest frequency), far above
    // rounding.
    return TriangleMesh::build(std::move(vertices), std::move(triangles),
                               {.weld_relative = 1.0e-9});
}

}  // namespace

Expected<TriangleMesh> make_box(const Vector3& size_m) {
    const PlacedBox box{Vector3::Zero(), size_m};
    return make_boxes({&box, 1});
}

Expected<TriangleMesh> make_boxes(std::span<const PlacedBox> boxes) {
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    for (const PlacedBox& box : boxes) {
        if (!is_size(box.size_m.x()) || !is_size(box.size_m.y()) || !is_size(box.size_m.z())) {
            return refuse("box");
        }
        const auto first = static_cast<std::int32_t>(vertices.size());
        for (unsigned corner = 0; corner < 8; ++corner) {
            const Vector3 side((corner & 1U) != 0 ? 0.5 : -0.5, (corner & 2U) != 0 ? 0.5 : -0.5,
                               (corner & 4U) != 0 ? 0.5 : -0.5);
            vertices.emplace_back(box.at_B + side.cwiseProduct(box.size_m));
        }
        add_quad(triangles, first + 0, first + 4, first + 6, first + 2);
        add_quad(triangles, first + 1, first + 3, first + 7, first + 5);
        add_quad(triangles, first + 0, first + 1, first + 5, first + 4);
        add_quad(triangles, first + 2, first + 6, first + 7, first + 3);
        add_quad(triangles, first + 0, first + 2, first + 3, first + 1);
        add_quad(triangles, first + 4, first + 5, first + 7, first + 6);
    }
    return TriangleMesh::build(std::move(vertices), std::move(triangles), kSeparate);
}

Expected<TriangleMesh> make_plate(double width_m, double depth_m, int n) {
    if (!is_size(width_m) || !is_size(depth_m) || !is_count(n, 1, kMaxRows)) {
        return refuse("plate");
    }
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    for (int row = 0; row <= n; ++row) {
        for (int column = 0; column <= n; ++column) {
            vertices.emplace_back(width_m * (static_cast<double>(column) / n - 0.5), 0.0,
                                  depth_m * (static_cast<double>(row) / n - 0.5));
            if (row > 0 && column > 0) {
                const std::int32_t last = row * (n + 1) + column;
                add_quad(triangles, last - n - 2, last - 1, last, last - n - 1);
            }
        }
    }
    return TriangleMesh::build(std::move(vertices), std::move(triangles), kNoWeld);
}

Expected<TriangleMesh> make_sphere(double radius_m, int frequency) {
    if (!is_size(radius_m) || !is_count(frequency, 1, kMaxFrequency)) {
        return refuse("sphere");
    }
    return make_star_shaped(frequency, [radius_m](const Vector3&) { return radius_m; });
}

Expected<TriangleMesh> make_globe(double radius_m, int n_round, int n_across) {
    if (!is_size(radius_m) || !is_count(n_round, 3, kMaxRows) || !is_count(n_across, 2, kMaxRows)) {
        return refuse("globe");
    }
    std::vector<Vector3> vertices{Vector3(0.0, radius_m, 0.0)};
    for (int row = 1; row < n_across; ++row) {
        const double polar = std::numbers::pi * row / n_across;
        for (int column = 0; column < n_round; ++column) {
            const double turn = 2.0 * std::numbers::pi * column / n_round;
            vertices.emplace_back(radius_m * Vector3(std::sin(polar) * std::sin(turn),
                                                     std::cos(polar),
                                                     std::sin(polar) * std::cos(turn)));
        }
    }
    vertices.emplace_back(0.0, -radius_m, 0.0);
    return build_rings(std::move(vertices), n_round);
}

Expected<TriangleMesh> make_cylinder(double radius_m, double height_m, int n_round) {
    if (!is_size(radius_m) || !is_size(height_m) || !is_count(n_round, 3, kMaxRows)) {
        return refuse("cylinder");
    }
    std::vector<Vector3> vertices{Vector3(0.0, 0.5 * height_m, 0.0)};
    add_ring(vertices, radius_m, 0.5 * height_m, n_round);
    add_ring(vertices, radius_m, -0.5 * height_m, n_round);
    vertices.emplace_back(0.0, -0.5 * height_m, 0.0);
    return build_rings(std::move(vertices), n_round);
}

Expected<TriangleMesh> make_capsule(double radius_m, double straight_m, int n_round, int n_across) {
    if (!is_size(radius_m) || !is_size(straight_m) || !is_count(n_round, 3, kMaxRows) ||
        !is_count(n_across, 1, kMaxRows / 2)) {
        return refuse("capsule");
    }
    std::vector<Vector3> vertices{Vector3(0.0, 0.5 * straight_m + radius_m, 0.0)};
    for (const double side : {1.0, -1.0}) {
        for (int i = 1; i <= n_across; ++i) {
            // From the pole to the equator above, and back below.
            const int row = side > 0.0 ? i : n_across + 1 - i;
            const double polar = 0.5 * std::numbers::pi * row / n_across;
            add_ring(vertices, radius_m * std::sin(polar),
                     side * (0.5 * straight_m + radius_m * std::cos(polar)), n_round);
        }
    }
    vertices.emplace_back(0.0, -0.5 * straight_m - radius_m, 0.0);
    return build_rings(std::move(vertices), n_round);
}

Expected<TriangleMesh> make_bumpy_sphere(double radius_m, int frequency, double height,
                                         double bumps) {
    if (!is_size(radius_m) || !is_count(frequency, 1, kMaxFrequency) ||
        !(height >= 0.0 && height <= 0.5) || !(bumps >= 0.0 && bumps <= 1000.0)) {
        return refuse("bumpy sphere");
    }
    return make_star_shaped(frequency, [=](const Vector3& u) {
        const double wave =
            std::sin(bumps * u.x()) + std::sin(bumps * u.y()) + std::sin(bumps * u.z());
        return radius_m * (1.0 + height * wave / 3.0);
    });
}

Expected<TriangleMesh> make_torus(double ring_radius_m, double tube_radius_m, int n_ring,
                                  int n_tube) {
    if (!is_size(ring_radius_m) || !is_size(tube_radius_m) || !(ring_radius_m > tube_radius_m) ||
        !is_count(n_ring, 3, kMaxRows) || !is_count(n_tube, 3, kMaxRows)) {
        return refuse("torus");
    }
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    for (int ring = 0; ring < n_ring; ++ring) {
        const double turn = 2.0 * std::numbers::pi * ring / n_ring;
        const Vector3 outwards(std::sin(turn), 0.0, std::cos(turn));
        for (int tube = 0; tube < n_tube; ++tube) {
            const double tilt = 2.0 * std::numbers::pi * tube / n_tube;
            vertices.emplace_back(outwards * (ring_radius_m + tube_radius_m * std::cos(tilt)) +
                                  Vector3::UnitY() * (tube_radius_m * std::sin(tilt)));
            const int ring_after = (ring + 1) % n_ring * n_tube;
            const int tube_after = (tube + 1) % n_tube;
            add_quad(triangles, ring * n_tube + tube, ring_after + tube, ring_after + tube_after,
                     ring * n_tube + tube_after);
        }
    }
    return TriangleMesh::build(std::move(vertices), std::move(triangles), kNoWeld);
}

Expected<TriangleMesh> make_cup(double rim_m, double foot_m, double depth_m, double wall_m,
                                int n_round) {
    if (!is_size(rim_m) || !is_size(foot_m) || !is_size(depth_m) || !is_size(wall_m) ||
        !is_count(n_round, 3, kMaxRows)) {
        return refuse("cup");
    }
    const double corner = 1.0 / std::cos(std::numbers::pi / n_round);
    // From the floor's middle up the inside, over the rim and down the outside.
    std::vector<Vector3> vertices{Vector3(0.0, -depth_m, 0.0)};
    add_ring(vertices, corner * foot_m, -depth_m, n_round);
    add_ring(vertices, corner * rim_m, 0.0, n_round);
    add_ring(vertices, corner * (rim_m + wall_m), 0.0, n_round);
    add_ring(vertices, corner * (foot_m + wall_m), -depth_m - wall_m, n_round);
    vertices.emplace_back(0.0, -depth_m - wall_m, 0.0);
    return build_rings(std::move(vertices), n_round);
}

Expected<TriangleMesh> make_inverted(const TriangleMesh& mesh) {
    std::vector<TriangleCorners> triangles = mesh.triangles();
    for (TriangleCorners& corners : triangles) {
        std::swap(corners[1], corners[2]);
    }
    return TriangleMesh::build(mesh.vertices_B(), std::move(triangles), kNoWeld);
}

}  // namespace fulcrum
