// A surface of triangles: vertices in metres in the body's frame, and three indices a triangle.
// Once built it is valid.
//
// Thread: load. Cost of a build: O(vertices + triangles).
#pragma once

#include "haptics/base/error.h"
#include "haptics/geometry/mesh_edges.h"
#include "haptics/math/spatial.h"

#include <cstdint>
#include <string>
#include <vector>

namespace fulcrum {

struct MeshBuildSettings {
    /// Vertices nearer than this times the mesh's diagonal become one; 0 leaves all as they are, cracks
    /// too. 0 to 0.01. The default closes what rounding to single precision opens.
    double weld_relative = 1.0e-6;
    /// Open edges that face each other nearer than this times the diagonal become one (crack.h). 0 to
    /// 0.01, 0 leaves cracks open.
    double crack_relative = 4.0e-4;
};

/// What a build changed.
struct MeshBuildCounts {
    std::int64_t welded_vertices = 0;       ///< vertices that became another
    std::int64_t degenerate_triangles = 0;  ///< triangles without area, dropped
    std::int64_t closed_cracks = 0;         ///< rows of open edges that became one
    std::int64_t closed_edges = 0;          ///< pairs of open edges in them
};

class TriangleMesh {
  public:
    /// Largest coordinate accepted, metres: products of nine of them still fit a double.
    static constexpr double kLargestCoordinate_m = 1.0e30;
    /// Smallest diagonal accepted, metres: products of nine lengths stay above a double's least.
    static constexpr double kSmallestDiagonal_m = 1.0e-30;
    /// A triangle thinner than this times its longest edge has no direction and is dropped.
    static constexpr double kThinnest = 1.0e-14;

    /// Checks and builds. Refuses coordinates that are not finite or too large, indices out of
    /// range, and a mesh of which no triangle remains or that is smaller than kSmallestDiagonal_m. `where` names the file in the error.
    [[nodiscard]] static Expected<TriangleMesh> build(std::vector<Vector3> vertices_B,
                                                      std::vector<TriangleCorners> triangles,
                                                      const MeshBuildSettings& settings = {},
                                                      const std::string& where = {});

    [[nodiscard]] const std::vector<Vector3>& vertices_B() const noexcept { return vertices_B_; }
    [[nodiscard]] const std::vector<TriangleCorners>& triangles() const noexcept {
        return triangles_;
    }
    [[nodiscard]] const MeshBuildCounts& counts() const noexcept { return counts_; }
    /// Least and greatest corner of the box around all triangles.
    [[nodiscard]] const Vector3& lower_B() const noexcept { return lower_B_; }
    [[nodiscard]] const Vector3& upper_B() const noexcept { return upper_B_; }
    /// Length of that box's diagonal: the mesh's measure of size. Above zero.
    [[nodiscard]] double diagonal_m() const noexcept { return (upper_B_ - lower_B_).norm(); }

  private:
    TriangleMesh() = default;

    std::vector<Vector3> vertices_B_;
    std::vector<TriangleCorners> triangles_;
    MeshBuildCounts counts_;
    Vector3 lower_B_{Vector3::Zero()};
    Vector3 upper_B_{Vector3::Zero()};
};

}  // namespace fulcrum
