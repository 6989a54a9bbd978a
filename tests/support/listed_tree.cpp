#include "tests/support/listed_tree.h"

#include "haptics/voxel/rasterise.h"

#include <algorithm>

namespace fulcrum::test {

ListedTree::ListedTree(const VoxelGrid& grid, int depth)
    : depth_(depth), lower_O_(grid.frame.lower_O) {
    const auto [nx, ny, nz] = grid.frame.n_cells;
    edge_m_ = grid.frame.voxel_m * std::max({nx, ny, nz});
    const Vector3 half = Vector3::Constant(0.5 * grid.frame.voxel_m);
    for_each_cell({{0, 0, 0}, {nx - 1, ny - 1, nz - 1}}, [&](const VoxelFrame::Cell& cell) {
        const VoxelClass kind = grid.find_class(cell);
        if (kind == VoxelClass::surface || kind == VoxelClass::interior) {
            const Vector3 centre = grid.frame.centre_of(cell);
            const Voxel voxel{centre - half, centre + half, centre, kind == VoxelClass::surface};
            // A voxel that leaves share is in each of them.
            std::vector<Node*> leaves;
            // Leaves are at least half as large as a voxel.
            constexpr double kNearly = 1.0 - 1.0e-9;
            for (int place = 0; place < 27; ++place) {
                const Vector3 sign =
                    kNearly * Vector3(place % 3 - 1, place / 3 % 3 - 1, place / 9 - 1);
                Node* const leaf = descend(centre + half.cwiseProduct(sign), true);
                if (leaf != nullptr &&
                    std::find(leaves.begin(), leaves.end(), leaf) == leaves.end()) {
                    leaves.push_back(leaf);
                    leaf->voxels.push_back(voxel);
                }
            }
        }
    });
}

ListedTree::Node* ListedTree::descend(const Vector3& p_O, bool make) {
    Node* node = &root_;
    Vector3 place = (p_O - lower_O_) / edge_m_;
    for (int level = 0; level < depth_; ++level) {
        if (!all_at_most(Vector3::Zero(), place) || !all_below(place, Vector3::Ones())) {
            return nullptr;
        }
        place *= 8.0;
        const Vector3 child = place.cwiseFloor();
        place -= child;
        const auto index = static_cast<std::size_t>(child.x() + 8.0 * child.y() + 64.0 * child.z());
        if (node->children.empty()) {
            if (!make) {
                return nullptr;
            }
            node->children.resize(512);
        }
        if (node->children[index] == nullptr) {
            if (!make) {
                return nullptr;
            }
            node->children[index] = std::make_unique<Node>();
        }
        node = node->children[index].get();
    }
    return node;
}

const Vector3* ListedTree::find_surface(const Vector3& p_O) const {
    const Node* const leaf = const_cast<ListedTree*>(this)->descend(p_O, false);
    if (leaf == nullptr) {
        return nullptr;
    }
    for (const Voxel& voxel : leaf->voxels) {
        if (all_at_most(voxel.lower_O, p_O) && all_below(p_O, voxel.upper_O)) {
            return voxel.is_surface ? &voxel.centre_O : nullptr;
        }
    }
    return nullptr;
}

Wrench sample_listed(const ListedTree& tree, const std::vector<Vector3>& points_T,
                     const std::vector<Vector3>& normals_T, const Pose& X_OT,
                     double stiffness_N_per_m, double full_contacts) {
    Wrench sum;
    double n = 0.0;
    for (std::size_t i = 0; i < points_T.size(); ++i) {
        const Vector3 p = X_OT * points_T[i];
        const Vector3* const centre = tree.find_surface(p);
        if (centre != nullptr) {
            const Vector3 normal = X_OT.orientation * normals_T[i];
            const double d = normal.dot(p - *centre);
            add_point_force(p - X_OT.position, -stiffness_N_per_m * d * normal, sum);
            n += 1.0;
        }
    }
    const double share = n > full_contacts ? full_contacts / n : 1.0;
    return {share * sum.force, share * sum.torque};
}

}  // namespace fulcrum::test
