#include "runtime/render/gl/simplify.h"

#include "haptics/math/matrix.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <unordered_map>

namespace fulcrum::runtime::gl {

namespace {

Vector3f corner_of(const std::vector<float>& numbers, std::size_t i) {
    return Vector3f(numbers.data() + 3 * i);
}

/// Whether two corners face nearly the same way.
bool alike(const std::vector<float>& normals, std::size_t i, std::size_t j) {
    constexpr float kAlike = 0.80F;  // cosine of 37 degrees
    return corner_of(normals, i).dot(corner_of(normals, j)) > kAlike;
}

/// Mixes numbers to a key; equal numbers give equal keys.
std::uint64_t mix(std::uint64_t key, std::uint64_t number) {
    key ^= number + 0x9E3779B97F4A7C15ULL + (key << 6U) + (key >> 2U);
    return key * 0xBF58476D1CE4E5B9ULL;
}

std::uint64_t place_key(const Vector3f& place) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float number = place[axis] + 0.0F;  // -0 becomes 0
        std::uint32_t bits = 0;
        std::memcpy(&bits, &number, sizeof(bits));
        key = mix(key, bits);
    }
    return key;
}

/// For each corner one that stands for it: near by, facing the same way; the same for all corners
/// in one place.
std::vector<std::size_t> stand_ins(const ModelPrimitive& primitive, float cell_m) {
    const std::size_t count = primitive.positions.size() / 3;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> chosen_in_cell;
    std::unordered_map<std::uint64_t, std::size_t> first_at_place;
    std::vector<std::size_t> stand_in(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Vector3f place = corner_of(primitive.positions, i);
        const auto [at_place, is_new] = first_at_place.try_emplace(place_key(place), i);
        if (!is_new) {
            stand_in[i] = stand_in[at_place->second];
            continue;
        }
        const Vector3f cell = (place / cell_m).cwiseFloor();
        std::uint64_t key = 0;
        for (int axis = 0; axis < 3; ++axis) {
            key = mix(key, static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[axis])));
        }
        std::vector<std::size_t>& chosen = chosen_in_cell[key];
        const auto found = std::find_if(chosen.begin(), chosen.end(), [&](std::size_t other) {
            return alike(primitive.normals, i, other);
        });
        stand_in[i] = found != chosen.end() ? *found : i;
        if (found == chosen.end()) {
            chosen.push_back(i);
        }
    }
    return stand_in;
}

/// Writes the corners of the simplified primitive as triangles ask for them.
class CornerWriter {
  public:
    CornerWriter(const ModelPrimitive& from, ModelPrimitive& to) : from_(from), to_(to) {}

    /// The new name of a corner that moves to where its stand-in is. It looks like the stand-in
    /// there, unless a crease or a seam of the picture runs between them.
    std::uint32_t write(std::size_t old, std::size_t stand_in) {
        const bool same_look =
            alike(from_.normals, old, stand_in) && near_in_picture(old, stand_in);
        const std::size_t look = same_look ? stand_in : old;
        const std::uint64_t key = same_look ? mix(stand_in, 0) : mix(mix(stand_in, 1), old);
        const auto next = static_cast<std::uint32_t>(to_.positions.size() / 3);
        const auto [found, is_new] = written_.try_emplace(key, next);
        if (is_new) {
            copy(from_.positions, to_.positions, 3, stand_in);
            copy(from_.normals, to_.normals, 3, look);
            copy(from_.uvs, to_.uvs, 2, look);
        }
        return found->second;
    }

  private:
    /// Whether two corners lie close together in the picture.
    [[nodiscard]] bool near_in_picture(std::size_t i, std::size_t j) const {
        constexpr float kNear = 0.25F;  // of the picture's side; a seam is nearly all of it
        return from_.uvs.empty() || (std::abs(from_.uvs[2 * i] - from_.uvs[2 * j]) < kNear &&
                                     std::abs(from_.uvs[2 * i + 1] - from_.uvs[2 * j + 1]) < kNear);
    }
    static void copy(const std::vector<float>& from, std::vector<float>& to, std::size_t width,
                     std::size_t i) {
        if (!from.empty()) {
            to.insert(to.end(), from.begin() + static_cast<long>(width * i),
                      from.begin() + static_cast<long>(width * (i + 1)));
        }
    }

    const ModelPrimitive& from_;
    ModelPrimitive& to_;
    std::unordered_map<std::uint64_t, std::uint32_t> written_;
};

}  // namespace

ModelPrimitive simplified(const ModelPrimitive& primitive, float cell_m) {
    const std::vector<std::size_t> stand_in = stand_ins(primitive, cell_m);
    ModelPrimitive result;
    result.base_colour = primitive.base_colour;
    result.image = primitive.image;
    result.roughness = primitive.roughness;
    CornerWriter writer(primitive, result);
    for (std::size_t t = 0; t + 2 < primitive.indices.size(); t += 3) {
        const std::size_t a = primitive.indices[t];
        const std::size_t b = primitive.indices[t + 1];
        const std::size_t c = primitive.indices[t + 2];
        if (stand_in[a] != stand_in[b] && stand_in[b] != stand_in[c] &&
            stand_in[c] != stand_in[a]) {
            for (const std::size_t corner : {a, b, c}) {
                result.indices.push_back(writer.write(corner, stand_in[corner]));
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
            if (from == to) {
                continue;  // a triangle that is only a line, as at a pole
            }
            runs[(std::min(from, to) << 32U) | std::max(from, to)] += from < to ? 1 : -1;
        }
        const Vector3 a = corner_of(primitive.positions, corners[0]).cast<double>();
        const Vector3 b = corner_of(primitive.positions, corners[1]).cast<double>();
        const Vector3 c = corner_of(primitive.positions, corners[2]).cast<double>();
        six_volumes += a.dot(b.cross(c));
    }
    return six_volumes > 0.0 &&
           std::all_of(runs.begin(), runs.end(), [](const auto& edge) { return edge.second == 0; });
}

}  // namespace fulcrum::runtime::gl
