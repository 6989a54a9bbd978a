#include "runtime/render/scene/tool_model.h"

#include "runtime/render/scene/shapes.h"
#include "runtime/render/theme.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace fulcrum::runtime {
namespace {

using Outline = std::vector<std::array<float, 2>>;

// Linear.
std::array<float, 4> light_of(const Colour& colour) {
    return {to_linear(colour.r), to_linear(colour.g), to_linear(colour.b), 1.0F};
}
constexpr float kBevel = 0.06F;  // of a cylinder's radius: a rim that catches the light
constexpr int kArc = 12;

// A quarter of a circle in the plane of radius and height, from an angle to the next quarter.
void add_quarter(Outline& profile, float middle_r, float middle_y, float radius, float from) {
    for (int i = 0; i <= kArc; ++i) {
        const float turn = 0.5F * std::numbers::pi_v<float> * (from + static_cast<float>(i) / kArc);
        const bool is_pole = middle_r == 0.0F && std::abs(std::cos(turn)) < 1.0e-6F;
        profile.push_back({is_pole ? 0.0F : middle_r + radius * std::cos(turn),
                           middle_y + radius * std::sin(turn)});
    }
}

LoadedModel make_cylinder_model(float radius, float half_height) {
    const float bevel = kBevel * std::min(radius, half_height);
    Outline profile{{0.0F, -half_height}};
    add_quarter(profile, radius - bevel, bevel - half_height, bevel, -1.0F);
    add_quarter(profile, radius - bevel, half_height - bevel, bevel, 0.0F);
    profile.push_back({0.0F, half_height});
    return make_lathe(profile, light_of(theme::kHand));
}

LoadedModel make_capsule_model(float radius, float half_length) {
    Outline profile;
    add_quarter(profile, 0.0F, -half_length, radius, -1.0F);
    add_quarter(profile, 0.0F, half_length, radius, 0.0F);
    return make_lathe(profile, light_of(theme::kHand));
}

// Six faces of four corners each.
LoadedModel make_box_model(const Vector3& half_size_m) {
    LoadedModel model;
    model.primitives.emplace_back();
    ModelPrimitive& primitive = model.primitives.back();
    primitive.base_colour = light_of(theme::kHand);
    primitive.roughness = 0.5F;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const auto first = static_cast<std::uint32_t>(primitive.positions.size() / 3);
            for (const auto& [a, b] :
                 {std::array{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
                Vector3 corner;
                corner[axis] = side;
                corner[(axis + 1) % 3] = side * a;  // counter-clockwise from outside on both
                corner[(axis + 2) % 3] = b;
                Vector3 normal = Vector3::Zero();
                normal[axis] = side;
                for (int i = 0; i < 3; ++i) {
                    primitive.positions.push_back(static_cast<float>(corner[i] * half_size_m[i]));
                    primitive.normals.push_back(static_cast<float>(normal[i]));
                }
                primitive.uvs.insert(primitive.uvs.end(), {0.0F, 0.0F});
            }
            for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) {
                primitive.indices.push_back(first + corner);
            }
        }
    }
    return model;
}

struct MakeModel {
    LoadedModel operator()(const SphereShape& ball) const {
        return make_ball(static_cast<float>(ball.radius_m), light_of(theme::kHand));
    }
    LoadedModel operator()(const BoxShape& box) const { return make_box_model(box.half_size_m); }
    LoadedModel operator()(const CapsuleShape& capsule) const {
        return make_capsule_model(static_cast<float>(capsule.radius_m),
                                  static_cast<float>(capsule.half_length_m));
    }
    LoadedModel operator()(const CylinderShape& cylinder) const {
        return make_cylinder_model(static_cast<float>(cylinder.radius_m),
                                   static_cast<float>(cylinder.half_height_m));
    }
    template <class Other>
    LoadedModel operator()(const Other& /*shape*/) const {
        return make_ball(0.01F, light_of(theme::kHand));
    }
};

}  // namespace

LoadedModel make_tool_model(const CursorShape& shape) {
    return std::visit(MakeModel{}, shape);
}

LoadedModel make_second_tool_model(const CursorShape& shape) {
    LoadedModel model = make_tool_model(shape);
    for (ModelPrimitive& primitive : model.primitives) {
        primitive.base_colour = light_of(theme::kBlue);
    }
    return model;
}

}  // namespace fulcrum::runtime
