#include "haptics/tool/god_object/god_texture.h"

#include "haptics/math/rotation.h"
#include "haptics/surface/triplanar.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/god_scene.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

using namespace fulcrum;

namespace {

using test::kGodDt_s;
using test::move_to;

constexpr double kStiffness = 500.0;
constexpr double kGap_m = 1.0e-6;
constexpr double kWave_m = 0.004;
constexpr double kHeight_m = 2.0e-4;
constexpr double kPi = std::numbers::pi;
constexpr double kMost_N = 4.0;
constexpr double kTile_m = 0.004;
// A wave of 32 samples and its spline, over the wave's own slope; likewise over its height.
constexpr double kOfSpline = 2.0e-3;
TextureSettings make_grooves(TextureLaw law, double gain = 1.0, double height_m = kHeight_m,
                             double wave_m = kWave_m) {
    return {SineTexture{wave_m, 0.0}, law, height_m, gain};
}

// Tiles with their faces at y = 0, and gaps between them.
TriangleMesh make_tiles(double pitch_m, double side_m) {
    std::vector<PlacedBox> tiles;
    for (int i = -6; i <= 6; ++i) {
        for (int j = -6; j <= 6; ++j) {
            tiles.push_back({{pitch_m * i, -0.005, pitch_m * j}, {side_m, 0.01, side_m}});
        }
    }
    return make_boxes(tiles).value();
}

struct Ground {
    TriangleMesh floor = test::make_ground(0.6);
    FrictionSettings friction{};
};

GodObjectTool make_tool(const TriangleMesh& tool, const TextureSettings* texture,
                        double fade_s = 0.0, const Ground& ground = {}) {
    GodObjectPlan plan{.object = GodSurface::create(ground.floor),
                       .tool = GodSurface::create(tool),
                       .friction = ground.friction};
    if (texture != nullptr) {
        REQUIRE(validate(*texture));
        plan.texture = std::make_shared<const Texture>(*texture);
    }
    GodObjectSettings settings = test::make_god_settings(test::make_still_inertia());
    settings.fade_s = fade_s;
    settings.coupling.clamp_m = kMost_N / settings.coupling.shift.stiffness_N_per_m;
    settings.coupling.clamp_rad = 0.5;
    return GodObjectTool::build({plan}, settings).value();
}

// Put down there and left to come to rest.
ToolFelt press_at(GodObjectTool& tool, const Vector3& handle_W) {
    tool.place(Pose::at(handle_W + Vector3(0.0, 0.02, 0.0)));
    return move_to(tool, Pose::at(handle_W), 80);
}

double height_at(double x) {
    return 0.5 * kHeight_m * (1.0 + std::sin(2.0 * kPi * x / kWave_m));
}
double slope_at(double x) {
    return kPi * kHeight_m / kWave_m * std::cos(2.0 * kPi * x / kWave_m);
}

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

}  // namespace

TEST_CASE("god texture: a tip drawn over grooves feels each law in closed form") {
    const auto law =
        GENERATE(TextureLaw::perturbed_normal, TextureLaw::lateral, TextureLaw::height_offset);
    const double depth_m = GENERATE(0.002, 0.00015);
    const TextureSettings grooves = make_grooves(law);
    GodObjectTool tool = make_tool(test::make_spike(), &grooves);
    const double z = 0.1;
    (void)press_at(tool, {0.01, kGap_m - depth_m, z});
    for (int i = 0; i < 800; ++i) {
        const double x_hand = 0.01 + 1.0e-5 * i;
        const ToolFelt felt = move_to(tool, Pose::at({x_hand, kGap_m - depth_m, z}));
        const double x = tool.centre_W().x();
        const double h = height_at(x);
        const double slope = slope_at(x);
        Vector3 wanted(0.0, depth_m, 0.0);
        if (law == TextureLaw::perturbed_normal) {
            wanted.x() = -std::min(depth_m, h) * slope;
        } else if (law == TextureLaw::lateral) {
            wanted.x() = -depth_m * slope;
        } else {
            const double left_m = std::max(depth_m - (kHeight_m - h), 0.0);
            wanted = left_m * Vector3(-slope, 1.0, 0.0);
        }
        CAPTURE(i, x, depth_m, felt.felt_W.force.transpose());
        CHECK((felt.felt_W.force - kStiffness * wanted).norm() < kOfSpline * kStiffness * depth_m);
        CHECK((felt.texture_W.force - felt.felt_W.force + felt.spring_W.force).norm() < 1.0e-12);
        CHECK(std::abs(felt.spring_W.force.y() - kStiffness * depth_m) < 1.0e-6);
        CHECK(felt.bumps_J > 0.0);
    }
}

