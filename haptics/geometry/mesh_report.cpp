#include "haptics/geometry/mesh_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace fulcrum {

namespace {

struct DirectedEdge {
    std::int32_t low = 0;
    std::int32_t high = 0;
    bool upwards = false;  // the triangle runs from low to high
};

std::vector<DirectedEdge> collect_edges(const TriangleMesh& mesh) {
    std::vector<DirectedEdge> edges;
    edges.reserve(3 * mesh.triangles().size());
    for (const TriangleCorners& corners : mesh.triangles()) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int32_t from = corners[i];
            const std::int32_t to = corners[(i + 1) % 3];
            edges.push_back({std::min(from, to), std::max(from, to), from < to});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const DirectedEdge& a, const DirectedEdge& b) {
        return std::pair(a.low, a.high) < std::pair(b.low, b.high);
    });
    return edges;
}

void count_edges(const std::vector<DirectedEdge>& edges, MeshReport& report) {
    for (std::size_t first = 0; first < edges.size();) {
        std::size_t end = first;
        std::int64_t n_upwards = 0;
        while (end < edges.size() && edges[end].low == edges[first].low &&
               edges[end].high == edges[first].high) {
            n_upwards += edges[end].upwards ? 1 : 0;
            ++end;
        }
        const std::size_t n_sharing = end - first;
        report.open_edges += n_sharing == 1 ? 1 : 0;
        report.non_manifold_edges += n_sharing > 2 ? 1 : 0;
        report.inconsistent_edges += n_sharing == 2 && n_upwards != 1 ? 1 : 0;
        first = end;
    }
}

// About the box's centre, so that a mesh far from its origin loses no digits.
double compute_signed_volume_m3(const TriangleMesh& mesh) {
    const Vector3 centre = 0.5 * (mesh.lower_B() + mesh.upper_B());
    double sextuple = 0.0;
    for (const TriangleCorners& t : mesh.triangles()) {
        const Vector3 a = mesh.vertices_B()[static_cast<std::size_t>(t[0])] - centre;
        const Vector3 b = mesh.vertices_B()[static_cast<std::size_t>(t[1])] - centre;
        const Vector3 c = mesh.vertices_B()[static_cast<std::size_t>(t[2])] - centre;
        sextuple += a.dot(b.cross(c));
    }
    return sextuple / 6.0;
}

std::string counted(std::int64_t n, const char* one, const char* many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
}

std::string join(const std::vector<std::string>& parts) {
    std::string joined;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        joined += i == 0 ? "" : (i + 1 == parts.size() ? " and " : ", ");
        joined += parts[i];
    }
    return joined;
}

std::vector<std::string> list_defects(const MeshReport& report) {
    std::vector<std::string> defects;
    if (report.open_edges > 0) {
        defects.push_back(counted(report.open_edges, "open edge", "open edges") +
                          " (holes or cracks, through which a point can slip)");
    }
    if (report.non_manifold_edges > 0) {
        defects.push_back(counted(report.non_manifold_edges, "edge", "edges") +
                          " shared by three or more triangles");
    }
    if (report.inconsistent_edges > 0) {
        defects.push_back(counted(report.inconsistent_edges, "edge", "edges") +
                          " where one neighbour is turned over (touch is the same, light is not)");
    }
    if (report.inside_out) {
        defects.emplace_back("all its fronts looking inwards (touch is the same, light is not)");
    }
    if (report.degenerate_triangles > 0) {
        defects.push_back(counted(report.degenerate_triangles, "triangle", "triangles") +
                          " without area, left out");
    }
    return defects;
}

}  // namespace

MeshReport compute_mesh_report(const TriangleMesh& mesh) {
    MeshReport report;
    report.n_triangles = static_cast<std::int64_t>(mesh.triangles().size());
    report.n_vertices = static_cast<std::int64_t>(mesh.vertices_B().size());
    report.degenerate_triangles = mesh.counts().degenerate_triangles;
    report.size_m = mesh.upper_B() - mesh.lower_B();
    count_edges(collect_edges(mesh), report);
    if (report.is_closed() && report.inconsistent_edges == 0) {
        const double signed_volume_m3 = compute_signed_volume_m3(mesh);
        report.inside_out = signed_volume_m3 < 0.0;
        report.volume_m3 = std::abs(signed_volume_m3);
    }
    return report;
}

std::string to_sentence(const MeshReport& report) {
    char size[96];
    std::snprintf(size, sizeof size, ", %.3g x %.3g x %.3g m, ", report.size_m.x(),
                  report.size_m.y(), report.size_m.z());
    const std::string what =
        "The mesh of " + counted(report.n_triangles, "triangle", "triangles") + size;
    return report.is_sound() ? what + "is closed and needs no mending."
                             : what + "has " + join(list_defects(report)) + ".";
}

}  // namespace fulcrum
