#include "haptics/loop/texture_stage.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;

HapticPlan make_plan(TextureLaw law) {
    HapticPlan plan;
    plan.solids.resize(2);
    plan.solids[1].surface.texture.source = SineTexture{0.002, 0.0};
    plan.solids[1].surface.texture.law = law;
    plan.solids[1].surface.texture.height_m = 2.0e-4;
    return plan;
}

// The second solid is stroked, d deep, on a body that is turned by `turn`.
struct Stroked {
    explicit Stroked(TextureLaw law, const Pose& pose_W = {})
        : plan(make_plan(law)), motion(plan), stage(plan), poses{Pose{}, pose_W} {}

    SurfaceForce at(double x, double depth_m, const Vector3& moved_W) {
        const Pose& pose_W = poses[1];
        touch = {1, pose_W.orientation * Vector3::UnitY(), depth_m, 500.0};
        const std::span<const TouchForce> touches(&touch, 1);
        motion.step(touches, poses, {pose_W * Vector3(x, 0.0, 0.0), Vector3::Zero(), kDt_s});
        return stage.step(touches, motion, poses, moved_W, kDt_s);
    }

    HapticPlan plan;
    TouchMotion motion;
    TextureStage stage;
    std::array<Pose, 2> poses;
    TouchForce touch{};
};

}  // namespace

TEST_CASE("texture stage: it is there where a solid has a texture") {
    HapticPlan plan;
    plan.solids.resize(2);
    CHECK_FALSE(TextureStage::is_needed(plan));
    CHECK(TextureStage::is_needed(make_plan(TextureLaw::lateral)));
    CHECK(TextureStage(make_plan(TextureLaw::lateral)).memory_bytes() >
          TextureStage(plan).memory_bytes() + sizeof(Texture));
}

TEST_CASE("texture stage: the law in newtons, on a body that is moved and turned") {
    const Pose pose_W{Vector3(1, 2, 3), Quaternion(AngleAxis(0.8, Vector3(1, 1, 0).normalized()))};
    Stroked stroked(TextureLaw::lateral, pose_W);
    for (int i = 0; i < 40; ++i) {
        const double x = 5.0e-6 * i;
        const double slope =
            1.0e-4 * std::numbers::pi * 1000.0 * std::cos(std::numbers::pi * 1000.0 * x);
        const SurfaceForce felt = stroked.at(x, 0.002, Vector3::Zero());
        const Vector3 force_B = pose_W.orientation.conjugate() * felt.force_W;
        CHECK((force_B - Vector3(-500.0 * 0.002 * slope, 0.0, 0.0)).norm() < 1.0e-3);
        CHECK(felt.counted.now_W == felt.force_W);
        CHECK(stroked.stage.height_m(1) ==
              Approx(1.0e-4 * (1.0 + std::sin(std::numbers::pi * 1000.0 * x))).margin(1.0e-8));
        CHECK(stroked.stage.height_m(0) == 0.0);
    }
}

TEST_CASE("texture stage: a solid without a texture feels as it is") {
    Stroked stroked(TextureLaw::lateral);
    const TouchForce plain{0, Vector3::UnitY(), 0.002, 500.0};
    const std::span<const TouchForce> touches(&plain, 1);
    CHECK(stroked.stage.step(touches, stroked.motion, stroked.poses, Vector3::Zero(), kDt_s)
              .force_W == Vector3::Zero());
    CHECK(stroked.stage.step({}, stroked.motion, stroked.poses, Vector3::Zero(), kDt_s).force_W ==
          Vector3::Zero());
}

