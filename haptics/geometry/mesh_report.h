// What is right or wrong with a mesh, and that in one sentence a teacher can use.
//
// An edge is open when one triangle has it, non-manifold when three or more have it, and wound
// inconsistently when two triangles run along it in the same direction. A closed, consistent mesh
// is inside out when its signed volume (solid_moments.h) is negative.
//
// Thread: load. Cost: O(n) in triangles.
#pragma once

#include "haptics/geometry/triangle_mesh.h"

#include <cstdint>
#include <string>

namespace fulcrum {

struct MeshReport {
    std::int64_t n_triangles = 0;
    std::int64_t n_vertices = 0;
    std::int64_t open_edges = 0;
    std::int64_t non_manifold_edges = 0;
    std::int64_t inconsistent_edges = 0;    ///< neighbours of which one is inverted
    std::int64_t degenerate_triangles = 0;  ///< dropped when the mesh was built
    std::int64_t closed_cracks = 0;         ///< closed when the mesh was built (crack.h)
    /// Pairs of triangles that pass through each other, as found by self_intersection.h; 0 before it is asked.
    std::int64_t self_intersections = 0;
    bool more_self_intersections = false;  ///< there may be more: it did not look on
    bool inside_out = false;               ///< closed and consistent, but all fronts look inwards
    Vector3 size_m{Vector3::Zero()};       ///< of the box around the mesh
    double volume_m3 = 0.0;                ///< enclosed, positive; 0 unless closed and consistent

    /// No open and no non-manifold edge: a point cannot slip in.
    [[nodiscard]] bool is_closed() const noexcept {
        return open_edges == 0 && non_manifold_edges == 0;
    }
    /// Closed, all fronts outwards, and nothing was left out: there is nothing to tell.
    [[nodiscard]] bool is_sound() const noexcept {
        return is_closed() && inconsistent_edges == 0 && !inside_out && degenerate_triangles == 0 &&
               closed_cracks == 0 && self_intersections == 0 && !more_self_intersections;
    }
};

[[nodiscard]] MeshReport compute_mesh_report(const TriangleMesh& mesh);

/// One sentence: how large the mesh is, what is wrong with it, and what that means for the touch.
[[nodiscard]] std::string to_sentence(const MeshReport& report);

}  // namespace fulcrum
