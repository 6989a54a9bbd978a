#include "haptics/tool/tool_plan.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

namespace fulcrum {
namespace {

constexpr double kHoldsTimes = 2.0;       // what a single point holds, in parts of the force
constexpr double kFullContacts = 4.0;     // points in voxels that push with all their stiffness
constexpr double kLookAheadCycles = 2.0;  // what leads nowhere within two steps is not braked
constexpr std::size_t kCachedBytes = 2U << 20U;  // a grid up to here is faster than a tree
constexpr int kTreeDepth = 2;
constexpr double kNearShare = 0.1;     // of the tool's reach: what counts as near at most
constexpr double kLayerShare = 0.25;   // of that: from how far outside it pushes
constexpr double kNearVoxels = 0.5;    // and of a field's voxel, so that a clearance of one is free
constexpr double kClusterShare = 0.3;  // of its reach: how wide a cluster is
constexpr double kSpreadShare = 0.1;   // of its reach: between contacts of one pair of pieces
constexpr int kMostPairs = 1 << 15;    // of levels, for each object
constexpr int kLevelSolves = 4;        // a step at most: their contacts are few, and come and go

VoxelToolSettings make_clamped(const ToolOrder& order) {
    VoxelToolSettings settings = order.settings;
    settings.clamped_at_half_voxel = false;
    ToolCouplingSettings& coupling = settings.coupling;
    coupling.clamp_m = order.most_force_N / coupling.shift.stiffness_N_per_m;
    coupling.clamp_rad =
        std::min(std::numbers::pi, order.most_force_N * compute_reach_m(*order.shell) /
                                       coupling.turn.stiffness_Nm_per_rad);
    return settings;
}

PenaltyPlan make_penalty(const ToolOrder& order, double reach_m, double within_m) {
    PenaltyPlan penalty;
    const double layer_m = kLayerShare * within_m;
    penalty.contacts = {.stiffness_N_per_m = kHoldsTimes * order.most_force_N / layer_m,
                        .damping_Ns_per_m = kCriticalDamping,
                        .within_m = layer_m};
    penalty.clusters.within_m = within_m;
    penalty.clusters.radius_m = std::max(kClusterShare * reach_m, within_m);
    return penalty;
}

// What is large is kept as a tree.
void put_map(const std::shared_ptr<const VoxelGrid>& grid, VoxelSamplingPlan& object) {
    object.grid = grid;
    if (grid == nullptr || grid->memory_bytes() <= kCachedBytes) {
        return;
    }
    if (auto map = Voxmap::build(*grid, kTreeDepth)) {
        object.map = std::make_shared<const Voxmap>(std::move(*map));
        object.grid = nullptr;
    }
}

}  // namespace

double compute_reach_m(const Pointshell& shell) {
    double reach_m = 0.0;
    for (std::size_t i = 0; i < shell.size(); ++i) {
        reach_m = std::max(reach_m, shell.position_T(i).norm());
    }
    return reach_m;
}

ToolPlan make_voxel_tool_plan(const ToolOrder& order,
                              const std::vector<std::shared_ptr<const VoxelGrid>>& grids) {
    std::vector<VoxelSamplingPlan> objects;
    for (const std::shared_ptr<const VoxelGrid>& grid : grids) {
        VoxelSamplingPlan object;
        put_map(grid, object);
        object.shell = order.shells.empty() ? *order.shell : *order.shells[objects.size()];
        object.settings.averaging = ContactAveraging::smooth;
        object.settings.full_contacts = kFullContacts;
        object.settings.look_ahead_cycles = kLookAheadCycles;
        if (grid != nullptr) {
            object.settings.stiffness_N_per_m =
                2.0 * kHoldsTimes * order.most_force_N / grid->frame.voxel_m;
        }
        objects.push_back(std::move(object));
    }
    return {std::move(objects), make_clamped(order)};
}

Expected<ToolPlan> make_field_tool_plan(const ToolOrder& order,
                                        const std::vector<FieldSampler::Field>& fields) {
    auto tree = ShellTree::build(*order.shell);
    if (!tree) {
        return tl::unexpected(tree.error());
    }
    const auto shell = std::make_shared<const ShellTree>(std::move(*tree));
    std::vector<FieldSamplingPlan> objects;
    for (const FieldSampler::Field& field : fields) {
        FieldSamplingPlan object{field, shell, {}};
        object.settings.along = ForceAlong::slopes;
        if (field != nullptr) {
            object.settings.stiffness_N_per_m = kHoldsTimes * order.most_force_N / field->band_m();
        }
        objects.push_back(std::move(object));
    }
    return ToolPlan{std::move(objects), make_clamped(order)};
}

ToolPlan make_god_object_plan(const ToolOrder& order, const std::shared_ptr<const GodSurface>& tool,
                              const std::vector<std::shared_ptr<const GodSurface>>& objects) {
    std::vector<GodObjectPlan> plans;
    plans.reserve(objects.size());
    for (const std::shared_ptr<const GodSurface>& object : objects) {
        plans.push_back({object, tool});
    }
    return {std::move(plans), make_clamped(order)};
}

GodObjectSettings make_god_object_settings(const ToolPlan& plan) {
    const VoxelToolSettings& settings = plan.settings;
    GodObjectSettings made;
    made.coupling = settings.coupling;
    made.inertia = settings.inertia;
    made.inertia.moments_kg_m2 =
        Vector3::Constant(settings.inertia.mass_kg * settings.coupling.turn.stiffness_Nm_per_rad /
                          settings.coupling.shift.stiffness_N_per_m);
    made.grip_T = settings.grip_T;
    made.handle_turn = settings.handle_turn;
    made.gap_m = plan.god_gap_m;
    made.most_rounds = plan.god_rounds;
    made.own_motion = !plan.beside;
    made.age = plan.age;
    return made;
}

double compute_contact_distance_m(double reach_m, double finest_voxel_m) {
    return std::min(kNearShare * reach_m, kNearVoxels * finest_voxel_m);
}

ToolPlan make_level_tool_plan(const ToolOrder& order, const LevelOrder& levels) {
    const double reach_m = compute_reach_m(*order.shell);
    LevelPairSettings settings;
    settings.tolerance_m = std::min(levels.tolerance * levels.tool->size_m(), 1.0);
    settings.spread_m = std::clamp(kSpreadShare * reach_m, 1.0e-6, 10.0);
    settings.most_pairs = kMostPairs;
    std::vector<LevelContactsPlan> objects;
    for (std::size_t i = 0; i < levels.objects.size(); ++i) {
        objects.push_back({levels.objects[i], levels.tool, settings,
                           i < levels.object_solids.size() ? levels.object_solids[i] : nullptr,
                           levels.tool_solid});
    }
    ToolPlan plan{std::move(objects), make_clamped(order)};
    plan.penalty = make_penalty(order, reach_m, levels.tool->settings().within_m);
    return plan;
}

Expected<ToolPlan> make_penalty_tool_plan(const ToolOrder& order,
                                          const std::vector<FieldSampler::Field>& fields) {
    return make_field_tool_plan(order, fields).map([&](ToolPlan plan) {
        const double reach_m = compute_reach_m(*order.shell);
        double finest_m = std::numeric_limits<double>::infinity();
        for (const FieldSampler::Field& field : fields) {
            if (field != nullptr) {
                finest_m = std::min(finest_m, field->frame().voxel_m);
            }
        }
        plan.penalty = make_penalty(order, reach_m, compute_contact_distance_m(reach_m, finest_m));
        return plan;
    });
}

ImplicitPenaltyPlan make_implicit_penalty_plan(const ToolPlan& plan) {
    ImplicitPenaltyPlan penalty;
    const auto* const meshes = std::get_if<std::vector<LevelContactsPlan>>(&plan.objects);
    if (meshes != nullptr) {
        penalty.meshes = *meshes;
    } else {
        for (const auto& object : std::get<std::vector<FieldSamplingPlan>>(plan.objects)) {
            penalty.objects.push_back({object.field, object.shell});
        }
    }
    const VoxelToolSettings& settings = plan.settings;
    penalty.settings = {
        .coupling = settings.coupling,
        .critically_damped = settings.critically_damped,
        .inertia = settings.inertia,
        .grip_T = settings.grip_T,
        .handle_turn = settings.handle_turn,
        .newton_iterations = meshes != nullptr ? kLevelSolves : penalty.settings.newton_iterations,
        .silent_in_free_space = settings.silent_in_free_space,
        .contacts = plan.penalty->contacts,
        .clusters = plan.penalty->clusters,
        .own_rounds = !plan.beside,
        .round_s = plan.penalty->round_s,
        .budget_us = meshes != nullptr ? settings.budget_us : 0.0,
        .age = plan.age};
    return penalty;
}

std::size_t count_points(const ToolPlan& plan) {
    std::size_t most = 0;
    if (const auto* meshes = std::get_if<std::vector<GodObjectPlan>>(&plan.objects)) {
        return meshes->empty() ? 0 : meshes->front().tool->n_places();
    }
    if (const auto* levels = std::get_if<std::vector<LevelContactsPlan>>(&plan.objects)) {
        return levels->empty() ? 0 : static_cast<std::size_t>(levels->front().tool->n_pieces());
    }
    if (const auto* voxels = std::get_if<std::vector<VoxelSamplingPlan>>(&plan.objects)) {
        for (const VoxelSamplingPlan& object : *voxels) {
            most = std::max(most, object.shell.size());
        }
        return most;
    }
    for (const auto& object : std::get<std::vector<FieldSamplingPlan>>(plan.objects)) {
        most = std::max(most, object.shell->n_points());
    }
    return most;
}

const char* find_quadrant(ToolMethod method, ToolMass mass) noexcept {
    return method == ToolMethod::god_object ? "hard, massless"
           : mass == ToolMass::massless     ? "soft, massless"
                                            : "soft, massive";
}

bool has_texture(const ToolPlan& plan) {
    const auto* meshes = std::get_if<std::vector<GodObjectPlan>>(&plan.objects);
    return meshes != nullptr && has_texture(*meshes);
}

bool has_shading(const ToolPlan& plan) {
    const auto* meshes = std::get_if<std::vector<GodObjectPlan>>(&plan.objects);
    return meshes != nullptr && has_shading(*meshes);
}

Expected<void> validate(const ToolPlan& plan) {
    if (plan.penalty) {
        return ImplicitPenaltyTool::build(make_implicit_penalty_plan(plan)).map([](const auto&) {});
    }
    if (const auto* voxels = std::get_if<std::vector<VoxelSamplingPlan>>(&plan.objects)) {
        return VoxelTool::build(*voxels, plan.settings).map([](const VoxelTool&) {});
    }
    if (const auto* meshes = std::get_if<std::vector<GodObjectPlan>>(&plan.objects)) {
        return GodObjectTool::build(*meshes, make_god_object_settings(plan))
            .map([](const GodObjectTool&) {});
    }
    return FieldTool::build(std::get<std::vector<FieldSamplingPlan>>(plan.objects), plan.settings)
        .map([](const FieldTool&) {});
}

std::unique_ptr<ToolSolver> make_tool(const ToolPlan& plan) {
    if (plan.penalty) {
        return std::make_unique<ImplicitPenaltyTool>(
            ImplicitPenaltyTool::build(make_implicit_penalty_plan(plan)).value());
    }
    if (const auto* voxels = std::get_if<std::vector<VoxelSamplingPlan>>(&plan.objects)) {
        return std::make_unique<VoxelTool>(VoxelTool::build(*voxels, plan.settings).value());
    }
    if (const auto* meshes = std::get_if<std::vector<GodObjectPlan>>(&plan.objects)) {
        return std::make_unique<GodObjectTool>(
            GodObjectTool::build(*meshes, make_god_object_settings(plan)).value());
    }
    return std::make_unique<FieldTool>(
        FieldTool::build(std::get<std::vector<FieldSamplingPlan>>(plan.objects), plan.settings)
            .value());
}

}  // namespace fulcrum
