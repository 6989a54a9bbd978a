#include "haptics/continuous/mesh_sweep.h"

#include "haptics/continuous/mesh_descent.h"
#include "haptics/continuous/triangle_sweep.h"

#include <algorithm>

namespace fulcrum {
namespace {

// The triangles of two leaves over a piece of time; what is found goes into `found` where it is earlier.
void sweep_leaves(const SweptMesh& fixed, const SweptMesh& moving, const InBetweenMotion& motion,
                  const SweepSettings& settings, const SweptNodes& leaves,
                  MeshSweep& found) noexcept {
    for (const std::int32_t i : fixed.boxes().triangles_of(leaves.fixed)) {
        for (const std::int32_t j : moving.boxes().triangles_of(leaves.moving)) {
            ++found.n_triangle_pairs;
            const TriangleSweep told = sweep_triangles(
                motion, fixed.triangle(i), MovingTriangle::of(motion, moving.triangle(j)), settings,
                leaves.begin, leaves.end);
            // Of what touches at the beginning and what crosses there the latter is told.
            const bool is_first = found.outcome == SweepOutcome::free ||
                                  told.contact.time < found.contact.time ||
                                  (told.outcome == SweepOutcome::overlapping &&
                                   found.outcome == SweepOutcome::touching &&
                                   !(told.contact.time > found.contact.time));
            if (told.outcome != SweepOutcome::free && is_first) {
                found.outcome = told.outcome;
                found.contact = told.contact;
                found.fixed_triangle = i;
                found.moving_triangle = j;
            }
        }
    }
}

}  // namespace

MeshSweep sweep_meshes(const SweptMesh& fixed, const SweptMesh& moving,
                       const InBetweenMotion& motion, const SweepSettings& settings) noexcept {
    MeshSweep found;
    if (!motion.is_valid() || !is_valid(settings)) {
        found.outcome = SweepOutcome::invalid;
        return found;
    }
    MeshDescent descent(fixed, moving, motion, settings.touch_m);
    const bool is_whole = descent.walk(0.0, 1.0, [&](const SweptNodes& leaves, double end) {
        sweep_leaves(fixed, moving, motion, settings, leaves, found);
        if (found.outcome == SweepOutcome::free) {
            return end;
        }
        // Nothing comes before an overlap; beside what touches at the beginning others may cross.
        return found.outcome == SweepOutcome::touching ? std::min(end, found.contact.time) : -1.0;
    });
    found.n_box_pairs = descent.n_box_pairs();
    if (!is_whole) {
        found.outcome = SweepOutcome::invalid;
    }
    return found;
}

bool collect_near(const SweptMesh& fixed, const SweptMesh& moving, const InBetweenMotion& motion,
                  double t, double within_m, BoundedList<NearTriangles>& near) noexcept {
    near.clear();
    if (!motion.is_valid() || !(t >= 0.0 && t <= 1.0) || !(within_m >= 0.0)) {
        return false;
    }
    const SineCosine turn = motion.turn_at(t);
    bool has_room = true;
    MeshDescent descent(fixed, moving, motion, within_m);
    const bool is_whole = descent.walk(t, t, [&](const SweptNodes& leaves, double end) {
        for (const std::int32_t i : fixed.boxes().triangles_of(leaves.fixed)) {
            for (const std::int32_t j : moving.boxes().triangles_of(leaves.moving)) {
                const MovingTriangle triangle = MovingTriangle::of(motion, moving.triangle(j));
                const NearFeatures features =
                    find_nearest_features(fixed.triangle(i), triangle.find_place(motion, t, turn));
                if (features.distance_m <= within_m) {
                    has_room = near.add({i, j, features}) && has_room;
                }
            }
        }
        return has_room ? end : -1.0;
    });
    return has_room && is_whole;
}

}  // namespace fulcrum