// Energy that is ideal, of all that is given, on a way to and fro that presses `down` deep one way and `up` the other.
std::pair<double, double> stroke_to_and_fro(TextureLaw law, double down_m, double up_m) {
    Stroked stroked(law);
    double given = 0.0;
    double ideal = 0.0;
    Vector3 before = Vector3::Zero();
    const double step = 1.0e-5;
    double x = 5.0e-4;  // a peak: downhill from here
    bool first = true;
    for (int round = 0; round < 40; ++round) {
        for (int i = 0; i < 100; ++i) {
            const bool out = round % 2 == 0;
            const Vector3 moved(first ? 0.0 : out ? step : -step, 0.0, 0.0);
            x += moved.x();
            const SurfaceForce felt = stroked.at(x, out ? down_m : up_m, moved);
            given += before.dot(moved);
            ideal += 0.5 * (before + felt.counted.held_W).dot(moved);
            before = felt.force_W;
            first = false;
        }
    }
    return {given, ideal};
}

TEST_CASE("texture stage: bumps are ideal, and a hand that pumps is lent two of them at most") {
    const auto [given, ideal] = stroke_to_and_fro(TextureLaw::lateral, 0.002, 0.002);
    CHECK(std::abs(given - ideal) < 1.0e-12);
    const auto [pumped, lent] = stroke_to_and_fro(TextureLaw::lateral, 0.004, 0.001);
    CHECK(pumped > 3.0e-3);
    CHECK(lent <= 2.0 * 500.0 * 0.004 * 2.0e-4 * 1.001);
    // The carved surface gives no more along the way than its normal force takes: there is little to lend.
    const auto [carved, carved_lent] = stroke_to_and_fro(TextureLaw::height_offset, 0.002, 0.002);
    CHECK(std::abs(carved - carved_lent) < 1.0e-12);
}

TEST_CASE("texture stage: solids of one relief share it, and only they") {
    HapticPlan plan;
    plan.solids.resize(3);
    TextureSettings& first = plan.solids[0].surface.texture;
    first.source = NoiseTexture{0.001, 0.004, 1};
    const auto bytes = [&plan](const TextureSettings& second) {
        plan.solids[2].surface.texture = second;
        return TextureStage(plan).memory_bytes();
    };
    CHECK(bytes(first) == bytes({}));
    const auto has_its_own = [&](auto change) {
        TextureSettings other = first;
        change(other);
        return bytes(other) > bytes({});
    };
    CHECK(has_its_own([](TextureSettings& t) { t.height_m *= 2.0; }));
    CHECK(has_its_own([](TextureSettings& t) { t.gain = 0.5; }));
    CHECK(has_its_own([](TextureSettings& t) { t.law = TextureLaw::lateral; }));
    CHECK(has_its_own([](TextureSettings& t) { t.source = NoiseTexture{0.001, 0.004, 2}; }));
    CHECK(has_its_own([](TextureSettings& t) { t.source = NoiseTexture{0.001, 0.005, 1}; }));
    CHECK(has_its_own([](TextureSettings& t) { t.source = NoiseTexture{0.002, 0.004, 1}; }));
    CHECK(has_its_own([](TextureSettings& t) { t.source = SineTexture{}; }));

    first.source = SineTexture{0.002, 0.0};
    CHECK(bytes(first) == bytes({}));
    CHECK(has_its_own([](TextureSettings& t) { t.source = SineTexture{0.002, 1.0}; }));
    CHECK(has_its_own([](TextureSettings& t) { t.source = SineTexture{0.003, 0.0}; }));

    const auto map = std::make_shared<const HeightMap>(HeightMap{2, 1, {0.0F, 1.0F}});
    first.source = ImageTexture{map, 0.04, 0.02};
    CHECK(bytes(first) == bytes({}));
    CHECK(has_its_own([&](TextureSettings& t) { t.source = ImageTexture{map, 0.04, 0.03}; }));
    CHECK(has_its_own([&](TextureSettings& t) { t.source = ImageTexture{map, 0.03, 0.02}; }));
    const auto copy = std::make_shared<const HeightMap>(*map);
    CHECK(has_its_own([&](TextureSettings& t) { t.source = ImageTexture{copy, 0.04, 0.02}; }));
}
