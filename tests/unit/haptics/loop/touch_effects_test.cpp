#include "haptics/device/simulated/human_impedance.h"
#include "haptics/loop/texture_stage.h"
#include "haptics/loop/touch_motion.h"
#include "haptics/loop/transient_stage.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;

HapticPlan make_audible_plan(std::size_t n = 1) {
    HapticPlan plan;
    plan.solids.resize(n);
    plan.solids[0].surface.audible = true;
    return plan;
}

// A floor of solid 0 that is touched, or not.
struct Floor {
    explicit Floor(const HapticPlan& plan) : motion(plan), poses(plan.solids.size()) {}

    void step(const Vector3& proxy_W, const Vector3& velocity_W, bool touched) {
        const TouchForce touch{.solid = 0, .normal_W = normal_W, .depth_m = 0.001};
        motion.step(std::span(&touch, touched ? 1U : 0U), poses, {proxy_W, velocity_W, kDt_s});
    }

    TouchMotion motion;
    std::vector<Pose> poses;
    Vector3 normal_W = Vector3::UnitY();
};

HapticPlan make_texture_plan(TextureLaw law) {
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
        : plan(make_texture_plan(law)), motion(plan), stage(plan), poses{Pose{}, pose_W} {}

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

HapticPlan make_ring_plan(TransientKind kind = TransientKind::decaying_sinusoid) {
    HapticPlan plan;
    plan.solids.resize(2);
    TransientSettings& settings = plan.solids[0].surface.transient;
    settings.kind = kind;
    settings.force_Ns_per_m = 10.0;
    settings.acceleration_per_s = 100.0;
    settings.frequency_Hz = 100.0;
    settings.decay_per_s = 90.0;
    return plan;
}

const TouchForce kFloor{0, Vector3::UnitY(), 0.001, 500.0};
const TouchForce kOther{1, Vector3::UnitY(), 0.001, 500.0};

}  // namespace

TEST_CASE("touch motion: it is there where a solid has a texture or a transient or is heard") {
    const auto is_needed = [](void (*change)(SurfacePlan & surface)) {
        HapticPlan plan;
        plan.solids.resize(2);
        change(plan.solids[1].surface);
        return TouchMotion::is_needed(plan);
    };
    using S = SurfacePlan;
    CHECK_FALSE(is_needed([](S& /*surface*/) {}));
    CHECK(is_needed([](S& surface) { surface.audible = true; }));
    CHECK(is_needed([](S& surface) { surface.texture.source = SineTexture{}; }));
    CHECK(is_needed([](S& surface) { surface.transient.kind = TransientKind::fixed_pulse; }));
    CHECK_FALSE(is_needed([](S& surface) { surface.shading.on = true; }));
}

TEST_CASE("touch motion: a tap is told once, with the speed along the normal") {
    Floor floor(make_audible_plan());
    const Vector3 velocity(0.3, -0.2, 0.0);
    for (int k = 0; k < 10; ++k) {
        floor.step(Vector3(0, 0.01, 0), velocity, false);
        CHECK(floor.motion.tap().solid == kNoBody);
    }
    floor.step(Vector3::Zero(), velocity, true);
    CHECK(floor.motion.tap().solid == 0);
    CHECK(floor.motion.tap().speed_m_per_s == Approx(0.2));
    floor.step(Vector3::Zero(), velocity, true);
    CHECK(floor.motion.tap().solid == kNoBody);
    // Another plane of the same solid is no tap.
    floor.normal_W = -Vector3::UnitX();
    floor.step(Vector3::Zero(), velocity, true);
    CHECK(floor.motion.tap().solid == kNoBody);
}

TEST_CASE("touch motion: a hand laid on, or leaving, does not tap; nor a plate that goes with it") {
    Floor floor(make_audible_plan());
    floor.step(Vector3::Zero(), Vector3(0.5, -0.9 * kSlowestTap_m_per_s, 0.0), true);
    CHECK(floor.motion.tap().solid == kNoBody);
    floor.step(Vector3::Zero(), Vector3(0, -1, 0), false);
    floor.step(Vector3::Zero(), Vector3(0, 1, 0), true);
    CHECK(floor.motion.tap().solid == kNoBody);
    // The plate comes up at 0.3 m/s to a hand that rests, and to one that goes up as fast.
    for (const auto& [hand_m_per_s, speed] : {std::pair{0.0, 0.3}, {0.3, 0.0}}) {
        Floor plate(make_audible_plan());
        for (int k = 0; k < 20; ++k) {
            plate.poses[0].position.y() = 0.3 * kDt_s * k;
            plate.step(Vector3(0, 0.1, 0), Vector3(0, hand_m_per_s, 0), k == 19);
        }
        CHECK(plate.motion.tap().speed_m_per_s == Approx(speed).margin(1.0e-9));
    }
}

