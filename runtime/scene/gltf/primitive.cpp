#include "runtime/scene/gltf/primitive.h"

#include "haptics/math/length.h"
#include "runtime/scene/gltf/accessor_view.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulcrum::runtime::gltf {
namespace {

/// Below this length a normal has no direction worth keeping.
constexpr double kMinNormalLength = 1e-6;
constexpr std::size_t kCorner_bytes = (3 + 3 + 2) * sizeof(float) + sizeof(std::uint32_t);

Vector3 vector_at(const AccessorView& view, std::size_t i) {
    return {view.number(i, 0), view.number(i, 1), view.number(i, 2)};
}

void append(std::vector<float>& to, const Vector3& v) {
    for (int k = 0; k < 3; ++k) {
        to.push_back(static_cast<float>(v[k]));
    }
}

Vector3 corner(const ModelPrimitive& made, std::uint32_t i) {
    const float* p = made.positions.data() + 3 * std::size_t{i};
    return {p[0], p[1], p[2]};
}

/// Gathers one primitive, stage by stage.
class PrimitiveReader {
  public:
    PrimitiveReader(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                    const Matrix4& transform_MN, const std::string& place, MemoryBudget& budget)
        : model_(model),
          primitive_(primitive),
          transform_MN_(transform_MN),
          place_(place),
          budget_(budget) {}

    Expected<ModelPrimitive> read() {
        if (primitive_.mode != TINYGLTF_MODE_TRIANGLES) {
            return fail(place_ + " is not made of triangles", {}, "triangulate the mesh");
        }
        Expected<void> done = read_material();
        done = done ? read_positions() : done;
        done = done ? read_indices() : done;
        done = done ? read_uvs() : done;
        done = done ? read_normals() : done;
        if (!done) {
            return tl::unexpected(done.error());
        }
        return std::move(made_);
    }

  private:
    [[nodiscard]] Expected<AccessorView> attribute(const std::string& name,
                                                   AccessorRole role) const {
        auto view =
            view_accessor(model_, primitive_.attributes.at(name), role, place_ + " " + name);
        if (view && role != AccessorRole::positions && 3 * view->count != made_.positions.size()) {
            return fail(place_ + " " + name + " has another count than POSITION", {}, kExportAgain);
        }
        return view;
    }

    [[nodiscard]] bool has_attribute(const std::string& name) const {
        return primitive_.attributes.count(name) != 0;
    }

    [[nodiscard]] Expected<void> refuse(const char* why) const {
        return fail(place_ + " " + why, {}, kExportAgain);
    }

    Expected<void> read_material() {
        if (primitive_.material < 0) {
            return {};
        }
        const auto index = static_cast<std::size_t>(primitive_.material);
        if (index >= model_.materials.size()) {
            return refuse("has a material that does not exist");
        }
        const auto& pbr = model_.materials[index].pbrMetallicRoughness;
        for (std::size_t i = 0; i < 4 && i < pbr.baseColorFactor.size(); ++i) {
            made_.base_colour[i] = static_cast<float>(std::clamp(pbr.baseColorFactor[i], 0.0, 1.0));
        }
        made_.roughness = static_cast<float>(std::clamp(pbr.roughnessFactor, 0.0, 1.0));
        const auto texture = static_cast<std::size_t>(pbr.baseColorTexture.index);
        if (pbr.baseColorTexture.index >= 0 && texture < model_.textures.size()) {
            made_.image = model_.textures[texture].source;
            uv_name_ = "TEXCOORD_" + std::to_string(pbr.baseColorTexture.texCoord);
        }
        if (made_.image >= static_cast<int>(model_.images.size())) {
            return refuse("has a picture that does not exist");
        }
        return {};
    }

    Expected<void> read_positions() {
        if (!has_attribute("POSITION")) {
            return refuse("has no POSITION");
        }
        const auto view = attribute("POSITION", AccessorRole::positions);
        if (!view) {
            return tl::unexpected(view.error());
        }
        if (!budget_.charge(view->count * kCorner_bytes)) {
            return fail(kTooMuchMemory, {}, kReduce);
        }
        made_.positions.reserve(3 * view->count);
        const Matrix3 turn_MN = transform_MN_.topLeftCorner<3, 3>();
        const Vector3 origin_M = transform_MN_.topRightCorner<3, 1>();
        for (std::size_t i = 0; i < view->count; ++i) {
            const Vector3 p_M = turn_MN * vector_at(*view, i) + origin_M;
            if (!(p_M.cwiseAbs().maxCoeff() <= kMaxExtent_m) || !p_M.allFinite()) {
                return refuse("has a corner that is not finite or more than 10 km away");
            }
            append(made_.positions, p_M);
        }
        return {};
    }

