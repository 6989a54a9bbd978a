// The solid bodies as a tool in the hand meets them: voxels or distance fields, each mesh once, however many bodies have it.
//
//   voxel   as the lesson says; else as fine as a body asks for, and no finer than its share of all voxels allows
//             s = max(length / 400, (volume of its box / 4 million)^(1/3), s_share, 0.05 mm)
//             s_share: the body's block, margins and all, has kMostVoxels / n voxels, with n meshes
//   meshes  as they are, for a god-object
//   levels  contact levels of detail of the meshes, for an implicit penalty that asks for them
//   fields  4 voxels deep on both sides of the surface
//   voxels  the layer that pushes lies one voxel outside the body, which holds the tool out where its points are as near to each
//           other as voxels are; those that brake reach 4 mm further, in the hand's metres: two steps of a hand at 2 m/s at 1 kHz
// What is too much is refused before anything is made; what takes long comes from the cache of shapes where it has been made before.
//
// Thread: load path. Cost: 10 ms and 1 byte a voxel up to 4 million for each mesh; with a lesson's own voxels at most kMostVoxels.
#pragma once

#include "haptics/geometry/triangle_mesh.h"
#include "haptics/tool/field_sampling.h"
#include "haptics/tool/god_surface.h"
#include "haptics/tool/level_contacts.h"
#include "haptics/voxel/voxel_grid.h"
#include "runtime/scene/plan.h"

#include <memory>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Of all bodies together: 64 MB while they are made, a second.
inline constexpr double kMostVoxels = 64.0e6;

/// What is to be made.
struct ToolBodyList {
    struct Mesh {
        const BodyDescription* body = nullptr;  ///< the first that has it
        TriangleMesh mesh;
        double voxel_m = 0.0;
    };
    std::vector<Mesh> meshes;
    std::vector<std::size_t> mesh_of;  ///< of each solid, in the plan's order
};

/// Checks all bodies; refuses with one sentence and the line of the lesson a material where the tool feels shape alone (god_object feels friction and texture) and voxels
/// that are too small or too many, and says which would do. `lesson` must outlive it.
[[nodiscard]] Expected<ToolBodyList> list_tool_bodies(const LessonDescription& lesson,
                                                      const std::vector<SolidPlan>& solids);

/// Whether a lesson may ask for voxels of that side of a body so long.
[[nodiscard]] bool can_be_met_with(double length_m, double voxel_m);

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

/// The finest of the bodies' voxels.
[[nodiscard]] double find_finest_voxel_m(const ToolBodyList& list);

/// Makes them, telling `progress` of each by its noun; contact levels for what is nearer than `within_m`.
[[nodiscard]] Expected<ToolBodies> make_tool_bodies(const LessonDescription& lesson,
                                                    const ToolBodyList& list, double within_m,
                                                    const PlanProgress& progress,
                                                    ShapeCache& shapes);

/// The triangles of a mesh that is ready to be touched.
[[nodiscard]] Expected<TriangleMesh> to_triangles(const CollisionMesh& mesh);

}  // namespace fulcrum::runtime
