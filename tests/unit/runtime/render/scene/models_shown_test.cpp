#include "runtime/render/scene/arrow.h"
#include "runtime/render/scene/kite_models.h"
#include "runtime/render/scene/space.h"
#include "runtime/render/scene/tool_model.h"
#include "runtime/render/theme.h"
#include "runtime/scene/shape_models.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

Camera make_camera() {
    CameraDescription view;
    view.eye_W = {0, 0, 2};
    view.target_W = {0, 0, 0};
    return Camera(view, 640, 480, 0.5);
}

ViewTorque make_torque() {
    ViewTorque torque;
    torque.axis_W = {0.1, 0, 0};
    torque.force = {true, {0.5, 0, 0}, {0, -2, 0}, "2 N"};
    return torque;
}

Vector3f corner_of(const ModelPrimitive& primitive, std::size_t i) {
    return {primitive.positions[3 * i], primitive.positions[3 * i + 1],
            primitive.positions[3 * i + 2]};
}

// Half of the box around it.
Vector3f half_size(const LoadedModel& model) {
    Vector3f most = Vector3f::Zero();
    for (std::size_t i = 0; i < model.primitives[0].positions.size() / 3; ++i) {
        most = most.cwiseMax(corner_of(model.primitives[0], i).cwiseAbs());
    }
    return most;
}

// Each triangle faces as its corners' normals do.
bool faces_outwards(const LoadedModel& model) {
    const ModelPrimitive& primitive = model.primitives[0];
    for (std::size_t t = 0; t + 2 < primitive.indices.size(); t += 3) {
        const Vector3f a = corner_of(primitive, primitive.indices[t]);
        const Vector3f b = corner_of(primitive, primitive.indices[t + 1]);
        const Vector3f c = corner_of(primitive, primitive.indices[t + 2]);
        const Vector3f across = (b - a).cross(c - a);
        if (across.norm() > 1e-9F && across.dot(a + b + c) < -1e-9F) {
            return false;
        }
    }
    return true;
}

const PictureSize kSize{1280, 720, 1.0F};

Camera camera_at(const Vector3& eye_W) {
    CameraDescription description;
    description.eye_W = eye_W;
    description.target_W = Vector3::Zero();
    return {description, kSize.width_px, kSize.height_px};
}

std::size_t n_corners(const std::vector<float>& data) {
    return data.size() / kFloatsPerWallCorner;
}

}  // namespace

TEST_CASE("arrow: a lever arm reaches from the axis to where the force acts") {
    const auto arm = arm_for(make_torque(), make_camera());
    REQUIRE(arm);
    const Vector4f from = arm->world_from_model * Vector4f(0, 0, 0, 1);
    const Vector4f to = arm->world_from_model * Vector4f(0, 1, 0, 1);
    CHECK((from.head<3>() - Vector3f(0.1F, 0, 0)).norm() < 1e-5F);
    CHECK((to.head<3>() - Vector3f(0.5F, 0, 0)).norm() < 1e-5F);
}

TEST_CASE("arrow: a push on the axis itself has no arm, nor what is no number") {
    ViewTorque torque = make_torque();
    torque.axis_W = torque.force.at_W;
    CHECK_FALSE(arm_for(torque, make_camera()));
    torque.axis_W.x() = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(arm_for(torque, make_camera()));
}

TEST_CASE("kite models: each shape has sheets of its size, in two colours, and all its parts") {
    for (const KiteShape shape : kKiteShapes) {
        KiteSettings design;
        design.shape = shape;
        design.height_m = 1.0;
        design.bridle_m = 1.25;
        design.knot_m = 0.85;
        const std::vector<LoadedModel> models = make_kite_models(design);
        std::set<std::string> names;
        for (const LoadedModel& model : models) {
            names.insert(model.name);
            for (const ModelPrimitive& primitive : model.primitives) {
                CHECK(!primitive.indices.empty());
                const auto n = static_cast<std::uint32_t>(primitive.positions.size() / 3);
                CHECK(
                    std::ranges::all_of(primitive.indices, [n](std::uint32_t i) { return i < n; }));
                CHECK(primitive.normals.size() == primitive.positions.size());
            }
        }
        CHECK(names == std::set<std::string>{std::string(kKiteModel), std::string(kLineModel),
                                             std::string(kTailModel), std::string(kWispModel),
                                             std::string(kReelModel)});
        float lowest = 1.0F;
        float highest = 0.0F;
        for (const ModelPrimitive& primitive : models[0].primitives) {
            for (std::size_t i = 1; i < primitive.positions.size(); i += 3) {
                lowest = std::min(lowest, primitive.positions[i]);
                highest = std::max(highest, primitive.positions[i]);
            }
        }
        CHECK(lowest == Approx(0.0F).margin(1e-6));
        CHECK(highest == Approx(1.0F).margin(1e-6));
        CHECK(models[0].primitives[0].base_colour != models[0].primitives[1].base_colour);
    }
}