TEST_CASE("god texture: a block feels the mean of its corners, and is turned where they differ") {
    const double half_m = GENERATE(0.01, 0.0105, 0.0103, 0.0115);
    const TextureSettings grooves = make_grooves(TextureLaw::lateral);
    const TriangleMesh block = make_box({2.0 * half_m, 0.02, 0.02}).value();
    GodObjectTool tool = make_tool(block, &grooves);
    constexpr double kDepth_m = 0.002;
    const double y = 0.01 + kGap_m - kDepth_m;
    const double z = 0.15;
    (void)press_at(tool, {0.01, y, z});
    const double most = kPi * kHeight_m / kWave_m;
    for (int i = 0; i < 500; ++i) {
        const ToolFelt felt = move_to(tool, Pose::at({0.01 + 1.0e-5 * i, y, z}));
        const double x = tool.centre_W().x();
        const double wanted =
            -most * std::cos(2.0 * kPi * x / kWave_m) * std::cos(2.0 * kPi * half_m / kWave_m);
        CAPTURE(i, half_m, tool.last_step().contacts);
        CHECK(std::abs(felt.felt_W.force.x() / (kStiffness * kDepth_m) - wanted) <
              most * kOfSpline);
        CHECK(std::abs(felt.texture_W.force.y()) < 1.0e-9);
        CHECK(std::abs(felt.texture_W.force.z()) < 1.0e-9);
        // All of it lies in the floor: it turns the block about z alone, by its height over it.
        CHECK(std::abs(felt.texture_W.torque.z() - (0.01) * felt.texture_W.force.x()) < 1.0e-6);
        CHECK(std::abs(felt.texture_W.torque.y()) < 1.0e-6);
    }
}

TEST_CASE("god texture: a block over grooves that turn with its sides is turned about its axis") {
    // Grooves along x whose slope differs between the sides: at z - half and z + half.
    const double half_m = 0.0105;
    TextureSettings grooves = make_grooves(TextureLaw::lateral);
    grooves.source = SineTexture{kWave_m, 0.25 * kPi};
    const TriangleMesh block = make_box({2.0 * half_m, 0.02, 2.0 * half_m}).value();
    GodObjectTool tool = make_tool(block, &grooves);
    constexpr double kDepth_m = 0.002;
    const Vector3 at(0.013, 0.01 + kGap_m - kDepth_m, 0.15);
    const ToolFelt felt = press_at(tool, at);
    Wrench wanted;
    for (const double x : {-half_m, half_m}) {
        for (const double z : {-half_m, half_m}) {
            const double s = (at.x() + x + at.z() + z) / std::sqrt(2.0);
            const Vector3 force = -0.25 * kStiffness * kDepth_m * slope_at(s) *
                                  Vector3(std::sqrt(0.5), 0.0, std::sqrt(0.5));
            add_point_force({x, -0.01, z}, force, wanted);
        }
    }
    const double most_N = kStiffness * kDepth_m * kPi * kHeight_m / kWave_m;
    CHECK((felt.texture_W.force - wanted.force).norm() < 2.0 * kOfSpline * most_N);
    CHECK((felt.texture_W.torque - wanted.torque).norm() < 0.03 * most_N * half_m);
    CHECK(wanted.torque.norm() > 0.1 * most_N * half_m);
}

