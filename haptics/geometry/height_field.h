// A ground: heights on a grid over a rectangle, joined by two triangles a cell.
//
// Thread: load. Cost: O(cells).
#pragma once

#include "haptics/geometry/triangle_mesh.h"

#include <vector>

namespace fulcrum {

struct HeightField {
    double width_m = 1.0;  ///< along x, about the body's origin; above 0
    double depth_m = 1.0;  ///< along z
    int n_x = 2;           ///< grid points along x, 2 to 4097
    int n_z = 2;           ///< and along z
    /// Heights y in metres, n_x of the first row z = -depth / 2, then those of the next; finite.
    std::vector<double> heights_m{0.0, 0.0, 0.0, 0.0};
};

/// Its surface, front upwards. Refuses sizes outside their ranges and another number of heights than n_x n_z.
[[nodiscard]] Expected<TriangleMesh> make_height_field(const HeightField& field);

}  // namespace fulcrum
