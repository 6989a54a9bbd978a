// When two meshes first touch, one held and one on its in-between way.
//
// Both are trees of oriented boxes (obb_tree.h). A pair of nodes over a piece of time T, of middle m and half length h, is free when one of fifteen
// directions keeps the boxes apart all the time: along L, |L| <= 1, with x the moving box's middle at m, v its velocity, t and t' the half sizes,
//   |L . (x - c)| > sum t_i |L . a_i| + sum t'_j |L . b_j| + |L . v| h + (w h)^2 |x - pivot| / 2 + w h |t'| + touch
// The third term is the way of the box's middle, the fourth what that way bends, the fifth how far the box's own points turn: so the test
// holds for all of T, by Taylor's theorem. Boxes' axes are single numbers; what they are off a right frame, and rounding, is added.
// What is not free is halved: the piece of time where the motion is larger than the boxes, else the larger box. Leaves' triangles are swept
// over T (triangle_sweep.h). The earlier half of a piece comes first, and what begins after the earliest contact so far is dropped;
// so the answer is the earliest of all pairs' contacts, and its promises are theirs (sweep.h). Same question, same answer, to the last bit.
//
// Cracks and loose triangles are surfaces like others. What lies wholly inside a mesh touches none of its triangles: that is not told.
//
// Thread: any; no allocation. Cost: 10 us to 1 ms, by how much lies near.
// Source: S. Redon, A. Kheddar, S. Coquillart 2002 (in_between_motion.h): oriented boxes over intervals of time; the fifteen directions:
// S. Gottschalk, M. C. Lin, D. Manocha 1996 (obb_tree.h).
#pragma once

#include "haptics/base/bounded_list.h"
#include "haptics/continuous/sweep.h"
#include "haptics/continuous/swept_mesh.h"

namespace fulcrum {

struct MeshSweep {
    SweepOutcome outcome = SweepOutcome::free;
    SweepContact contact{};
    std::int32_t fixed_triangle = -1;
    std::int32_t moving_triangle = -1;
    /// Work done, for those who count: pairs of boxes, and of triangles.
    std::int64_t n_box_pairs = 0;
    std::int64_t n_triangle_pairs = 0;
};

/// The first contact of the whole way.
[[nodiscard]] MeshSweep sweep_meshes(const SweptMesh& fixed, const SweptMesh& moving,
                                     const InBetweenMotion& motion,
                                     const SweepSettings& settings) noexcept;

/// Two triangles that are near each other at one time.
struct NearTriangles {
    std::int32_t fixed_triangle = -1;
    std::int32_t moving_triangle = -1;
    NearFeatures features{};
};

/// All pairs of triangles within `within_m` of each other at the time t of the way, until the list is full (then false, as for a motion that is
/// none). Those at a contact's time, with a few tolerances, are what holds the moving mesh there.
bool collect_near(const SweptMesh& fixed, const SweptMesh& moving, const InBetweenMotion& motion,
                  double t, double within_m, BoundedList<NearTriangles>& near) noexcept;

}  // namespace fulcrum
