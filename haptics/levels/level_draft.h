// A node of contact levels while they are made: its hull, whom it stands for, and how far these reach out.
//
// Thread: load. Cost: a hull by quickhull, a GJK a corner that is measured.
#pragma once

#include "haptics/levels/level_node.h"
#include "haptics/levels/level_surface.h"
#include "haptics/levels/surface_measures.h"

#include <span>
#include <vector>

namespace fulcrum {

/// A node before it has its place.
struct LevelDraft {
    LevelNode node;
    std::vector<Vector3> points;  ///< of a node above others the hull's only once it is bound
    std::vector<std::int32_t> first_link;  ///< of its own links
    std::vector<std::int32_t> links;
    std::vector<std::int32_t> children;
    std::vector<PieceTriangle> faces;  ///< of a hull that was taken, until it is measured
    std::int32_t piece = -1;           ///< of a leaf
    double area_m2 = 0.0;              ///< of the mesh below

    /// The hull's corners alone; where they are many, with their neighbours.
    void take_points(const PieceShape& shape, double slack_m);
    /// The hull of hulls; where these all lie in a plane, which its normal tells, a flat one.
    void take_hull(const std::vector<Vector3>& corners);
    /// Where a piece of the surface looks, by the mean and by the widest angle.
    void look(LevelSurface& surface, std::int32_t piece_now);
    /// Where what is below looks: the mean of means, and how far the farthest of theirs is from it.
    void look_as(std::span<const LevelDraft* const> below);
    void find_sphere();
    /// How far the faces stand out of a surface, in front of it, as measured at 3 to 12 samples each: on a grid of its longest side by `apart_m` parts,
    /// 2 to 4 of them. Less than it is by no more than samples are apart. Ends where it is above `enough_m`.
    [[nodiscard]] double measure_bulge_m(const SurfaceDistance& surface, double apart_m,
                                         double enough_m) const;
    /// How far the farthest of the corners is out of the hull.
    [[nodiscard]] double measure_outside_m(const std::vector<Vector3>& corners) const;
};

}  // namespace fulcrum
