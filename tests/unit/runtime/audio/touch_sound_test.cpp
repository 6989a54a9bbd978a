#include "runtime/audio/touch_sound.h"

#include "haptics/collision/collision_mesh.h"
#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/support/scripted_device.h"
#include "tests/unit/runtime/audio/heard.h"
#include "tests/unit/runtime/audio/stroked.h"
#include "tests/unit/runtime/rig.h"

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

constexpr double kPi = std::numbers::pi;
constexpr double kForce_N = 2.0;
constexpr double kPressed = kForce_N / (kForce_N + 0.5);  // n(F)
constexpr double kStrokeGain_s_per_m = 8.0;
constexpr std::size_t kPiece = kFrame;
constexpr std::size_t kShortPiece = 128;  // those of a sound card

/// A hand that strokes a relief of one wavelength, as the haptic loop tells it, and a tap at the beginning of the touch.
struct Stroke {
    double speed_m_per_s = 0.2;
    double wavelength_m = 0.002;
    double amplitude_m = 2e-5;
    double impact_m_per_s = 0.0;
    double from_s = 0.1;
    double until_s = 1.6;
};

/// What is heard of `seconds` of it, rendered in pieces as rounds come in.
std::vector<float> hear(const Stroke& stroke, double seconds, TapTone tone = {},
                        const std::function<void(TouchSample&)>& change = {},
                        std::size_t piece_samples = kPiece) {
    auto ring = std::make_unique<TouchRing>();
    TouchSound sound(*ring, {tone}, kRound_s);
    std::vector<float> heard(static_cast<std::size_t>(seconds * kSampleRate_Hz));
    int round = 0;
    for (std::size_t at = 0; at + piece_samples <= heard.size(); at += piece_samples) {
        const double now_s = static_cast<double>(at + piece_samples) / kSampleRate_Hz;
        for (; round * kRound_s < now_s; ++round) {
            const double t = round * kRound_s;
            if (t < stroke.from_s || t > stroke.until_s + 0.5 * kRound_s) {
                continue;
            }
            TouchSample sample;
            sample.time_s = t;
            sample.solid = 0;
            sample.normal_force_N = static_cast<float>(kForce_N);
            const double way_m = stroke.speed_m_per_s * (t - stroke.from_s);
            sample.texture_height_m = static_cast<float>(
                stroke.amplitude_m * (1.0 + std::sin(2.0 * kPi * way_m / stroke.wavelength_m)));
            sample.impact_speed_m_per_s = static_cast<float>(
                t < stroke.from_s + 0.5 * kRound_s ? stroke.impact_m_per_s : 0.0);
            if (change) {
                change(sample);
            }
            (void)ring->push(sample);
        }
        sound.render(std::span(heard).subspan(at, piece_samples));
    }
    return heard;
}

}  // namespace

