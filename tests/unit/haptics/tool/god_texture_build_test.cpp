// How steep a relief may be is seen by its samples and half-way between them; felt it is cut at no less.
#include "haptics/surface/triplanar.h"
#include "haptics/tool/god_texture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kTile_m = 0.004;

// Rows of heights, one after the other; turned they are columns.
TextureSettings make_rows(const std::vector<float>& rows, int n_across, bool turned) {
    HeightMap map;
    map.n_u = turned ? static_cast<std::int32_t>(rows.size()) : n_across;
    map.n_v = turned ? n_across : static_cast<std::int32_t>(rows.size());
    for (std::int32_t j = 0; j < map.n_v; ++j) {
        for (std::int32_t i = 0; i < map.n_u; ++i) {
            map.heights.push_back(rows[static_cast<std::size_t>(turned ? i : j)]);
        }
    }
    return {ImageTexture{std::make_shared<const HeightMap>(std::move(map)), kTile_m, kTile_m},
            TextureLaw::lateral, 2.0e-4, 1.0};
}

TEST_CASE("god texture build: no place of a relief is steeper than is told") {
    const auto rows =
        GENERATE(std::vector<float>{0.0F, 1.0F}, std::vector<float>{0.0F, 0.0F, 1.0F, 1.0F},
                 std::vector<float>{0.3F, 0.7F, 0.3F, 0.8F, 1.0F, 0.5F, 0.3F, 0.7F});
    const int n_across = GENERATE(1, 4, 1024);
    const bool turned = GENERATE(false, true);
    const Texture texture(make_rows(rows, n_across, turned));
    const ReliefSteepness told = find_steepness(texture.map());
    constexpr int kFine = 4000;
    double steepest = 0.0;
    for (int i = 0; i < kFine; ++i) {
        const double at_m = kTile_m * i / kFine;
        const HeightSample here = texture.map().sample(0, turned ? at_m : 0.0, turned ? 0.0 : at_m);
        steepest = std::max(steepest, std::hypot(here.slope_u, here.slope_v));
    }
    CAPTURE(rows.size(), n_across, turned);
    CHECK(steepest > 0.01);
    CHECK(told.slope >= steepest);
    CHECK(told.slope < 2.0 * steepest);
}

TEST_CASE("god texture build: rows that go up and down in turn are felt as a point feels them") {
    const auto rows =
        GENERATE(std::vector<float>{0.0F, 1.0F}, std::vector<float>{0.0F, 0.0F, 1.0F, 1.0F});
    const auto texture = std::make_shared<const Texture>(make_rows(rows, 64, false));
    GodTexture felt(texture, {.stiffness_N_per_m = 500.0, .reach_m = 0.02, .fade_s = 0.0});
    constexpr double kForce_N = 1.0;
    double most_N = 0.0;
    for (int i = 0; i < 200; ++i) {
        const Vector3 place(0.001, 0.0, 1.0e-3 * kTile_m * i);
        felt.begin({}, {}, kForce_N);
        felt.add(place, Vector3::UnitY(), kForce_N);
        const Vector3 force = felt.finish(0.001).force;
        const double depth_m = kForce_N / 500.0;
        const BodyOffset offset =
            feel_on_body(*texture, place, Vector3::Zero(), Vector3::UnitY(), depth_m);
        CAPTURE(rows.size(), i);
        CHECK((force - 500.0 * offset.offset_B_m).norm() < 1.0e-12);
        most_N = std::max(most_N, force.norm());
    }
    CHECK(most_N > 0.01);
}

}  // namespace
}  // namespace fulcrum
