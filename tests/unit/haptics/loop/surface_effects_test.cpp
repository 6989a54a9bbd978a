// Surfaces through the whole loop: a plate that is stroked and tapped by a hand that goes as it is told.
#include "haptics/loop/surface_effects.h"

#include "haptics/geometry/shape.h"
#include "tests/support/touchable.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <numbers>

using namespace fulcrum;

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

HapticPlan make_plate_plan() {
    HapticPlan plan;
    plan.expects_lesson = false;
    plan.safety.soft_start_s = 0.0;
    plan.solids = only_solid(touchable(make_plate(4.0, 0.2, 8)));
    return plan;
}

// The forces along x that a stroke of `speed_m_per_s`, 4 mm deep, asks for in n rounds.
std::vector<double> stroke(const HapticPlan& plan, double speed_m_per_s, int n) {
    Bench bench(plan);
    std::vector<double> forces;
    bench.device.pose_D.position = Vector3(-0.5, 0.01, 0.013);
    for (int k = 0; k < 200 + n; ++k) {
        bench.device.pose_D.position.y() = std::max(0.01 - 1.0e-4 * k, -0.004);
        bench.device.pose_D.position.x() = -0.5 + speed_m_per_s * (bench.now_s + bench.dt_s);
        bench.run(1);
        if (k >= 200) {
            forces.push_back(bench.state().commanded_W.force.x());
        }
    }
    return forces;
}

// Amplitude of the wave of `hertz` in a record, through a Hann window.
double amplitude(const std::vector<double>& record, double rate_hz, double hertz) {
    std::complex<double> sum = 0.0;
    double weights = 0.0;
    const auto n = static_cast<double>(record.size());
    for (std::size_t k = 0; k < record.size(); ++k) {
        const auto i = static_cast<double>(k);
        const double window = 0.5 - 0.5 * std::cos(kTwoPi * (i + 0.5) / n);
        sum += window * record[k] * std::polar(1.0, -kTwoPi * hertz * i / rate_hz);
        weights += window;
    }
    return 2.0 * std::abs(sum) / weights;
}

// The strongest wave of a record that is not within 3 bins of `hertz`.
double strongest_other(const std::vector<double>& record, double rate_hz, double hertz) {
    const double bin_hz = rate_hz / static_cast<double>(record.size());
    double strongest = 0.0;
    for (double f = 3.0 * bin_hz; f < 0.5 * rate_hz; f += bin_hz) {
        if (std::abs(f - hertz) > 3.0 * bin_hz) {
            strongest = std::max(strongest, amplitude(record, rate_hz, f));
        }
    }
    return strongest;
}

HapticPlan make_grooved_plan(double wavelength_m, double rate_hz) {
    HapticPlan plan = make_plate_plan();
    plan.rate_hz = rate_hz;
    plan.passivity.on = false;
    plan.coupling = {.stiffness_N_per_m = 500.0, .damping_Ns_per_m = 0.0};
    plan.solids[0].surface.texture.source = SineTexture{wavelength_m, 0.0};
    plan.solids[0].surface.texture.law = TextureLaw::lateral;
    plan.solids[0].surface.texture.height_m = 0.02 * wavelength_m;
    return plan;
}

// 500 N/m, 4 mm, slope 0.01 2 pi.
constexpr double kFelt_N = 500.0 * 0.004 * 0.01 * kTwoPi;
constexpr double kFolded = 0.01;      // -40 dB
constexpr double kAmplitude = 0.015;  // the filter's ripple and the map's

}  // namespace

