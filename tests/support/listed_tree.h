// A 512-tree as the thesis describes it, kept as the thing to beat: nodes of 8 x 8 x 8 children down to a chosen depth, and in
// each leaf a list of the voxels that are not free, which a look goes through one by one. A deeper tree has shorter lists.
//
// Source: the thesis of systems.md, sections 2.2.1 and 2.2.5 ("a point in the pointshell should be checked for collision with a
// larger number of voxels" at depth 1).
#pragma once

#include "haptics/tool/voxel_sampling/voxel_sampling.h"

#include <memory>
#include <vector>

namespace fulcrum::test {

class ListedTree {
  public:
    /// Depth 1 or more.
    ListedTree(const VoxelGrid& grid, int depth);

    /// The centre of the surface voxel in which the point lies.
    [[nodiscard]] const Vector3* find_surface(const Vector3& p_O) const;

  private:
    struct Voxel {
        Vector3 lower_O, upper_O, centre_O;
        bool is_surface = false;
    };
    struct Node {
        std::vector<std::unique_ptr<Node>> children;  // 512, or none in a leaf
        std::vector<Voxel> voxels;                    // of a leaf
    };
    [[nodiscard]] Node* descend(const Vector3& p_O, bool make);

    Node root_;
    int depth_;
    Vector3 lower_O_;
    double edge_m_;  // of the cube that the root divides
};

/// Net force and torque by the thesis' equations 2.1 to 2.4, averaged beyond `full_contacts`: everything in double, one point
/// after another.
[[nodiscard]] Wrench sample_listed(const ListedTree& tree, const std::vector<Vector3>& points_T,
                                   const std::vector<Vector3>& normals_T, const Pose& X_OT,
                                   double stiffness_N_per_m, double full_contacts);

}  // namespace fulcrum::test