    Expected<void> read_indices() {
        const std::size_t n_corners = made_.positions.size() / 3;
        const bool indexed = primitive_.indices >= 0;
        AccessorView view;
        if (indexed) {
            auto found = view_accessor(model_, primitive_.indices, AccessorRole::indices,
                                       place_ + " indices");
            if (!found) {
                return tl::unexpected(found.error());
            }
            view = *found;
        }
        const std::size_t n = indexed ? view.count : n_corners;
        if (n % 3 != 0) {
            return refuse("does not have three corners a triangle");
        }
        if (!budget_.charge(n * sizeof(std::uint32_t))) {
            return fail(kTooMuchMemory, {}, kReduce);
        }
        made_.indices.reserve(n);
        for (std::size_t i = 0; i < n; ++i) {
            made_.indices.push_back(indexed ? view.index(i) : static_cast<std::uint32_t>(i));
            if (made_.indices.back() >= n_corners) {
                return refuse("has an index past its corners");
            }
        }
        if (transform_MN_.topLeftCorner<3, 3>().determinant() < 0.0) {
            for (std::size_t i = 0; i < n; i += 3) {
                std::swap(made_.indices[i + 1], made_.indices[i + 2]);
            }
        }
        return {};
    }

    Expected<void> read_uvs() {
        const std::size_t n_corners = made_.positions.size() / 3;
        if (!has_attribute(uv_name_)) {
            made_.uvs.assign(2 * n_corners, 0.0F);
            return {};
        }
        const auto view = attribute(uv_name_, AccessorRole::uvs);
        if (!view) {
            return tl::unexpected(view.error());
        }
        made_.uvs.reserve(2 * n_corners);
        for (std::size_t i = 0; i < 2 * n_corners; ++i) {
            made_.uvs.push_back(view->number(i / 2, i % 2));
            if (!std::isfinite(made_.uvs.back())) {
                return refuse("has a texture coordinate that is not finite");
            }
        }
        return {};
    }

    Expected<void> read_normals() {
        if (!has_attribute("NORMAL")) {
            return make_flat();
        }
        const auto view = attribute("NORMAL", AccessorRole::normals);
        if (!view) {
            return tl::unexpected(view.error());
        }
        const Matrix3 to_M = transform_MN_.topLeftCorner<3, 3>().inverse().transpose();
        made_.normals.reserve(3 * view->count);
        for (std::size_t i = 0; i < view->count; ++i) {
            const Vector3 n_N = vector_at(*view, i);
            if (!n_N.allFinite()) {
                return refuse("has a normal that is not finite");
            }
            const Vector3 n_M = to_M * compute_direction(n_N);
            if (n_N.norm() < kMinNormalLength || !(compute_length(n_M) > 0.0)) {
                return make_flat();
            }
            append(made_.normals, compute_direction(n_M));
        }
        return {};
    }

    /// Section 3.7.2.1: without normals, each triangle is flat.
    Expected<void> make_flat() {
        if (!budget_.charge(made_.indices.size() * kCorner_bytes)) {
            return fail(kTooMuchMemory, {}, kReduce);
        }
        ModelPrimitive flat;
        flat.base_colour = made_.base_colour;
        flat.image = made_.image;
        flat.roughness = made_.roughness;
        for (std::size_t i = 0; i < made_.indices.size(); i += 3) {
            const std::uint32_t* t = made_.indices.data() + i;
            const Vector3 a = corner(made_, t[0]);
            const Vector3 across = (corner(made_, t[1]) - a).cross(corner(made_, t[2]) - a);
            // A triangle without area has no direction; any unit vector keeps the promise.
            const Vector3 n =
                compute_length(across) > 0.0 ? compute_direction(across) : Vector3::UnitY();
            for (int k = 0; k < 3; ++k) {
                flat.indices.push_back(static_cast<std::uint32_t>(flat.positions.size() / 3));
                append(flat.positions, corner(made_, t[k]));
                append(flat.normals, n);
                flat.uvs.push_back(made_.uvs[2 * std::size_t{t[k]}]);
                flat.uvs.push_back(made_.uvs[2 * std::size_t{t[k]} + 1]);
            }
        }
        made_ = std::move(flat);
        return {};
    }

    const tinygltf::Model& model_;
    const tinygltf::Primitive& primitive_;
    const Matrix4& transform_MN_;
    const std::string& place_;
    MemoryBudget& budget_;
    std::string uv_name_ = "TEXCOORD_0";
    ModelPrimitive made_;
};

}  // namespace

Expected<ModelPrimitive> read_primitive(const tinygltf::Model& model,
                                        const tinygltf::Primitive& primitive,
                                        const Matrix4& transform_MN, const std::string& place,
                                        MemoryBudget& budget) {
    return PrimitiveReader(model, primitive, transform_MN, place, budget).read();
}

}  // namespace fulcrum::runtime::gltf
