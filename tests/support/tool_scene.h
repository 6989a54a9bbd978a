// A tool of points and what it meets, for tests and hard cases: meshes in, a plan's tool out.
#pragma once

#include "haptics/geometry/shape.h"
#include "haptics/tool/tool_plan.h"
#include "haptics/voxel/voxelise.h"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace fulcrum::test {

struct ToolScene {
    TriangleMesh tool;
    Inertia inertia{};
    ToolMethod method = ToolMethod::voxel_sampling;
    double voxel_m = 0.004;
    int n_points = 2000;
    double most_force_N = 5.0;
    bool in_rows = false;  ///< among voxels a point a voxel, as a plan has them
    ContactFinding contact = ContactFinding::fields;  ///< of implicit_penalty
    double tolerance = 0.025;                         ///< of contact levels
    VoxelToolSettings settings{};
};

/// A ball of 2 cm and 20 g.
inline ToolScene make_ball_tool(ToolMethod method = ToolMethod::voxel_sampling) {
    return {.tool = make_sphere(0.02, 12).value(),
            .inertia = make_ball_inertia(0.02, 0.02),
            .method = method};
}

/// As a plan has them.
inline LevelOrder make_level_order(const ToolScene& scene, const std::vector<TriangleMesh>& objects,
                                   double reach_m) {
    const ContactLevelSettings settings{.within_m =
                                            compute_contact_distance_m(reach_m, scene.voxel_m)};
    LevelOrder levels{ContactLevels::create(scene.tool, settings).value(),
                      std::make_shared<const TriangleClusters>(scene.tool),
                      {},
                      {},
                      scene.tolerance};
    for (const TriangleMesh& object : objects) {
        levels.objects.push_back(ContactLevels::create(object, settings).value());
        levels.object_solids.push_back(std::make_shared<const TriangleClusters>(object));
    }
    return levels;
}

/// Voxels have one layer outwards, so that the tool stays outside.
inline std::shared_ptr<const ToolPlan> make_tool_of(ToolScene scene,
                                                    const std::vector<TriangleMesh>& objects) {
    scene.settings.inertia = scene.inertia;
    ToolOrder order;
    order.shell = std::make_shared<const Pointshell>(
        make_surface_pointshell(scene.tool, scene.n_points).value());
    order.settings = scene.settings;
    order.most_force_N = scene.most_force_N;
    if (scene.method == ToolMethod::god_object) {
        std::vector<std::shared_ptr<const GodSurface>> surfaces;
        surfaces.reserve(objects.size());
        for (const TriangleMesh& object : objects) {
            surfaces.push_back(GodSurface::create(object));
        }
        return std::make_shared<const ToolPlan>(
            make_god_object_plan(order, GodSurface::create(scene.tool), surfaces));
    }
    if (scene.contact == ContactFinding::levels) {
        return std::make_shared<const ToolPlan>(make_level_tool_plan(
            order, make_level_order(scene, objects, compute_reach_m(*order.shell))));
    }
    std::vector<std::shared_ptr<const VoxelGrid>> grids;
    std::vector<FieldSampler::Field> fields;
    for (const TriangleMesh& object : objects) {
        if (scene.method != ToolMethod::voxel_sampling) {
            const double length_m = (object.upper_B() - object.lower_B()).maxCoeff();
            const int n_along =
                8 * static_cast<int>(std::ceil(length_m / scene.voxel_m / 8.0)) + 16;
            fields.push_back(std::make_shared<const DistanceField>(
                DistanceField::build(object, make_field_frame(object, n_along).value()).value()));
            continue;
        }
        grids.push_back(std::make_shared<const VoxelGrid>(
            voxelise(object, {.voxel_m = scene.voxel_m, .offset_layers = 1, .proximity_layers = 2})
                .value()));
    }
    if (scene.in_rows) {
        order.shells.assign(grids.size(),
                            std::make_shared<const Pointshell>(
                                make_voxel_pointshell(scene.tool, scene.voxel_m).value()));
    }
    switch (scene.method) {
        case ToolMethod::field_sampling:
            return std::make_shared<const ToolPlan>(make_field_tool_plan(order, fields).value());
        case ToolMethod::implicit_penalty:
            return std::make_shared<const ToolPlan>(make_penalty_tool_plan(order, fields).value());
        case ToolMethod::voxel_sampling:
        case ToolMethod::god_object:
            break;
    }
    return std::make_shared<const ToolPlan>(make_voxel_tool_plan(order, grids));
}

}  // namespace fulcrum::test
