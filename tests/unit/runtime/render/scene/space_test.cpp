#include "runtime/render/scene/space.h"

#include "runtime/render/theme.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

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