TEST_CASE("touch motion: the stroke is the way of the contact on the body, wherever that goes") {
    Floor floor(make_audible_plan());
    // The body moves and turns; the contact goes 0.2 mm a round along its own x.
    for (int k = 0; k < 60; ++k) {
        floor.poses[0] = {Vector3(0.01 * k, 0.0, 0.0),
                          Quaternion(AngleAxis(0.02 * k, Vector3::UnitY()))};
        floor.step(floor.poses[0] * Vector3(2.0e-4 * k, 0.0, 0.003), Vector3::Zero(), true);
    }
    const TouchedPlace& place = floor.motion.place(0);
    CHECK((place.place_B - Vector3(2.0e-4 * 59, 0.0, 0.003)).norm() < 1.0e-12);
    CHECK((place.stroke_B - Vector3(2.0e-4, 0.0, 0.0)).norm() < 1.0e-7);
    CHECK(place.slip_m_per_s == Approx(0.2).epsilon(1.0e-3));
    CHECK(place.view == 1);
    floor.step(Vector3::Zero(), Vector3::Zero(), false);
    CHECK_FALSE(floor.motion.place(0).touched);
}

TEST_CASE(
    "touch motion: it begins with the hand's velocity, at a cursor's skin, and anew after a jump") {
    Floor floor(make_audible_plan());
    floor.step(Vector3::Zero(), Vector3(0.4, -0.1, 0.2), true);
    CHECK((floor.motion.place(0).stroke_B - Vector3(4.0e-4, 0.0, 2.0e-4)).norm() < 1.0e-15);
    // Steps of an encoder are evened out over four rounds.
    floor.step(Vector3(0.004, 0, 0), Vector3::Zero(), true);
    CHECK(floor.motion.place(0).stroke_B.x() == Approx(4.0e-4 + (0.004 - 4.0e-4) / 4.0));
    HapticPlan plan = make_audible_plan();
    plan.proxy.cursor = SphereShape{0.02};
    floor = Floor(plan);
    floor.step(Vector3(0.0, 0.02, 0.0), Vector3::Zero(), true);
    CHECK(floor.motion.place(0).place_B.norm() < 1.0e-15);
    floor = Floor(make_audible_plan());
    floor.step(Vector3::Zero(), Vector3(0, -0.1, 0), true);
    floor.motion.forget();
    CHECK_FALSE(floor.motion.place(0).touched);
    floor.step(Vector3::Zero(), Vector3(0, -0.1, 0), true);
    CHECK(floor.motion.tap().solid == 0);
    CHECK(floor.motion.memory_bytes() > sizeof(TouchMotion));
}

