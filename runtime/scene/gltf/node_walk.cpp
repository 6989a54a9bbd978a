#include "runtime/scene/gltf/node_walk.h"

#include "haptics/math/affine.h"
#include "haptics/math/length.h"
#include "runtime/scene/gltf/limits.h"

#include <tiny_gltf.h>

#include <cmath>
#include <string>

namespace fulcrum::runtime::gltf {
namespace {

/// Volume factors outside this range come from a scale of 0 or of thousands: nothing sensible is
/// left of the shape.
constexpr double kMinVolumeFactor = 1e-18;

tl::unexpected<Error> refuse(std::size_t node, const char* why) {
    return fail("nodes[" + std::to_string(node) + "] " + why, {}, kExportAgain);
}

/// A rotation is a unit quaternion but for rounding; one outside this range is not meant as one.
constexpr double kMinQuaternionLength = 1e-3;
constexpr double kMaxQuaternionLength = 1e3;

bool is_rotation(const std::vector<double>& q) {
    const double length = q.size() == 4 ? compute_length(Vector4(q.data())) : 1.0;
    return length > kMinQuaternionLength && length < kMaxQuaternionLength;
}

/// X_PN from the node's matrix or from its translation, rotation and scale.
Matrix4 local_transform(const tinygltf::Node& node) {
    if (node.matrix.size() == 16) {
        return Matrix4(node.matrix.data());
    }
    Affine X_PN = Affine::Identity();
    if (node.translation.size() == 3) {
        X_PN.translate(Vector3(node.translation.data()));
    }
    if (node.rotation.size() == 4) {
        const Quaternion q(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
        X_PN.rotate(q.normalized());
    }
    if (node.scale.size() == 3) {
        X_PN.scale(Vector3(node.scale.data()));
    }
    return X_PN.matrix();
}

bool usable(const Matrix4& transform) {
    const bool affine = (transform.row(3).transpose() - Vector4(0, 0, 0, 1)).norm() <= 1e-6;
    const double volume = std::abs(transform.topLeftCorner<3, 3>().determinant());
    return transform.allFinite() && affine && volume > kMinVolumeFactor && std::isfinite(volume);
}

/// Each node has one parent at most, and roots have none: then the scene is a forest and no cycle
/// can be reached.
Expected<std::vector<bool>> find_children(const tinygltf::Model& model) {
    std::vector<bool> is_child(model.nodes.size(), false);
    for (const auto& node : model.nodes) {
        for (const int child : node.children) {
            if (child < 0 || static_cast<std::size_t>(child) >= model.nodes.size()) {
                return fail("a node has a child that does not exist", {}, kExportAgain);
            }
            if (is_child[static_cast<std::size_t>(child)]) {
                return refuse(static_cast<std::size_t>(child), "is the child of two nodes");
            }
            is_child[static_cast<std::size_t>(child)] = true;
        }
    }
    return is_child;
}

Expected<std::vector<std::size_t>> find_roots(const tinygltf::Model& model) {
    auto is_child = find_children(model);
    if (!is_child) {
        return tl::unexpected(is_child.error());
    }
    std::vector<std::size_t> roots;
    if (model.scenes.empty()) {
        for (std::size_t i = 0; i < model.nodes.size(); ++i) {
            if (!(*is_child)[i]) {
                roots.push_back(i);
            }
        }
        return roots;
    }
    const std::size_t scene =
        model.defaultScene > 0 ? static_cast<std::size_t>(model.defaultScene) : 0;
    if (scene >= model.scenes.size()) {
        return fail("its scene does not exist", {}, kExportAgain);
    }
    for (const int root : model.scenes[scene].nodes) {
        const auto i = static_cast<std::size_t>(root);
        if (root < 0 || i >= model.nodes.size() || (*is_child)[i]) {
            return fail("its scene begins at a node that is another's child or listed twice", {},
                        kExportAgain);
        }
        (*is_child)[i] = true;
        roots.push_back(i);
    }
    return roots;
}

struct Visit {
    std::size_t node;
    int depth;
    Matrix4 X_MP;
};

}  // namespace

Expected<std::vector<PlacedMesh>> place_meshes(const tinygltf::Model& model) {
    auto roots = find_roots(model);
    if (!roots) {
        return tl::unexpected(roots.error());
    }
    std::vector<Visit> open;
    for (auto root = roots->rbegin(); root != roots->rend(); ++root) {
        open.push_back({*root, 1, Matrix4::Identity()});
    }
    std::vector<PlacedMesh> placed;
    while (!open.empty()) {
        const Visit visit = open.back();
        open.pop_back();
        if (visit.depth > kMaxNodeDepth) {
            return refuse(visit.node, "lies more than 64 nodes deep");
        }
        const auto& node = model.nodes[visit.node];
        const Matrix4 X_MN = visit.X_MP * local_transform(node);
        if (!is_rotation(node.rotation) || !usable(X_MN)) {
            return refuse(visit.node, "has a transform that flattens or blows up what it holds");
        }
        if (node.mesh >= 0) {
            if (static_cast<std::size_t>(node.mesh) >= model.meshes.size()) {
                return refuse(visit.node, "has a mesh that does not exist");
            }
            placed.push_back({static_cast<std::size_t>(node.mesh), X_MN});
        }
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
            open.push_back({static_cast<std::size_t>(*child), visit.depth + 1, X_MN});
        }
    }
    return placed;
}

}  // namespace fulcrum::runtime::gltf
