#include "haptics/geometry/mesh_report.h"

#include "haptics/geometry/mesh_edges.h"
#include "haptics/geometry/solid_moments.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <vector>

namespace fulcrum {

namespace {

void count_edges(const TriangleMesh& mesh, MeshReport& report) {
    const std::vector<MeshEdge> edges = collect_edges(mesh.triangles(), mesh.vertices_B().size());
    for_each_shared_edge(edges, [&report](std::span<const MeshEdge> shared) {
        const auto n_upwards = std::count_if(shared.begin(), shared.end(),
                                             [](const MeshEdge& edge) { return edge.upwards; });
        report.open_edges += shared.size() == 1 ? 1 : 0;
        report.non_manifold_edges += shared.size() > 2 ? 1 : 0;
        report.inconsistent_edges += shared.size() == 2 && n_upwards != 1 ? 1 : 0;
    });
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
    if (report.self_intersections > 0) {
        defects.push_back((report.more_self_intersections ? "at least " : "") +
                          counted(report.self_intersections, "place", "places") +
                          " where it passes through itself (both surfaces are felt)");
    } else if (report.more_self_intersections) {
        defects.emplace_back("triangles too crowded to tell whether it passes through itself");
    }
    if (report.inside_out) {
        defects.emplace_back("all its fronts looking inwards (touch is the same, light is not)");
    }
    if (report.closed_cracks > 0) {
        defects.push_back(counted(report.closed_cracks, "crack", "cracks") + ", now closed");
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
    report.closed_cracks = mesh.counts().closed_cracks;
    report.size_m = mesh.upper_B() - mesh.lower_B();
    count_edges(mesh, report);
    if (report.is_closed() && report.inconsistent_edges == 0) {
        const double signed_volume_m3 = compute_solid_moments(mesh).volume_m3;
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