TEST_CASE(
    "god texture: a level relief is felt as none to the bit, and the way is the same over any") {
    const bool is_level = GENERATE(true, false);
    const FrictionSettings friction = GENERATE(FrictionSettings{}, FrictionSettings{0.5, 0.4, 0.0});
    TextureSettings texture = make_grooves(TextureLaw::perturbed_normal);
    if (is_level) {
        HeightMap map{8, 8, std::vector<float>(64, 0.5F)};
        texture.source =
            ImageTexture{std::make_shared<const HeightMap>(std::move(map)), 0.01, 0.01};
    }
    const TriangleMesh block = make_box({0.02, 0.02, 0.02}).value();
    const Ground ground{make_plate(0.4, 0.4, 12).value(), friction};
    GodObjectTool rough = make_tool(block, &texture, 0.03, ground);
    GodObjectTool plain = make_tool(block, nullptr, 0.03, ground);
    rough.place(Pose::at({0.0, 0.03, 0.0}));
    plain.place(Pose::at({0.0, 0.03, 0.0}));
    double most_N = 0.0;
    for (int i = 0; i < 1500; ++i) {
        const Pose handle{Vector3(0.03 * std::sin(0.004 * i), 0.012 - 0.005 * std::sin(0.01 * i),
                                  0.02 * std::sin(0.003 * i)),
                          compute_exp(Vector3(0.1 * std::sin(0.005 * i), 0.001 * i, 0.05))};
        const ToolFelt a = move_to(rough, handle);
        const ToolFelt b = move_to(plain, handle);
        REQUIRE(rough.pose_W().position == plain.pose_W().position);
        REQUIRE(rough.pose_W().orientation.coeffs() == plain.pose_W().orientation.coeffs());
        REQUIRE(a.spring_W.force == b.felt_W.force);
        REQUIRE(a.spring_W.torque == b.felt_W.torque);
        if (is_level) {
            REQUIRE(a.felt_W.force == b.felt_W.force);
            REQUIRE(a.felt_W.torque == b.felt_W.torque);
        }
        // In free space nothing; the force that fades is the contacts'.
        if (plain.last_step().contacts == 0) {
            REQUIRE(a.texture_W.force.isZero(0.0));
            REQUIRE(a.texture_W.torque.isZero(0.0));
        }
        most_N = std::max(most_N, a.texture_W.force.norm());
    }
    CHECK((most_N > 0.003) == !is_level);
}

TEST_CASE("god texture: a closed way under even pressure gives the hand nothing") {
    const auto law = GENERATE(TextureLaw::perturbed_normal, TextureLaw::lateral);
    const TextureSettings grooves = make_grooves(law);
    const TriangleMesh block = make_box({0.023, 0.02, 0.02}).value();
    GodObjectTool tool = make_tool(block, &grooves);
    constexpr double kDepth_m = 0.002;
    const double y = 0.01 + kGap_m - kDepth_m;
    (void)press_at(tool, {0.01, y, 0.15});
    double work_J = 0.0;
    double size_J = 0.0;
    Vector3 held_W = Vector3::Zero();
    Vector3 at_W(0.01, y, 0.15);
    for (int i = 0; i <= 2000; ++i) {
        const double angle = 2.0 * kPi * i / 2000.0;
        const Vector3 to_W(0.01 + 0.005 * std::sin(angle), y, 0.15 + 0.004 * std::sin(2.0 * angle));
        const ToolFelt felt = move_to(tool, Pose::at(to_W), 40);
        // Half of what was held before and half of what is held now: the work of a force that changes evenly.
        if (i > 0) {
            work_J += 0.5 * (held_W + felt.texture_W.force).dot(to_W - at_W);
            size_J += std::abs(felt.texture_W.force.dot(to_W - at_W));
        }
        held_W = felt.texture_W.force;
        at_W = to_W;
    }
    CHECK(std::abs(work_J) < 1.0e-3 * size_J);
    CHECK(size_J > 1.0e-5);
}

TEST_CASE(
    "god texture: contacts that come and go change the relief's force no faster than it may") {
    const TextureSettings grooves = make_grooves(TextureLaw::lateral, 2.0);
    const double slope = 2.0 * kPi * kHeight_m / kWave_m;
    const double bend_per_m = 2.0 * slope * 2.0 * kPi / kWave_m;  // twice the relief's
    const TriangleMesh block = make_box({0.02, 0.02, 0.03}).value();
    const auto drag = [&](double fade_s) {
        GodObjectTool tool = make_tool(block, &grooves, fade_s, {make_tiles(0.0108, 0.0095), {}});
        tool.place(Pose::at({0.0, 0.012, 0.0}));
        ToolFelt before = move_to(tool, Pose::at({0.0, 0.012, 0.0}));
        Pose at_W = tool.pose_W();
        double worst = 0.0;
        const double reach_m = 0.5 * std::sqrt(0.02 * 0.02 + 0.02 * 0.02 + 0.03 * 0.03);
        for (int i = 0; i < 6000; ++i) {
            const Pose handle{
                Vector3(0.03 * std::sin(0.0002 * i), 0.0085, 0.02 * std::sin(0.00033 * i)),
                compute_exp(Vector3(0.0, 0.2 * std::sin(0.0004 * i), 0.0))};
            const ToolFelt felt = move_to(tool, handle);
            const Vector6 way = find_way(at_W, tool.pose_W());
            const double way_m = way.head<3>().norm() + reach_m * way.tail<3>().norm();
            const double depth_m = felt.spring_W.force.norm() / kStiffness;
            const double was_m = before.spring_W.force.norm() / kStiffness;
            const double most_m = std::max(depth_m, was_m) * slope;
            // The stroke is evened out: it may be that of rounds before.
            const double may_N =
                kStiffness * (most_m * (kGodDt_s / 0.03 + (way_m + 2.0e-6) / reach_m) +
                              std::max(depth_m, was_m) * bend_per_m * (way_m + 2.0e-6) +
                              slope * std::abs(depth_m - was_m));
            // The contacts' own blend takes a while to come; from then on.
            if (i > 100) {
                worst =
                    std::max(worst, (felt.texture_W.force - before.texture_W.force).norm() / may_N);
            }
            before = felt;
            at_W = tool.pose_W();
        }
        return worst;
    };
    CHECK(drag(0.03) < 1.1);
    CHECK(drag(0.0) > 1.5);
}

