// A tool as a plan names it: its method and all that it is made from.
//
// So that no hand presses the tool through what it meets, the coupling pulls and turns with at most the force that may be felt,
//   k c = F,   k_r c_r = F R            c, c_r the clamps, R how far the farthest point lies from the centre of mass
// and each single point holds twice that as deep as it may be:
//   k_point s / 2 = 2 F   in voxels of side s, where each pushes within half a voxel
//   k_point b     = 2 F   in a field whose band is b deep
// McNeely clamps at c = s / 2, so that with fine voxels a soft coupling could not press.
// Among clusters of contact that push from d outside on, a quarter of how far off they are found, each holds it outside:
//   k_cluster d   = 2 F
// A god-object is clamped likewise; the inertia by which it answers a turn is such that the coupling's springs are what is felt,
// I = m k_r / k along all axes.
//
// Thread: load path.
#pragma once

#include "haptics/tool/god_object/god_object_tool.h"
#include "haptics/tool/implicit_penalty/implicit_penalty.h"
#include "haptics/tool/voxel_tool.h"

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace fulcrum {

/// What the tool meets, one a solid of the haptic plan, in its order: voxels or fields, which its points are sampled in, or meshes, as they are or as
/// contact levels.
using ToolObjects = std::variant<std::vector<VoxelSamplingPlan>, std::vector<FieldSamplingPlan>,
                                 std::vector<GodObjectPlan>, std::vector<LevelContactsPlan>>;

/// How clusters of contact push, where they do (implicit_penalty.h).
struct PenaltyPlan {
    ContactPlanesSettings contacts{};
    ContactClusterSettings clusters{};
    double round_s = 0.0;  ///< of the contact rounds; 0: each step
};

struct ToolPlan {
    ToolObjects objects;
    VoxelToolSettings settings{};
    std::optional<PenaltyPlan>
        penalty{};        ///< then among fields or contact levels, which find the contacts
    bool beside = false;  ///< contact is found by work beside the steps, where the method has such
    ContactAgeSettings age{};   ///< then
    int god_rounds = 100;       ///< of a god-object: GodObjectSettings::most_rounds ...
    double god_gap_m = 1.0e-6;  ///< ... and gap_m

    [[nodiscard]] std::size_t n_objects() const {
        return std::visit([](const auto& plans) { return plans.size(); }, objects);
    }
};

/// What a tool's plan is made from. All lengths in metres of the world.
struct ToolOrder {
    /// Points from the centre of mass along the principal axes.
    std::shared_ptr<const Pointshell> shell;
    /// The same for each object, where they have their own; else empty.
    std::vector<std::shared_ptr<const Pointshell>> shells{};
    VoxelToolSettings settings{};  ///< the clamps are set by the laws above
    double most_force_N = 5.0;     ///< that the hand may feel, above 0
};

/// How far the farthest point lies from the centre of mass.
[[nodiscard]] double compute_reach_m(const Pointshell& shell);

/// The tool among voxels: springs averaged smoothly from four points on, a large grid kept as a tree.
[[nodiscard]] ToolPlan make_voxel_tool_plan(
    const ToolOrder& order, const std::vector<std::shared_ptr<const VoxelGrid>>& grids);

/// The tool among fields, pushed along their slopes, so that no closed way gains energy. Refuses a shell that has no tree.
[[nodiscard]] Expected<ToolPlan> make_field_tool_plan(
    const ToolOrder& order, const std::vector<FieldSampler::Field>& fields);

/// The tool among contacts that fields find, held by planes.
[[nodiscard]] Expected<ToolPlan> make_penalty_tool_plan(
    const ToolOrder& order, const std::vector<FieldSampler::Field>& fields);

/// How near counts as contact, and how far out contact levels are to look: a tenth of the tool's reach, and half of the finest voxel, so that
/// a clearance of one is free.
[[nodiscard]] double compute_contact_distance_m(double reach_m, double finest_voxel_m);

/// What contact levels are asked for.
struct LevelOrder {
    std::shared_ptr<const ContactLevels> tool;  ///< as the order's points are
    std::shared_ptr<const TriangleClusters> tool_solid;
    std::vector<std::shared_ptr<const ContactLevels>> objects;
    std::vector<std::shared_ptr<const TriangleClusters>> object_solids;
    double tolerance = 0.0;  ///< in parts of the tool's size; 0: as fine as the meshes
};
/// The tool among contacts that contact levels find, all made for one distance, held by planes. A budget of the settings' is that of
/// each round.
[[nodiscard]] ToolPlan make_level_tool_plan(const ToolOrder& order, const LevelOrder& levels);

/// The tool's mesh, about its centre of mass, along its principal axes, among meshes.
[[nodiscard]] ToolPlan make_god_object_plan(
    const ToolOrder& order, const std::shared_ptr<const GodSurface>& tool,
    const std::vector<std::shared_ptr<const GodSurface>>& objects);
/// Of such a plan: what its tool is built with.
[[nodiscard]] GodObjectSettings make_god_object_settings(const ToolPlan& plan);

/// Of such a plan: what its tool is built from.
[[nodiscard]] ImplicitPenaltyPlan make_implicit_penalty_plan(const ToolPlan& plan);

/// Points of the tool, of a god-object the corners of its triangles, of contact levels its pieces, against the object that asks for the most of
/// them.
[[nodiscard]] std::size_t count_points(const ToolPlan& plan);

/// Of Otaduy and Lin's four: "hard, massless", "soft, massless" or "soft, massive"; whether constraints hold to the point, and whether the
/// tool has a mass. The fourth, "hard, massive", is a body of the world that a hand grips (dynamics/hand_rows.h).
[[nodiscard]] const char* find_quadrant(ToolMethod method, ToolMass mass) noexcept;

/// Whether the relief of some object is felt.
[[nodiscard]] bool has_texture(const ToolPlan& plan);
/// Whether normals that turn evenly are.
[[nodiscard]] bool has_shading(const ToolPlan& plan);

/// Refuses what the method's build does.
[[nodiscard]] Expected<void> validate(const ToolPlan& plan);

/// The tool of a plan that `validate` accepted.
[[nodiscard]] std::unique_ptr<ToolSolver> make_tool(const ToolPlan& plan);

}  // namespace fulcrum
