// The solid bodies as a tool in the hand meets them: voxels or distance fields of those that tool_body_list.h lists.
//
//   meshes  as they are, for a god-object
//   levels  contact levels of detail of the meshes, for an implicit penalty that asks for them
//   fields  4 voxels deep on both sides of the surface
//   voxels  the layer that pushes lies one voxel outside the body, which holds the tool out where its points are as near to each
//           other as voxels are; those that brake reach 4 mm further, in the hand's metres: two steps of a hand at 2 m/s at 1 kHz
// What takes long comes from the cache of shapes where it has been made before.
//
// Thread: load path. Cost: 10 ms and 1 byte a voxel up to 4 million for each mesh; with a lesson's own voxels at most kMostVoxels.
#pragma once

#include "haptics/tool/field_sampling/field_sampler.h"
#include "haptics/tool/god_object/god_surface.h"
#include "haptics/tool/implicit_penalty/level_contacts.h"
#include "haptics/voxel/voxel_grid.h"
#include "runtime/effect/tool/tool_body_list.h"
#include "runtime/scene/plan.h"

#include <memory>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// One of a kind for each solid, in the plan's order, the same for bodies that share a mesh.
struct ToolBodies {
    std::vector<std::shared_ptr<const VoxelGrid>> grids;
    std::vector<FieldSampler::Field> fields;
    std::vector<std::shared_ptr<const GodSurface>> surfaces;
    std::vector<std::shared_ptr<const ContactLevels>> levels;
    std::vector<std::shared_ptr<const TriangleClusters>> solids;  ///< beside levels
    std::vector<ShapeSource> sources;
    std::vector<std::string> notices;  ///< of holes, sheets and thin walls
};

/// Whether a tool's contacts are found by contact levels.
[[nodiscard]] bool has_levels(const ToolDescription& tool);

/// Makes them, telling `progress` of each by its noun; contact levels for what is nearer than `within_m`.
[[nodiscard]] Expected<ToolBodies> make_tool_bodies(const LessonDescription& lesson,
                                                    const ToolBodyList& list, double within_m,
                                                    const PlanProgress& progress,
                                                    ShapeCache& shapes);

}  // namespace fulcrum::runtime
