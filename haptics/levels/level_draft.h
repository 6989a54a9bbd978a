// A node of contact levels while they are made: its hull, whom it stands for, and how far these reach out.
//
// Thread: load. Cost: a hull of many corners by quickhull, a GJK a corner that is measured.
#pragma once

#include "haptics/levels/contact_levels.h"
#include "haptics/levels/level_surface.h"

#include <vector>

namespace fulcrum {

/// A node before it has its place.
struct LevelDraft {
    LevelNode node;
    std::vector<Vector3> points;
    std::vector<std::int32_t> first_link;  ///< of its own links
    std::vector<std::int32_t> links;
    std::vector<std::int32_t> children;
    std::int32_t piece = -1;   ///< of a leaf
    double deviation_m = 0.0;  ///< between its piece and the mesh

    /// The hull's corners alone; where they are many, with their neighbours.
    void take_points(const PieceShape& shape, double slack_m);
    /// The farthest of them in 64 directions, as a hull that only bounds.
    void take_outermost(const std::vector<Vector3>& points);
    /// Where a piece of the surface looks, by the mean and by the widest angle.
    void look(LevelSurface& surface, std::int32_t piece_now);
    void find_sphere();
    /// How far the farthest of the corners is out of the hull.
    [[nodiscard]] double measure_outside_m(const std::vector<Vector3>& corners) const;
};

}  // namespace fulcrum