TEST_CASE("surface: the spectrum of the felt force is the relief's at strokes of 0.02 to 0.5 m/s") {
    for (const double rate_hz : {1000.0, 5000.0}) {
        for (const double speed : {0.02, 0.05, 0.1, 0.2, 0.5}) {
            // From a slow wave to one at the edge of what is passed.
            for (const double share : {0.02, 0.1, 0.2, 0.29}) {
                const double hertz = share * rate_hz;
                if (speed / hertz < 1.0e-4) {
                    continue;  // shorter than a texture may be
                }
                INFO(rate_hz << " Hz, " << speed << " m/s, " << hertz << " Hz");
                const auto forces = stroke(make_grooved_plan(speed / hertz, rate_hz), speed, 400);
                CHECK(amplitude(forces, rate_hz, hertz) == Approx(kFelt_N).epsilon(kAmplitude));
                CHECK(strongest_other(forces, rate_hz, hertz) < kFolded * kFelt_N);
            }
        }
    }
}

TEST_CASE("surface: waves above half the loop's rate are removed, not folded, of any law") {
    for (const double share : {0.52, 0.7, 0.93, 1.04, 1.5, 2.3, 4.1}) {
        for (const double speed : {0.2, 0.5}) {
            INFO(share << " of the rate at " << speed << " m/s");
            const auto forces =
                stroke(make_grooved_plan(speed / (share * 1000.0), 1000.0), speed, 400);
            CHECK(strongest_other(forces, 1000.0, -1.0) < kFolded * kFelt_N);
        }
    }
    // h grad h: half of the relief's waves is of twice their frequency, here 600 of 1000 Hz.
    HapticPlan plan = make_grooved_plan(0.2 / 300.0, 1000.0);
    plan.solids[0].surface.texture.law = TextureLaw::perturbed_normal;
    const auto forces = stroke(plan, 0.2, 400);
    const double felt = amplitude(forces, 1000.0, 300.0);
    const double height = 0.02 * 0.2 / 300.0;
    CHECK(felt == Approx(500.0 * 0.5 * height * 0.01 * kTwoPi).epsilon(kAmplitude));
    CHECK(strongest_other(forces, 1000.0, 300.0) < kFolded * felt);
}

TEST_CASE("surface: the passivity stage leaves bumps as they are, at any speed") {
    for (const double speed : {0.05, 0.1, 0.5}) {
        for (const double share : {0.02, 0.2, 0.29}) {
            HapticPlan plan = make_grooved_plan(speed / (share * 1000.0), 1000.0);
            const auto free = stroke(plan, speed, 400);
            plan.passivity.on = true;
            CHECK(stroke(plan, speed, 400) == free);
        }
    }
}

TEST_CASE("surface: a tap rings with the set frequency, and no edge of the plate rings") {
    HapticPlan plan = make_plate_plan();
    plan.coupling.damping_Ns_per_m = 0.0;
    plan.passivity.on = false;
    TransientSettings& tap = plan.solids[0].surface.transient;
    tap = {.kind = TransientKind::decaying_sinusoid,
           .force_Ns_per_m = 8.0,
           .frequency_Hz = 80.0,
           .decay_per_s = 60.0};
    HapticPlan plain = plan;
    plain.solids[0].surface = {};
    Bench rings(plan);
    Bench silent(plain);
    const double speed = 0.1;
    double tapped_s = -1.0;
    double largest = 0.0;
    for (int k = 0; k < 1500; ++k) {
        // Comes down, rests 2 mm deep, then slides across the plate's triangles.
        const double y = std::max(0.02 - speed * 0.001 * std::max(k - 100, 0), -0.002);
        const double x = -1.0 + 0.0011 * std::max(k - 700, 0);
        for (Bench* bench : {&rings, &silent}) {
            bench->device.pose_D.position = Vector3(x, y, 0.013);
            bench->run(1);
        }
        const double extra =
            (rings.state().commanded_W.force - silent.state().commanded_W.force).y();
        const bool touched = rings.state().touched_body == 0;
        tapped_s = touched && tapped_s < 0.0 ? 0.001 * k : tapped_s;
        if (!touched) {
            CHECK(extra == 0.0);
        } else {
            const double t = 0.001 * k - tapped_s + 0.0005;
            const double wanted =
                t < 6.9 / 60.0 ? 8.0 * speed * std::exp(-60.0 * t) * std::sin(kTwoPi * 80.0 * t)
                               : 0.0;
            CHECK(extra == Approx(wanted).margin(0.01));
            largest = std::max(largest, std::abs(extra));
        }
    }
    CHECK(largest > 0.5);
}

