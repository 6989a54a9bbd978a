// What is measured on a mesh to tell how well something simpler stands for it: how far a point is from it, and how much of it a plane touches.
//
//   support area   of a corner with normal N: the sum of A_i n_i . N over the triangles that hang together with the corner, look its way, and
//                  have no corner x with N . (x - corner) < -d. It is the contact area, in the tangent plane, that a plane pressed by d has
//
// Thread: load. Cost: a distance 1 to 10 us, near the surface least; an area at most kMostTriangles.
// Source: M. Otaduy, M. Lin 2003, Sensation preserving simplification for haptic rendering, SIGGRAPH, section 4.5 (support area).
#pragma once

#include "haptics/collision/triangle_gap.h"
#include "haptics/levels/level_surface.h"

#include <memory>
#include <vector>

namespace fulcrum {

class SurfaceDistance {
  public:
    explicit SurfaceDistance(const TriangleMesh& mesh);

    /// From a point to the mesh's nearest, below 0 behind the nearest triangle. `guess_m`: about how far that is, above 0.
    [[nodiscard]] double measure_height_m(const Vector3& point, double guess_m) const noexcept;

  private:
    BoundingTree tree_;
    std::vector<TriangleForGap> triangles_;  // as the tree has them
    double farthest_m_ = 0.0;
};

class SupportArea {
  public:
    static constexpr int kMostTriangles = 256;

    /// Refers to the surface, which must not have changed since.
    SupportArea(const LevelSurface& surface, double within_m);
    [[nodiscard]] double measure_m2(std::int32_t corner);

  private:
    const LevelSurface& surface_;
    double within_m_;
    std::vector<std::int32_t> seen_;  // a triangle's stamp
    std::int32_t stamp_ = 0;
    std::vector<std::int32_t> found_;
};

}  // namespace fulcrum
