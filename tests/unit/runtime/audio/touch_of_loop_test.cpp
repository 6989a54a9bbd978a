// From the haptic loop to the sound: what a hand does on a block, measured in what is heard.
#include "haptics/collision/collision_mesh.h"
#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"
#include "runtime/audio/touch_sound.h"
#include "tests/support/scripted_device.h"
#include "tests/unit/runtime/audio/heard.h"

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::runtime::test;

namespace {

constexpr double kRound_s = 1e-3;
constexpr double kWavelength_m = 0.002;
constexpr double kStroke_m_per_s = 0.1;
constexpr double kRing_Hz = 160.0;
constexpr double kDecay_per_s = 40.0;

HapticPlan grooved_block() {
    HapticPlan plan;
    plan.expects_lesson = false;
    SolidPlan block{0, CollisionMesh::create(make_box(Vector3(0.4, 0.1, 0.2)).value()).value(),
                    Pose{}};
    block.surface.texture.source = SineTexture{kWavelength_m, 0.0};
    block.surface.texture.height_m = 1e-4;
    block.surface.transient = {.kind = TransientKind::decaying_sinusoid,
                               .force_Ns_per_m = 2.0,
                               .frequency_Hz = kRing_Hz,
                               .decay_per_s = kDecay_per_s};
    block.surface.audible = true;
    plan.solids.push_back(std::move(block));
    return plan;
}

/// Where the hand is: over the block, a tap at 0.1 m/s at 1.025 s, a rest, a stroke along x and along z, away.
Vector3 hand_at(double t) {
    if (t < 1.0) {
        return {-0.15, 0.0525, 0.0};
    }
    const double y_m = std::max(0.0525 - 0.1 * (t - 1.0), 0.048);
    const double x_m = -0.15 + kStroke_m_per_s * std::clamp(t - 1.6, 0.0, 1.2);
    const double z_m = kStroke_m_per_s * 0.6 * std::clamp(t - 3.0, 0.0, 1.2);
    return {x_m, y_m, z_m};
}

std::vector<float> hear_loop(HapticPlan plan) {
    ScriptedDevice device;
    auto channels = std::make_unique<HapticChannels>();
    auto ring = std::make_unique<TouchRing>();
    channels->touches = ring.get();
    TouchSound sound(*ring, {tone_of(plan.solids[0].surface.transient)}, kRound_s);
    HapticLoop loop(plan, device, *channels);
    std::vector<float> heard;
    std::vector<float> piece(48);
    for (int round = 1; round <= 4500; ++round) {
        const double now_s = round * kRound_s;
        device.pose_D.position = hand_at(now_s);
        loop.step(now_s);
        sound.render(piece);
        heard.insert(heard.end(), piece.begin(), piece.end());
    }
    return heard;
}

double line_between(Sound sound, double from_s, double to_s, double frequency_Hz) {
    return line(piece(sound, from_s, to_s), frequency_Hz);
}

double find_pitch_Hz(Sound sound, double from_s, double to_s) {
    return strongest_Hz(piece(sound, from_s, to_s), 10.0, 449.0);
}

}  // namespace

TEST_CASE(
    "touch of the loop: a tap on a block rings as its force does, a stroke sings at speed over "
    "wavelength") {
    const auto heard = hear_loop(grooved_block());
    // The tap: nothing before, its tone after, falling at its rate.
    CHECK(line_between(heard, 0.2, 0.9, kRing_Hz) == 0.0);
    CHECK(find_pitch_Hz(heard, 1.06, 1.26) == Approx(kRing_Hz).margin(2.0));
    CHECK(line_between(heard, 1.11, 1.16, kRing_Hz) / line_between(heard, 1.06, 1.11, kRing_Hz) ==
          Approx(std::exp(-kDecay_per_s * 0.05)).epsilon(0.05));
    // Across the grooves at 0.1 m/s: 50 Hz. Along them: hardly a sound.
    CHECK(find_pitch_Hz(heard, 1.9, 2.7) == Approx(kStroke_m_per_s / kWavelength_m).margin(1.0));
    CHECK(line_between(heard, 1.9, 2.7, 50.0) > 0.02);
    CHECK(line_between(heard, 3.3, 4.1, 30.0) < 0.02 * line_between(heard, 1.9, 2.7, 50.0));
}

TEST_CASE("touch of the loop: a block that nobody hears tells nothing") {
    HapticPlan plan = grooved_block();
    plan.solids[0].surface.audible = false;
    CHECK(loudest(hear_loop(plan)) == 0.0F);
}