TEST_CASE("surface: a tap faster than any hand stays within the gate") {
    HapticPlan plan = make_plate_plan();
    TransientSettings& tap = plan.solids[0].surface.transient;
    tap = {.kind = TransientKind::decaying_sinusoid,
           .force_Ns_per_m = 100.0,
           .frequency_Hz = 200.0,
           .decay_per_s = 20.0,
           .max_force_N = 10.0};
    Bench bench(plan);
    bench.device.pose_D.position = Vector3(0.0, 0.5, 0.013);
    bench.run(100);
    Vector3 before = Vector3::Zero();
    for (int k = 0; k < 600; ++k) {
        bench.device.pose_D.position.y() =
            std::max(bench.device.pose_D.position.y() - 0.0095, -0.001);
        bench.run(1);
        CHECK(bench.written_N().norm() <= plan.safety.max_force_N);
        CHECK((bench.written_N() - before).norm() <= 0.5 + kRounding);
        before = bench.written_N();
    }
}

TEST_CASE("surface: stages are there for what surfaces ask for, and for nothing else") {
    HapticPlan plan = make_plate_plan();
    const auto has = [&plan](const char* stage) {
        return Bench(plan).stages().find(stage) != std::string::npos;
    };
    CHECK_FALSE(has("texture"));
    CHECK_FALSE(has("transient"));
    CHECK(make_surface_effects(plan, {}, nullptr) == nullptr);
    plan.solids[0].surface.texture.source = SineTexture{};
    CHECK(has("forces: texture, "));
    CHECK_FALSE(has("transient"));
    plan.solids[0].surface.transient.kind = TransientKind::fixed_pulse;
    CHECK(has("forces: texture, forces: transient, "));
    plan.solids[0].surface.texture.source = {};
    CHECK_FALSE(has("texture"));
    CHECK(has("forces: transient, "));
    plan.solids[0].surface.transient.frequency_Hz = 401.0;
    REQUIRE_FALSE(validate(plan));
    CHECK(to_sentence(validate(plan).error()).find("at a loop of 1000 Hz") != std::string::npos);
    plan.rate_hz = 1100.0;
    CHECK(validate(plan));
}

TEST_CASE("surface: the sound hears every round of a touch, its tap and its relief") {
    HapticPlan plan = make_grooved_plan(0.01, 1000.0);
    plan.solids[0].surface.audible = true;
    const auto ring = std::make_unique<TouchRing>();
    Bench bench(plan, {.touches = ring.get()});
    int n_samples = 0;
    int n_taps = 0;
    TouchSample sample;
    for (int k = 0; k < 300; ++k) {
        const double y = std::max(0.01 - 2.0e-4 * k, -0.004);
        bench.device.pose_D.position = Vector3(1.0e-4 * k, k < 250 ? y : 0.01, 0.013);
        bench.run(1);
        while (ring->pop(sample)) {
            ++n_samples;
            n_taps += sample.impact_speed_m_per_s > 0.0F ? 1 : 0;
            if (sample.impact_speed_m_per_s > 0.0F) {
                CHECK(sample.impact_speed_m_per_s == Approx(0.2).epsilon(0.01));
            }
            if (k == 249) {
                CHECK(sample.normal_force_N == Approx(2.0).epsilon(1.0e-6));
                CHECK(sample.slip_speed_m_per_s == Approx(0.1).epsilon(1.0e-3));
                CHECK(sample.u_m == Approx(1.0e-4 * k));
                CHECK(sample.texture_height_m ==
                      Approx(1.0e-4 * (1.0 + std::sin(kTwoPi * 1.0e-4 * k / 0.01))).margin(2.0e-6));
            }
        }
    }
    CHECK(n_taps == 1);
    // Touched from round 51 to 249, and its end.
    CHECK(n_samples == Approx(200).margin(1));
    CHECK(sample.solid == kNoBody);
}