TEST_CASE("texture stage: it is there where a solid has a texture; others feel as they are") {
    HapticPlan plan;
    plan.solids.resize(2);
    CHECK_FALSE(TextureStage::is_needed(plan));
    CHECK(TextureStage::is_needed(make_texture_plan(TextureLaw::lateral)));
    CHECK(TextureStage(make_texture_plan(TextureLaw::lateral)).memory_bytes() >
          TextureStage(plan).memory_bytes() + sizeof(Texture));
    Stroked stroked(TextureLaw::lateral);
    const TouchForce plain{0, Vector3::UnitY(), 0.002, 500.0};
    const std::span<const TouchForce> touches(&plain, 1);
    CHECK(stroked.stage.step(touches, stroked.motion, stroked.poses, Vector3::Zero(), kDt_s)
              .force_W == Vector3::Zero());
    CHECK(stroked.stage.step({}, stroked.motion, stroked.poses, Vector3::Zero(), kDt_s).force_W ==
          Vector3::Zero());
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

TEST_CASE("transient stage: a tap rings along the normal, as strong as it was fast") {
    for (const double speed : {0.05, 0.2}) {
        TransientStage stage(make_ring_plan(), {});
        for (int k = 0; k < 70; ++k) {
            const SurfaceForce felt =
                stage.step({&kFloor, 1}, k == 0 ? Tap{0, speed} : Tap{}, Vector3::Zero(), kDt_s);
            const double t = (k + 0.5) * kDt_s;
            const double force =
                10.0 * speed * std::exp(-90.0 * t) * std::sin(2.0 * std::numbers::pi * 100.0 * t);
            CHECK((felt.force_W - force * Vector3::UnitY()).norm() < 1.0e-9);
            CHECK(felt.counted.now_W == felt.force_W);
        }
    }
}

TEST_CASE("transient stage: none without a tap, in free space, or on a solid that does not ring") {
    TransientStage stage(make_ring_plan(), {});
    CHECK(TransientStage::is_needed(make_ring_plan()));
    CHECK_FALSE(TransientStage::is_needed(make_ring_plan(TransientKind::none)));
    CHECK(stage.step({&kFloor, 1}, {}, Vector3::Zero(), kDt_s).force_W == Vector3::Zero());
    CHECK(stage.step({&kOther, 1}, {1, 0.2}, Vector3::Zero(), kDt_s).force_W == Vector3::Zero());
    CHECK(stage.step({&kFloor, 1}, {0, 0.2}, Vector3::Zero(), kDt_s).force_W.y() > 0.1);
    // Lifted: silent at once, and silent when it is touched again without a tap.
    CHECK(stage.step({}, {}, Vector3::Zero(), kDt_s).force_W == Vector3::Zero());
    CHECK(stage.step({&kFloor, 1}, {}, Vector3::Zero(), kDt_s).force_W == Vector3::Zero());
    (void)stage.step({&kFloor, 1}, {0, 0.2}, Vector3::Zero(), kDt_s);
    stage.forget();
    CHECK(stage.step({&kFloor, 1}, {}, Vector3::Zero(), kDt_s).force_W == Vector3::Zero());
}

TEST_CASE("transient stage: it is lent a share of the tap's energy and no more") {
    HapticPlan plan = make_ring_plan(TransientKind::fixed_pulse);
    plan.solids[0].surface.transient.pulse_s = 0.1;
    DeviceTraits traits;
    traits.mass_kg = 0.094;  // 0.1 kg with the fingers
    TransientStage stage(plan, traits);
    const Vector3 moved(0.0, 1.0e-4, 0.0);
    double ideal = 0.0;
    double given = 0.0;
    Vector3 before = Vector3::Zero();
    for (int k = 0; k < 50; ++k) {
        const SurfaceForce felt =
            stage.step({&kFloor, 1}, k == 0 ? Tap{0, 0.1} : Tap{}, moved, kDt_s);
        ideal += 0.5 * (before + felt.counted.held_W).dot(moved);
        given += before.dot(moved);
        before = felt.force_W;
    }
    CHECK(given == Approx(49 * 1.0 * 1.0e-4));
    CHECK(ideal == Approx(0.5 * 0.5 * 0.1 * 0.1 * 0.1));
}

TEST_CASE("transient stage: the model is the device's mass with fingertips on it") {
    HapticPlan plan = make_ring_plan(TransientKind::acceleration_matching);
    DeviceTraits traits;
    CHECK(make_handle_model(plan, traits).mass_kg ==
          Approx(plan.passivity.handle_mass_kg + kFingertip.mass_kg));
    traits.mass_kg = 0.2;
    traits.damping_Ns_per_m = 0.5;
    const HandleModel model = make_handle_model(plan, traits);
    CHECK(model.mass_kg == Approx(0.2 + kFingertip.mass_kg));
    CHECK(model.damping_Ns_per_m == Approx(0.5 + kFingertip.damping_Ns_per_m));
    CHECK(model.stiffness_N_per_m == kFingertip.stiffness_N_per_m);
    // In a world drawn ten times as large the same hand taps at a tenth of the world's speed.
    plan.workspace.scale = 10.0;
    TransientStage large(plan, traits);
    plan.workspace.scale = 1.0;
    TransientStage same(plan, traits);
    CHECK(large.step({&kFloor, 1}, {0, 1.0}, Vector3::Zero(), kDt_s).force_W ==
          same.step({&kFloor, 1}, {0, 0.1}, Vector3::Zero(), kDt_s).force_W);
}
