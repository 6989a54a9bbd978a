#include "haptics/geometry/weld.h"

#include "haptics/geometry/near_points.h"

namespace fulcrum {

std::vector<std::int32_t> compute_welded_indices(std::span<const Vector3> vertices,
                                                 double tolerance_m) {
    std::vector<std::int32_t> becomes(vertices.size());
    NearPoints kept(vertices, tolerance_m);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto self = static_cast<std::int32_t>(i);
        // Of the kept ones within the tolerance that of least index, all of which are below `self`.
        std::int32_t same = self;
        kept.for_each_near(vertices[i],
                           [&same](std::int32_t other) { same = other < same ? other : same; });
        becomes[i] = same;
        if (same == self) {
            kept.add(self);
        }
    }
    return becomes;
}

}  // namespace fulcrum
