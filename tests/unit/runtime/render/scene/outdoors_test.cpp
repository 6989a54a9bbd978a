// The sky's hills and clouds, and what grows around the cloth.
#include "runtime/render/scene/outdoors.h"

#include "tests/unit/runtime/render/picture_fixture.h"
#include "tests/unit/runtime/rig.h"

#include <numbers>

using namespace fulcrum::runtime::test;
using fulcrum::runtime::kFloatsPerMeadowCorner;
using fulcrum::runtime::kFloatsPerSkyCorner;

namespace {

constexpr fulcrum::runtime::PictureSize kSize{1280, 720, 1.0F};

Camera level_camera(double turn) {
    CameraDescription looks;
    looks.eye_W = Vector3(0.0, 1.0, 0.0);
    looks.target_W = looks.eye_W + Vector3(std::sin(turn), 0.0, -std::cos(turn));
    return {looks, kSize.width_px, kSize.height_px};
}

double horizon_of(const Camera& camera) {
    const Vector3 far = camera.eye_W() + 1e5 * camera.forward_W();
    return 1.0 - 2.0 * camera.project(far)->position_px.y() / kSize.height_px;
}

}  // namespace

TEST_CASE("outdoors: wherever one looks, hills stand on the horizon and clouds above it") {
    for (int i = 0; i < 12; ++i) {
        INFO("turned by " << 30 * i << " degrees");
        const Camera camera = level_camera(i * std::numbers::pi / 6.0);
        const auto corners = runtime::sky_corners(camera, kSize);
        REQUIRE(corners.size() % (3 * kFloatsPerSkyCorner) == 0);
        const double horizon = horizon_of(camera);
        // A degree at the horizon, in half pictures.
        const double degree =
            std::numbers::pi / 180.0 * camera.px_per_m(1.0) / (0.5 * kSize.height_px);
        int soft_below = 0;
        int soft_above = 0;
        double highest_hill = -2.0;
        for (std::size_t at = 0; at < corners.size(); at += kFloatsPerSkyCorner) {
            const double x = static_cast<double>(corners[at]);
            const double y = static_cast<double>(corners[at + 1]);
            const bool is_soft = corners[at + 5] < 0.9F;
            if (is_soft) {
                (y > horizon ? soft_above : soft_below) += 1;
            } else if (std::abs(x) < 0.5) {
                highest_hill = std::max(highest_hill, y);
            }
        }
        CHECK(soft_above > 300);
        CHECK(soft_below == 0);
        CHECK(highest_hill > horizon + 2.0 * degree);
        CHECK(highest_hill < horizon + 8.0 * degree);
    }
}

TEST_CASE("outdoors: hills and clouds turn past as one turns and stay as one walks") {
    const auto ahead = runtime::sky_corners(level_camera(0.0), kSize);
    CHECK(runtime::sky_corners(level_camera(0.2), kSize) != ahead);
    CHECK(runtime::sky_corners(level_camera(0.0), kSize) == ahead);
    CameraDescription walked;
    walked.eye_W = Vector3(0.3, 1.0, -0.2);
    walked.target_W = walked.eye_W - Vector3::UnitZ();
    const auto there = runtime::sky_corners(Camera(walked, kSize.width_px, kSize.height_px), kSize);
    REQUIRE(there.size() == ahead.size());
    for (std::size_t i = 0; i < there.size(); ++i) {
        REQUIRE(there[i] == Approx(ahead[i]).margin(1e-3));  // a pixel, so far away are they
    }
}

TEST_CASE("outdoors: grass grows around the cloth, near and far, and nowhere on it") {
    constexpr double kFrom = 0.7;
    const auto meadow = runtime::make_meadow(kFrom);
    const auto& corners = meadow.corners;
    REQUIRE(corners.size() % (3 * kFloatsPerMeadowCorner) == 0);
    double nearest = 10.0;
    double furthest = 0.0;
    double tallest = 0.0;
    std::array<int, 4> quarters{};
    for (std::size_t at = 0; at < corners.size(); at += kFloatsPerMeadowCorner) {
        const double x = static_cast<double>(corners[at]);
        const double z = static_cast<double>(corners[at + 2]);
        nearest = std::min(nearest, std::hypot(x, z));
        furthest = std::max(furthest, std::hypot(x, z));
        tallest = std::max(tallest, static_cast<double>(corners[at + 1]));
        CHECK(corners[at + 1] >= 0.0F);
        ++quarters.at((x > 0.0 ? 1 : 0) + (z > 0.0 ? 2 : 0));
    }
    // Each has its own corners, one behind the other, the far ones first.
    int next = 0;
    float last_z = -10.0F;
    for (const runtime::Plant& plant : meadow.plants) {
        CHECK(plant.first == next);
        CHECK(plant.foot.z() >= last_z);
        CHECK(std::hypot(plant.foot.x(), plant.foot.z()) > static_cast<float>(kFrom));
        next += plant.count;
        last_z = plant.foot.z();
    }
    CHECK(next == static_cast<int>(corners.size() / kFloatsPerMeadowCorner));
    CHECK(nearest > kFrom - 0.04);  // half a tuft's width
    CHECK(furthest < runtime::kMeadowReach + 0.05);
    CHECK(furthest > 0.9 * runtime::kMeadowReach);
    CHECK(tallest < runtime::kTallestTuft + 1e-6);
    CHECK(tallest > 0.5 * runtime::kTallestTuft);
    const auto [least, most] = std::ranges::minmax(quarters);
    CHECK(least > most * 8 / 10);
    CHECK(runtime::make_meadow(kFrom).corners == corners);
}

TEST_CASE("outdoors: grass before a thing does not hide it") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    // On the meadow, among tufts, looked at along the ground: its lower half is seen as well as its upper.
    runtime::View view = nothing();
    view.camera.eye_W = Vector3(0.0, 0.3, 2.5);
    view.camera.target_W = Vector3(0.0, 0.2, 0.0);
    const Vector3 place(0.0, 0.1, -2.0);
    const Image bare = studio->draw(view);
    view.bodies = {body("red", place)};
    const Image image = studio->draw(view);
    int reds = 0;
    int seen = 0;
    for (double up = -0.07; up < 0.08; up += 0.01) {
        for (double aside = -0.06; aside < 0.065; aside += 0.01) {
            const auto p = pixel_at(image, view, place + Vector3(aside, up, 0.0));
            reds += p[0] > 2 * p[1] ? 1 : 0;
            ++seen;
        }
    }
    CHECK(reds == seen);
    CHECK(changed(bare, image) > 50);
}
