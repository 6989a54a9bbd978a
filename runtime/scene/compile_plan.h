// Compiles a lesson's description into the plan of its run.
//
// Thread: load path. Cost: linear in the number of bodies and forces.
#pragma once

#include "runtime/scene/plan.h"

#include <vector>

namespace fulcrum::runtime {

/// Compiles `lesson` for this machine. Refuses with one sentence a scene that cannot be rendered
/// safely or truthfully: two bodies of one name, felt weights whose order contradicts the true one,
/// too many bodies, solids or forces, a material with anything out of its range.
[[nodiscard]] Expected<Plan> compile_plan(const LessonDescription& lesson,
                                          const PlanOptions& options, const SolidLoader& load_solid,
                                          const PictureLoader& load_picture = {});

/// Felt weights in newtons: true weight times exaggeration, all times one factor so that the
/// `holds` heaviest together stay within kWeightShareOfLimit of the limit, the site's or the
/// device's, whichever is smaller. Order and ratios are
/// kept; nothing is clipped.
struct FeltWeights {
    std::vector<double> newtons;
    double scale = 1.0;
};
[[nodiscard]] FeltWeights fit_felt_weights(const std::vector<BodyDescription>& bodies,
                                           double gravity_m_per_s2, int holds,
                                           double force_limit_N);

}  // namespace fulcrum::runtime
