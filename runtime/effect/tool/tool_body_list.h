// The solid bodies that a tool in the hand meets, each mesh once, however many bodies have it, and how fine it is met.
//
//   voxel   as the lesson says; else as fine as a body asks for, and no finer than its share of all voxels allows
//             s = max(length / 400, (volume of its box / 4 million)^(1/3), s_share, 0.05 mm)
//             s_share: the body's block, margins and all, has kMostVoxels / n voxels, with n meshes
// What is too much is refused before anything is made.
//
// Thread: load path. Cost: a copy of each mesh.
#pragma once

#include "haptics/geometry/triangle_mesh.h"
#include "runtime/scene/plan.h"

#include <cstddef>
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

/// The finest of the bodies' voxels.
[[nodiscard]] double find_finest_voxel_m(const ToolBodyList& list);

/// The triangles of a mesh that is ready to be touched.
[[nodiscard]] Expected<TriangleMesh> to_triangles(const CollisionMesh& mesh);

}  // namespace fulcrum::runtime
