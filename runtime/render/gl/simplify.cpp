#include "runtime/render/gl/simplify.h"

#include <algorithm>

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <unordered_map>

namespace fulcrum::runtime::gl {

namespace {

Eigen::Vector3f corner_of(const std::vector<float>& numbers, std::size_t i) {
    return Eigen::Vector3f(numbers.data() + 3 * i);
}

/// Mixes numbers to a key; equal numbers give equal keys.
std::uint64_t mix(std::uint64_t key, std::uint64_t number) {
    key ^= number + 0x9E3779B97F4A7C15ULL + (key << 6U) + (key >> 2U);
    return key * 0xBF58476D1CE4E5B9ULL;
}

std::uint64_t place_key(const Eigen::Vector3f& place) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float number = place[axis] + 0.0F;  // -0 becomes 0
        std::uint32_t bits = 0;
        std::memcpy(&bits, &number, sizeof(bits));
        key = mix(key, bits);
    }
    return key;
}

/// The side of a cube around the origin that a normal goes through, 0 to 5.
std::uint64_t side_of(const Eigen::Vector3f& normal) {
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    return static_cast<std::uint64_t>(2 * axis + (normal[axis] < 0.0F ? 1 : 0));
}

/// For each corner a place that all corners of its cell and side share.
std::vector<std::size_t> shared_places(const ModelPrimitive& primitive, float cell_m) {
    const std::size_t count = primitive.positions.size() / 3;
    const float per_m = 1.0F / cell_m;
    std::unordered_map<std::uint64_t, std::size_t> first_in_cell;
    std::unordered_map<std::uint64_t, std::size_t> first_at_place;
    std::vector<std::size_t> shared(count);
    for (std::size_t i = 0; i < count; ++i) {
        // Corners in the same place follow the first one there, whatever their normals.
        const auto [at_place, is_new] =
            first_at_place.try_emplace(place_key(corner_of(primitive.positions, i)), i);
        if (!is_new) {
            shared[i] = shared[at_place->second];
            continue;
        }
        const Eigen::Vector3f cell = (corner_of(primitive.positions, i) * per_m).array().floor();
        std::uint64_t key = side_of(corner_of(primitive.normals, i));
        for (int axis = 0; axis < 3; ++axis) {
            key = mix(key, static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[axis])));
        }
        shared[i] = first_in_cell.try_emplace(key, i).first->second;
    }
    return shared;
}

}  // namespace

ModelPrimitive simplified(const ModelPrimitive& primitive, float cell_m) {
    const std::vector<std::size_t> shared = shared_places(primitive, cell_m);
    ModelPrimitive result;
    result.base_colour = primitive.base_colour;
    result.image = primitive.image;
    result.roughness = primitive.roughness;

    // A corner keeps its own normal and uv, and takes the place that its cell shares.
    constexpr std::uint32_t kUnused = 0xFFFFFFFFU;
    std::vector<std::uint32_t> renamed(shared.size(), kUnused);
    std::unordered_map<std::uint64_t, std::uint32_t> same_corner;
    const auto keep = [&](std::uint32_t old) {
        if (renamed[old] != kUnused) {
            return renamed[old];
        }
        // Corners of one cell are one corner, unless a crease or a seam runs between them.
        std::uint64_t key = mix(shared[old], side_of(corner_of(primitive.normals, old)));
        if (!primitive.uvs.empty()) {
            constexpr float kUvCells = 8.0F;
            const std::size_t own = 2 * static_cast<std::size_t>(old);
            for (const std::size_t i : {own, own + 1}) {
                key = mix(key, static_cast<std::uint64_t>(static_cast<std::int64_t>(
                                   std::floor(primitive.uvs[i] * kUvCells))));
            }
        }
        const auto next = static_cast<std::uint32_t>(result.positions.size() / 3);
        const auto [found, is_new] = same_corner.try_emplace(key, next);
        if (is_new) {
            for (std::size_t k = 0; k < 3; ++k) {
                result.positions.push_back(primitive.positions[3 * shared[old] + k]);
                result.normals.push_back(primitive.normals[3 * static_cast<std::size_t>(old) + k]);
            }
            for (std::size_t k = 0; k < 2 && !primitive.uvs.empty(); ++k) {
                result.uvs.push_back(primitive.uvs[2 * static_cast<std::size_t>(old) + k]);
            }
        }
        renamed[old] = found->second;
        return found->second;
    };
    for (std::size_t t = 0; t + 2 < primitive.indices.size(); t += 3) {
        const std::uint32_t a = primitive.indices[t];
        const std::uint32_t b = primitive.indices[t + 1];
        const std::uint32_t c = primitive.indices[t + 2];
        if (shared[a] != shared[b] && shared[b] != shared[c] && shared[c] != shared[a]) {
            for (const std::uint32_t corner : {a, b, c}) {
                result.indices.push_back(keep(corner));
            }
        }
    }
    return result;
}

bool is_closed(const ModelPrimitive& primitive) {
    // Corners in one place are one corner here.
    const std::size_t count = primitive.positions.size() / 3;
    std::unordered_map<std::uint64_t, std::uint32_t> first_at_place;
    std::vector<std::uint32_t> name(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        name[i] = first_at_place.try_emplace(place_key(corner_of(primitive.positions, i)), i)
                      .first->second;
    }
    std::unordered_map<std::uint64_t, int> runs;  // forth less back, along each edge
    double six_volumes = 0.0;
    for (std::size_t t = 0; t + 2 < primitive.indices.size(); t += 3) {
        const std::array<std::uint32_t, 3> corners{name[primitive.indices[t]],
                                                   name[primitive.indices[t + 1]],
                                                   name[primitive.indices[t + 2]]};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t from = corners[k];
            const std::uint64_t to = corners[(k + 1) % 3];
            runs[(std::min(from, to) << 32U) | std::max(from, to)] += from < to ? 1 : -1;
        }
        const Eigen::Vector3d a = corner_of(primitive.positions, corners[0]).cast<double>();
        const Eigen::Vector3d b = corner_of(primitive.positions, corners[1]).cast<double>();
        const Eigen::Vector3d c = corner_of(primitive.positions, corners[2]).cast<double>();
        six_volumes += a.dot(b.cross(c));
    }
    return six_volumes > 0.0 &&
           std::all_of(runs.begin(), runs.end(), [](const auto& edge) { return edge.second == 0; });
}

}  // namespace fulcrum::runtime::gl