TEST_CASE(
    "god texture: a relief as steep as settings allow is felt with what may be felt at most") {
    const TextureSettings grooves = make_grooves(TextureLaw::lateral, 100.0, 0.01, 1.0e-4);
    GodObjectTool tool = make_tool(test::make_spike(), &grooves);
    constexpr double kDepth_m = 0.002;
    (void)press_at(tool, {0.01, -kDepth_m, 0.1});
    double felt_N = 0.0;
    for (int i = 0; i < 300; ++i) {
        const ToolFelt felt = move_to(tool, Pose::at({0.01 + 3.0e-6 * i, -kDepth_m, 0.1}));
        REQUIRE(is_finite(felt.felt_W));
        REQUIRE(felt.felt_W.force.norm() <= kMost_N * (1.0 + 1.0e-9));
        felt_N = std::max(felt_N, felt.felt_W.force.norm());
        REQUIRE(std::abs(tool.centre_W().y() - kGap_m) < 1.0e-9);
    }
    CHECK(felt_N > 0.99 * kMost_N);
    // And lifted nothing of it is left.
    CHECK(move_to(tool, Pose::at({0.01, 0.001, 0.1})).felt_W.force.isZero(0.0));
}

TEST_CASE("god texture: what is no number adds nothing; grooves are as steep as samples say") {
    const auto texture =
        std::make_shared<const Texture>(make_grooves(TextureLaw::perturbed_normal));
    GodTexture felt(texture, {.stiffness_N_per_m = kStiffness, .reach_m = 0.02, .fade_s = 0.0});
    felt.begin({}, {}, 1.0);
    felt.add(Vector3::Constant(kNan), Vector3::UnitY(), 0.5);
    felt.add(Vector3::Zero(), Vector3::UnitY(), kNan);
    CHECK(felt.finish(kGodDt_s).force.isZero(0.0));
    felt.begin({}, Pose::at(Vector3::Constant(kNan)), 1.0);
    felt.add(Vector3::Zero(), Vector3::UnitY(), 1.0);
    CHECK(felt.finish(kGodDt_s).force.isZero(0.0));
    CHECK(felt.bumps_J() == 0.0);
    felt.begin({}, {}, kNan);
    felt.add(Vector3::Zero(), Vector3::UnitY(), 1.0);
    CHECK(felt.finish(kGodDt_s).force.isZero(0.0));
    // And what is a number is felt again.
    felt.begin({}, {}, 1.0);
    felt.add(Vector3::Zero(), Vector3::UnitY(), 1.0);
    CHECK(felt.finish(kGodDt_s).force.norm() > 0.005);
    CHECK(felt.bumps_J() == Approx(kStiffness * kHeight_m * kHeight_m));
    const Texture lateral(make_grooves(TextureLaw::lateral));
    const ReliefSteepness seen = find_steepness(lateral.map());
    const double slope = kPi * kHeight_m / kWave_m;
    CHECK(seen.slope >= slope * (1.0 - 1.0e-3));
    CHECK(seen.slope < 1.15 * slope);
    CHECK(seen.curvature_per_m == Approx(slope * 2.0 * kPi / kWave_m).epsilon(0.02));
}

// How steep a relief may be is seen by its samples and half-way between them; felt it is cut at no less.

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
