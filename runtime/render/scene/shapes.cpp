#include "runtime/render/scene/shapes.h"

#include "haptics/math/matrix.h"

#include <cmath>
#include <numbers>

namespace fulcrum::runtime {

namespace {

constexpr int kAround = 40;              // corners around the axis
constexpr float kCreaseCosine = 0.866F;  // 30 degrees
using Profile = std::vector<std::array<float, 2>>;

/// The outward direction of a piece of the profile, in the plane of radius and height.
Vector2f outwards(const std::array<float, 2>& from, const std::array<float, 2>& to) {
    const Vector2f way(to[0] - from[0], to[1] - from[1]);
    const float length = way.norm();
    return length > 0.0F ? Vector2f(way.y() / length, -way.x() / length) : Vector2f(1.0F, 0.0F);
}

/// One ring of corners, all with the same slope of normal.
void add_ring(ModelPrimitive& primitive, const std::array<float, 2>& point, const Vector2f& slope) {
    for (int i = 0; i <= kAround; ++i) {
        // The last corner lies exactly on the first, so that the surface closes.
        const float turn =
            2.0F * std::numbers::pi_v<float> * static_cast<float>(i % kAround) / kAround;
        const float c = std::cos(turn);
        const float s = std::sin(turn);
        primitive.positions.insert(primitive.positions.end(),
                                   {point[0] * c, point[1], point[0] * s});
        primitive.normals.insert(primitive.normals.end(),
                                 {slope.x() * c, slope.y(), slope.x() * s});
        primitive.uvs.insert(primitive.uvs.end(), {static_cast<float>(i) / kAround, point[1]});
    }
}

/// Triangles between two rings that begin at corners `low` and `high`.
void join_rings(ModelPrimitive& primitive, std::uint32_t low, std::uint32_t high) {
    for (std::uint32_t i = 0; i < kAround; ++i) {
        for (const std::uint32_t corner :
             {low + i, high + i, low + i + 1, low + i + 1, high + i, high + i + 1}) {
            primitive.indices.push_back(corner);
        }
    }
}

}  // namespace

LoadedModel make_lathe(const Profile& profile, std::array<float, 4> colour) {
    LoadedModel model;
    model.primitives.emplace_back();
    ModelPrimitive& primitive = model.primitives.back();
    primitive.base_colour = colour;
    primitive.roughness = 0.5F;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        const Vector2f own = outwards(profile[i], profile[i + 1]);
        // A neighbour that bends gently shares the normal.
        const auto blended = [&](const Vector2f& other) -> Vector2f {
            return own.dot(other) > kCreaseCosine ? Vector2f((own + other).normalized()) : own;
        };
        const Vector2f below = i > 0 ? blended(outwards(profile[i - 1], profile[i])) : own;
        const Vector2f above =
            i + 2 < profile.size() ? blended(outwards(profile[i + 1], profile[i + 2])) : own;
        const auto low = static_cast<std::uint32_t>(primitive.positions.size() / 3);
        add_ring(primitive, profile[i], below);
        add_ring(primitive, profile[i + 1], above);
        join_rings(primitive, low, low + kAround + 1);
    }
    return model;
}

LoadedModel make_ball(float radius_m, std::array<float, 4> colour) {
    constexpr int kUp = 24;
    Profile profile;
    for (int i = 0; i <= kUp; ++i) {
        const float turn = std::numbers::pi_v<float> * (static_cast<float>(i) / kUp - 0.5F);
        const bool pole = i == 0 || i == kUp;
        profile.push_back({pole ? 0.0F : radius_m * std::cos(turn), radius_m * std::sin(turn)});
    }
    return make_lathe(profile, colour);
}

LoadedModel make_arrow_shaft(std::array<float, 4> colour) {
    Profile profile;
    constexpr int kRound = 8;
    // The round end is flat here: the shaft is stretched along y.
    for (int i = 0; i <= kRound; ++i) {
        const float turn = 0.5F * std::numbers::pi_v<float> * static_cast<float>(i) / kRound;
        profile.push_back({std::sin(turn), 0.06F * (1.0F - std::cos(turn))});
    }
    profile.push_back({1.0F, 1.0F});
    return make_lathe(profile, colour);
}

LoadedModel make_arrow_head(std::array<float, 4> colour) {
    // A flat base, round at its edge, straight sides and a blunt tip.
    Profile profile{{0.0F, 0.0F}};
    constexpr float kEdge = 0.08F;
    constexpr float kTip = 0.10F;
    constexpr int kRound = 10;
    const auto add_arc = [&](float radius, float middle_r, float middle_y, float from, float to) {
        for (int i = 0; i <= kRound; ++i) {
            const float turn =
                std::numbers::pi_v<float> * (from + (to - from) * static_cast<float>(i) / kRound);
            profile.push_back(
                {middle_r + radius * std::cos(turn), middle_y + radius * std::sin(turn)});
        }
    };
    add_arc(kEdge, 1.0F - kEdge, kEdge, -0.5F, 0.2F);
    add_arc(kTip, 0.0F, 1.0F - kTip, 0.22F, 0.5F);
    return make_lathe(profile, colour);
}

}  // namespace fulcrum::runtime