TEST_CASE("tool model: it is as large as the tool that is felt, and its fronts look outwards") {
    const auto check = [](const CursorShape& shape, const Vector3f& half) {
        const LoadedModel model = make_tool_model(shape);
        REQUIRE(model.primitives.size() == 1);
        CHECK((half_size(model) - half).norm() < 2e-4F);
        CHECK(faces_outwards(model));
        for (const std::uint32_t index : model.primitives[0].indices) {
            REQUIRE(index < model.primitives[0].positions.size() / 3);
        }
        for (const float number : model.primitives[0].normals) {
            REQUIRE(std::isfinite(number));
        }
    };
    check(SphereShape{0.03}, {0.03F, 0.03F, 0.03F});
    check(BoxShape{Vector3(0.01, 0.02, 0.03)}, {0.01F, 0.02F, 0.03F});
    check(CapsuleShape{0.01, 0.04}, {0.01F, 0.05F, 0.01F});
    check(CylinderShape{0.02, 0.05}, {0.02F, 0.05F, 0.02F});
    check(std::monostate{}, {0.01F, 0.01F, 0.01F});
}

TEST_CASE("space: a dark background covers the picture, and stars are spread over all of it") {
    const std::vector<float> data = space_corners(camera_at({0, 0, 2}), {}, kSize);
    REQUIRE(n_corners(data) > 6);
    for (std::size_t i = 0; i < 6; ++i) {
        CHECK(std::abs(data[i * 5]) == 1.0F);
        CHECK(std::abs(data[i * 5 + 1]) == 1.0F);
        CHECK(data[i * 5 + 2] == theme::kSpace.r);
    }
    // Of those in front, some in each quarter.
    int quarters[2][2] = {};
    for (std::size_t i = 6; i < n_corners(data); i += 6) {
        const float x = data[i * 5];
        const float y = data[i * 5 + 1];
        if (std::abs(x) < 1.0F && std::abs(y) < 1.0F) {
            ++quarters[x > 0.0F ? 1 : 0][y > 0.0F ? 1 : 0];
        }
    }
    for (const auto& column : quarters) {
        for (const int n : column) {
            CHECK(n > 3);
        }
    }
}

TEST_CASE("space: stars are far away: a step aside does not move them, a turn does") {
    const auto first = space_corners(camera_at({0, 0, 2}), {}, kSize);
    CameraDescription aside;
    aside.eye_W = Vector3(0.3, 0, 2);
    aside.target_W = Vector3(0.3, 0, 0);
    const auto second = space_corners({aside, kSize.width_px, kSize.height_px}, {}, kSize);
    REQUIRE(first.size() == second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        CHECK(std::abs(first[i] - second[i]) < 1e-3F);
    }
    CHECK(space_corners(camera_at({1, 0, 2}), {}, kSize) != first);
}

TEST_CASE("space: an orbit is a closed line of even width through its circle") {
    const Camera camera = camera_at({0, 0, 3});
    const auto without = space_corners(camera, {}, kSize);
    const Orbit orbit{Vector3::Zero(), 0.5 * Vector3::UnitX(), 0.5 * Vector3::UnitY()};
    const auto with = space_corners(camera, {orbit}, kSize);
    CHECK(n_corners(with) == n_corners(without) + 6UL * kOrbitCorners);
    const double radius_px = 0.5 * camera.px_per_m(3.0);
    const auto middle = camera.project(Vector3::Zero())->position_px;
    for (std::size_t i = n_corners(without); i < n_corners(with); ++i) {
        const double x_px = 0.5 * (with[i * 5] + 1.0) * kSize.width_px - middle.x();
        const double y_px = 0.5 * (1.0 - with[i * 5 + 1]) * kSize.height_px - middle.y();
        CHECK(std::hypot(x_px, y_px) == Approx(radius_px).margin(1.5));
    }
    // What lies behind the eye is left out.
    const Orbit behind{Vector3(0, 0, 9), Vector3::UnitX(), Vector3::UnitY()};
    CHECK(space_corners(camera, {behind}, kSize) == without);
}
