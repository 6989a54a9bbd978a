#include "haptics/geometry/triangle_mesh.h"

#include "haptics/geometry/crack.h"
#include "haptics/geometry/weld.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace fulcrum {

namespace {

constexpr double kLargestWeld = 0.01;
constexpr std::size_t kMaxCount = 1U << 30U;  // vertices or triangles: their indices fit 32 bits

std::optional<Error> find_bad_input(const std::vector<Vector3>& vertices,
                                    const std::vector<TriangleCorners>& triangles,
                                    const MeshBuildSettings& settings, const std::string& where) {
    if (!(settings.weld_relative >= 0.0 && settings.weld_relative <= kLargestWeld)) {
        return Error{"the weld distance is not between 0 and 0.01 of the mesh's size", where,
                     "choose for example 1e-6"};
    }
    if (!(settings.crack_relative >= 0.0 && settings.crack_relative <= kLargestWeld)) {
        return Error{"the width of cracks to close is not between 0 and 0.01 of the mesh's size",
                     where, "choose for example 4e-4"};
    }
    if (vertices.size() > kMaxCount || triangles.size() > kMaxCount) {
        return Error{"the mesh has more than a thousand million triangles or vertices", where,
                     "export a coarser one"};
    }
    const auto bad = std::find_if(vertices.begin(), vertices.end(), [](const Vector3& v) {
        return !(v.cwiseAbs().maxCoeff() <= TriangleMesh::kLargestCoordinate_m) || !v.allFinite();
    });
    if (bad != vertices.end()) {
        return Error{"the coordinates of vertex " + std::to_string(bad - vertices.begin()) +
                         " are not finite numbers of metres",
                     where, "export the model again"};
    }
    const auto n_vertices = static_cast<std::int32_t>(vertices.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (const std::int32_t corner : triangles[i]) {
            if (corner < 0 || corner >= n_vertices) {
                return Error{"triangle " + std::to_string(i) + " names vertex " +
                                 std::to_string(corner) + " of " + std::to_string(n_vertices),
                             where, "export the model again"};
            }
        }
    }
    return std::nullopt;
}

bool is_degenerate(const Vector3& a, const Vector3& b, const Vector3& c) {
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    // Twice the area, by edges scaled to about 1 so that neither tiny nor huge meshes leave the
    // range of a double.
    const double doubled_area =
        longest > 0.0 ? ((b - a) / longest).cross((c - a) / longest).norm() : 0.0;
    return !(doubled_area > TriangleMesh::kThinnest);
}

void find_extents(const std::vector<Vector3>& vertices,
                  const std::vector<TriangleCorners>& triangles, Vector3& lower, Vector3& upper) {
    lower.setConstant(std::numeric_limits<double>::infinity());
    upper = -lower;
    for (const TriangleCorners& corners : triangles) {
        for (const std::int32_t corner : corners) {
            lower = lower.cwiseMin(vertices[static_cast<std::size_t>(corner)]);
            upper = upper.cwiseMax(vertices[static_cast<std::size_t>(corner)]);
        }
    }
}

// Points the triangles at the vertices that remain; the others stay in the list, unused.
void rename_corners(std::vector<TriangleCorners>& triangles,
                    const std::vector<std::int32_t>& becomes) {
    for (TriangleCorners& corners : triangles) {
        for (std::int32_t& corner : corners) {
            corner = becomes[static_cast<std::size_t>(corner)];
        }
    }
}

// Returns how many vertices left.
std::int64_t weld(const std::vector<Vector3>& vertices, std::vector<TriangleCorners>& triangles,
                  double tolerance_m) {
    const std::vector<std::int32_t> becomes = compute_welded_indices(vertices, tolerance_m);
    std::int64_t n_welded = 0;
    for (std::size_t i = 0; i < becomes.size(); ++i) {
        n_welded += becomes[i] != static_cast<std::int32_t>(i) ? 1 : 0;
    }
    rename_corners(triangles, becomes);
    return n_welded;
}

void mend_cracks(const std::vector<Vector3>& vertices, std::vector<TriangleCorners>& triangles,
                 double tolerance_m, MeshBuildCounts& counts) {
    const ClosedCracks closed = close_cracks(vertices, triangles, tolerance_m);
    if (!closed.becomes.empty()) {
        rename_corners(triangles, closed.becomes);
    }
    counts.welded_vertices += closed.welded_vertices;
    counts.closed_edges = closed.closed_edges;
    counts.closed_cracks = closed.cracks;
}

void drop_unused_vertices(std::vector<Vector3>& vertices, std::vector<TriangleCorners>& triangles) {
    std::vector<std::int32_t> renamed(vertices.size(), -1);
    for (const TriangleCorners& corners : triangles) {
        for (const std::int32_t corner : corners) {
            renamed[static_cast<std::size_t>(corner)] = 0;
        }
    }
    std::int32_t n_used = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (renamed[i] == 0) {
            renamed[i] = n_used;
            vertices[static_cast<std::size_t>(n_used++)] = vertices[i];
        }
    }
    vertices.resize(static_cast<std::size_t>(n_used));
    rename_corners(triangles, renamed);
}

}  // namespace

Expected<TriangleMesh> TriangleMesh::build(std::vector<Vector3> vertices_B,
                                           std::vector<TriangleCorners> triangles,
                                           const MeshBuildSettings& settings,
                                           const std::string& where) {
    if (std::optional<Error> bad = find_bad_input(vertices_B, triangles, settings, where)) {
        return tl::unexpected<Error>(std::move(*bad));
    }
    TriangleMesh mesh;
    find_extents(vertices_B, triangles, mesh.lower_B_, mesh.upper_B_);
    if (settings.weld_relative > 0.0 && !triangles.empty() && mesh.diagonal_m() > 0.0) {
        mesh.counts_.welded_vertices =
            weld(vertices_B, triangles, settings.weld_relative * mesh.diagonal_m());
    }
    // What has no area has no side to touch.
    const std::size_t n_before = triangles.size();
    std::erase_if(triangles, [&vertices_B](const TriangleCorners& t) {
        return is_degenerate(vertices_B[static_cast<std::size_t>(t[0])],
                             vertices_B[static_cast<std::size_t>(t[1])],
                             vertices_B[static_cast<std::size_t>(t[2])]);
    });
    mesh.counts_.degenerate_triangles = static_cast<std::int64_t>(n_before - triangles.size());
    if (triangles.empty()) {
        return fail("the mesh has no triangle with an area", where, "export the model again");
    }
    if (settings.weld_relative > 0.0 && settings.crack_relative > 0.0 && mesh.diagonal_m() > 0.0) {
        mend_cracks(vertices_B, triangles, settings.crack_relative * mesh.diagonal_m(),
                    mesh.counts_);
    }
    drop_unused_vertices(vertices_B, triangles);
    find_extents(vertices_B, triangles, mesh.lower_B_, mesh.upper_B_);
    if (!(mesh.diagonal_m() >= TriangleMesh::kSmallestDiagonal_m)) {
        return fail("the mesh is smaller than 1e-30 metres", where,
                    "export the model again, in metres");
    }
    mesh.vertices_B_ = std::move(vertices_B);
    mesh.triangles_ = std::move(triangles);
    return mesh;
}

}  // namespace fulcrum