TEST_CASE("touch of the loop: a tap rings as its force does, a stroke at speed over wavelength") {
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

TEST_CASE("touch sound: a stroke is a line at speed over wavelength, loud as the relief varies") {
    for (const double speed_m_per_s : {0.05, 0.1, 0.2, 0.4}) {
        CAPTURE(speed_m_per_s);
        Stroke stroke;
        stroke.speed_m_per_s = speed_m_per_s;
        const double wanted_Hz = speed_m_per_s / stroke.wavelength_m;
        const auto heard = hear(stroke, 1.5);
        const auto steady = piece(heard, 0.4, 1.4);
        CHECK(strongest_Hz(steady, 10.0, 600.0) == Approx(wanted_Hz).margin(1.0));
        // s = G n(F) dh/dt; the cubic's slope falls short of the sine's by what it cannot know above a quarter of the rounds.
        const double slope_m_per_s = stroke.amplitude_m * 2.0 * kPi * wanted_Hz;
        const double level = kStrokeGain_s_per_m * kPressed * slope_m_per_s;
        CHECK(line(steady, wanted_Hz) == Approx(level / std::sqrt(1.0 + 0.7 * level * level))
                                             .epsilon(wanted_Hz < 120.0 ? 0.03 : 0.15));
        CHECK(line(steady, 1.5 * wanted_Hz) < 0.01 * line(steady, wanted_Hz));
    }
}

TEST_CASE("touch sound: what is smooth, not touched, or not moved makes no sound") {
    Stroke smooth;
    smooth.amplitude_m = 0.0;
    CHECK(loudest(hear(smooth, 1.5)) == 0.0F);
    Stroke still;
    still.speed_m_per_s = 0.0;
    CHECK(loudest(hear(still, 1.5)) < 1e-6F);
    CHECK(loudest(hear({}, 1.5, {}, [](TouchSample& s) { s.solid = kNoBody; })) == 0.0F);
    CHECK(loudest(hear({}, 1.5, {}, [](TouchSample& s) { s.normal_force_N = 0.0F; })) == 0.0F);
    // A touch that begins on a peak does not click.
    Stroke short_one;
    short_one.until_s = 0.3;
    const auto heard = hear(short_one, 1.0);
    CHECK(loudest(piece(heard, 0.1, 0.4)) > 0.01F);
    CHECK(loudest(piece(heard, 0.5, 0.9)) == 0.0F);
}

TEST_CASE("touch sound: coming down on a peak and leaving it is no slope of the relief") {
    Stroke still;
    still.speed_m_per_s = 0.0;
    still.amplitude_m = 1e-3;
    // Nothing is touched up to 0.5 s, and nothing from 1 s on; in between the hand rests on a height of a millimetre.
    const auto heard = hear(still, 1.5, {}, [](TouchSample& s) {
        if (s.time_s < 0.5 || s.time_s > 1.0) {
            s.solid = kNoBody;
            s.texture_height_m = 0.0F;
        }
    });
    CHECK(loudest(heard) == 0.0F);
}

TEST_CASE("touch sound: a relief of a mountain is as loud as there is, and no louder") {
    Stroke rough;
    rough.amplitude_m = 2e-3;
    const float most = loudest(hear(rough, 1.0));
    CHECK(most > 0.95F);
    CHECK(most < 1.0F);
}

TEST_CASE("touch sound: a tap rings at its frequency, dies away at its rate, loud as it was fast") {
    Stroke tap;
    tap.amplitude_m = 0.0;
    tap.impact_m_per_s = 0.05;
    const TapTone tone{320.0, 40.0};
    const auto heard = hear(tap, 1.0, tone);
    const double begins_s = 0.1 + touch_delay_s(kPiece);
    CHECK(loudest(piece(heard, 0.0, begins_s - 0.011)) == 0.0F);
    CHECK(strongest_Hz(piece(heard, begins_s, begins_s + 0.2), 50.0, 1000.0) ==
          Approx(320.0).margin(1.0));
    // Two pieces of the same length, 50 ms apart: the envelope has fallen by exp(-40 * 0.05).
    const double early = line(piece(heard, begins_s + 0.01, begins_s + 0.06), 320.0);
    const double late = line(piece(heard, begins_s + 0.06, begins_s + 0.11), 320.0);
    CHECK(late / early == Approx(std::exp(-2.0)).epsilon(0.02));
    Stroke softer = tap;
    softer.impact_m_per_s = 0.025;
    const auto half = hear(softer, 1.0, tone);
    CHECK(line(piece(half, begins_s + 0.01, begins_s + 0.06), 320.0) ==
          Approx(0.5 * early).epsilon(0.02));
    CHECK(loudest(hear(tap, 1.0, TapTone{})) == 0.0F);  // this solid is not heard
    // A sledgehammer is limited.
    Stroke hammer = tap;
    hammer.impact_m_per_s = 100.0;
    CHECK(loudest(hear(hammer, 1.0, tone)) < 0.9F);
}

TEST_CASE("touch sound: in a sound card's pieces it runs less than 9 ms behind, the same line") {
    CHECK(touch_delay_s(kShortPiece) < 0.009);
    Stroke tap;
    tap.amplitude_m = 0.0;
    tap.impact_m_per_s = 0.2;
    const auto rung = hear(tap, 0.5, {320.0, 40.0}, {}, kShortPiece);
    CHECK(loudest(piece(rung, 0.0, 0.1)) == 0.0F);
    CHECK(loudest(piece(rung, 0.1, 0.109)) > 0.3F);
    const Stroke stroke;
    const auto steady = hear(stroke, 1.5, {}, {}, kShortPiece);
    const auto coarse = hear(stroke, 1.5);
    CHECK(line(piece(steady, 0.4, 1.4), 100.0) ==
          Approx(line(piece(coarse, 0.4, 1.4), 100.0)).epsilon(1e-3));
}

TEST_CASE("touch sound: sound that has overtaken touch steps back behind it") {
    // A queue of 16 ms is filled at once while the surface is already stroked: sound is ahead of what was felt.
    auto ring = std::make_unique<TouchRing>();
    TouchSound sound(*ring, {TapTone{}}, kRound_s);
    std::vector<float> heard(kShortPiece);
    int round = 0;
    const auto feel_until = [&](double now_s) {
        for (; round * kRound_s < now_s; ++round) {
            (void)ring->push(make_stroked(round * kRound_s));
        }
    };
    feel_until(0.02);
    for (int i = 0; i < 6; ++i) {
        sound.render(heard);
    }
    float most = 0.0F;
    for (int i = 1; i <= 20; ++i) {
        feel_until(0.02 + static_cast<double>(i * kShortPiece) / kSampleRate_Hz);
        sound.render(heard);
        most = std::max(most, loudest(heard));
    }
    CHECK(most > 0.05F);
}

TEST_CASE("touch sound: the tone of a tap is its force's") {
    TransientSettings transient;
    CHECK(tone_of(transient).frequency_Hz == 0.0);
    transient.kind = TransientKind::decaying_sinusoid;
    transient.frequency_Hz = 250.0;
    transient.decay_per_s = 70.0;
    CHECK(tone_of(transient).frequency_Hz == 250.0);
    CHECK(tone_of(transient).decay_per_s == 70.0);
    transient.kind = TransientKind::fixed_pulse;
    transient.pulse_s = 0.01;
    CHECK(tone_of(transient).frequency_Hz == Approx(50.0));
}

TEST_CASE("touch sound: the same touches are the same samples; stamps of no time change nothing") {
    Stroke stroke;
    stroke.impact_m_per_s = 0.1;
    const TapTone tone{200.0, 60.0};
    CHECK(hear(stroke, 0.8, tone) == hear(stroke, 0.8, tone));
    int n = 0;
    const auto with_nonsense = hear(stroke, 0.8, tone, [&n](TouchSample& s) {
        if (++n == 100) {
            s.time_s = std::nan("");
        }
    });
    CHECK(std::ranges::all_of(with_nonsense, [](float x) { return std::isfinite(x); }));
}

TEST_CASE("touch sound: the next touch after a long rest is heard in time") {
    auto ring = std::make_unique<TouchRing>();
    TouchSound sound(*ring, {{200.0, 60.0}}, kRound_s);
    std::vector<float> heard(480);
    TouchSample sample;
    sample.time_s = 1.0;
    sample.solid = 0;
    sample.normal_force_N = 1.0F;
    (void)ring->push(sample);
    sound.render(heard);
    for (int i = 0; i < 500; ++i) {  // five seconds of nothing, a little slower than the clock
        sound.render(std::span(heard).first(470));
    }
    sample.time_s = 6.0;
    sample.impact_speed_m_per_s = 0.2F;
    (void)ring->push(sample);
    float most = 0.0F;
    for (int i = 0; i < 6; ++i) {
        sound.render(heard);
        most = std::max(most, loudest(heard));
    }
    CHECK(most > 0.1F);
}
