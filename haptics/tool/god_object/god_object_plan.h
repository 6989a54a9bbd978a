// What a god-object's tool is built from, and what one of its steps tells (god_object_tool.h).
//
// Thread: load path.
#pragma once

#include "haptics/base/error.h"
#include "haptics/coupling/tool_coupling.h"
#include "haptics/dynamics/rigid_state.h"
#include "haptics/surface/friction.h"
#include "haptics/surface/texture.h"
#include "haptics/tool/contact_age.h"
#include "haptics/tool/god_object/god_shading.h"
#include "haptics/tool/god_object/god_surface.h"

#include <memory>
#include <vector>

namespace fulcrum {

/// Fixed at load.
struct GodObjectSettings {
    /// K, and the clamps: with stiffnesses the most that is felt. Dampers, and what saturates, are not used.
    ToolCouplingSettings coupling{};
    Inertia inertia{};                ///< M
    Vector3 grip_T{Vector3::Zero()};  ///< where the hand holds it, metres from the centre of mass
    Quaternion handle_turn{
        Quaternion::Identity()};  ///< q_HT, unit: how the tool lies in the handle
    double step_share = 0.5;      ///< k_s of the way to the handle a step; above 0, to 1
    double gap_m = 1.0e-6;        ///< delta, 1e-8 to 1e-3; half of the tightest clearance at most
    double fade_s = 0.05;         ///< of what a new set of contacts changes of the force; 0 to 1
    int most_rounds = 100;        ///< a step, 1 to 1000; counted, so that no clock tells a force
    int most_contacts = 2048;     ///< of an object, 1 to 65536
    bool own_motion = true;    ///< a step goes its way itself; else work beside does (god_motion.h)
    ContactAgeSettings age{};  ///< then, of the sets of contacts that it told
};

/// Refuses settings outside their ranges, NaN included.
[[nodiscard]] Expected<void> validate(const GodObjectSettings& settings);

/// How far the force of a wall may be off, N: K delta, for it is met a gap at rest before its surface; what the constraints' answer is off by, some 1e-6 of the depth at most, is less below 0.1 m.
/// Between two walls that meet at an angle that over the sine of its half. Without friction, and besides what is still blended in.
[[nodiscard]] double find_wall_error_N(const GodObjectSettings& settings) noexcept;

/// One object and the tool, both made ready.
struct GodObjectPlan {
    std::shared_ptr<const GodSurface> object;
    std::shared_ptr<const GodSurface> tool;  ///< about its centre of mass, along its principal axes
    FrictionSettings friction{};             ///< between them; without a viscous part
    /// What is felt turns evenly over their edges (god_shading.h); of the same meshes, or none.
    std::shared_ptr<const GodShading> object_shading{};
    std::shared_ptr<const GodShading> tool_shading{};
    std::shared_ptr<const Texture> texture{};  ///< the object's relief, felt alone; or none
};

/// Whether contacts with some object hold along themselves.
[[nodiscard]] bool has_friction(const std::vector<GodObjectPlan>& plans);
/// Whether the relief of some object is felt.
[[nodiscard]] bool has_texture(const std::vector<GodObjectPlan>& plans);
/// Whether contacts with some object are felt by normals that turn evenly.
[[nodiscard]] bool has_shading(const std::vector<GodObjectPlan>& plans);
/// How far the tool reaches from its centre of mass.
[[nodiscard]] double find_reach_m(const std::vector<GodObjectPlan>& plans);

/// What one step did.
struct GodObjectStep {
    int rounds = 0;
    int contacts = 0;          ///< where it ended
    double least_gap_m = 0.0;  ///< of those; infinite without any
    bool settled = true;       ///< nothing was left to go; else it goes on in the next step
    int unsettled = 0;         ///< steps before it, in a row, that were not
    bool wedged = false;       ///< objects wait for room: they are not where they were said to be
    bool too_many = false;     ///< contacts; those left out are kept off by the sweep alone
};

}  // namespace fulcrum
