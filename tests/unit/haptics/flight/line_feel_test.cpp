#include "haptics/flight/line_feel.h"

#include "haptics/flight/kite_loop.h"
#include "haptics/math/rotation.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/refused.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
const Vector3 kHand_W(1.0, 2.0, 3.0);

// 3 N along x, from a line of 20 m and 25 N/m.
LineState make_state(double stamp_s = 0.0) {
    return {stamp_s, kHand_W, {3.0, 0.0, 0.0}, 25.0, 20.0};
}

// Open: states have come for long enough.
LineFeel make_open(const LineFeelSettings& settings = {}, const LineState& state = make_state()) {
    LineFeel feel(settings);
    for (int i = 0; i < 600; ++i) {
        (void)feel.step(state, Pose::at(state.hand_W), state.stamp_s, kDt_s);
    }
    return feel;
}

// What is felt beside where the hand was.
Vector3 step(LineFeel& feel, const LineState& state, const Vector3& offset_m = Vector3::Zero(),
             double now_s = 0.0) {
    return feel.step(state, Pose::at(kHand_W + offset_m), now_s, kDt_s).force;
}

Vector3 feel_at(const Vector3& offset_m) {
    LineFeel feel = make_open();
    return step(feel, make_state(), offset_m);
}

}  // namespace

TEST_CASE("line feel: pull, spring and string about the hand; shared, bounded, with torque") {
    CHECK((feel_at({0.0, 0.0, 0.0}) - Vector3(3.0, 0.0, 0.0)).norm() < 1.0e-12);
    CHECK((feel_at({-0.02, 0.0, 0.0}) - Vector3(3.5, 0.0, 0.0)).norm() < 1.0e-12);
    const double aside_N = 3.0 + 25.0 * (std::hypot(20.0, 0.1) - 20.0);
    CHECK((feel_at({0.0, 0.1, 0.0}) - aside_N * Vector3(20.0, -0.1, 0.0).normalized()).norm() <
          1.0e-12);
    // Brought nearer by more than it is stretched, it is slack.
    CHECK(feel_at({0.119, 0.0, 0.0}).x() == Approx(0.025));
    CHECK(feel_at({0.121, 0.0, 0.0}) == Vector3::Zero());
    LineFeelSettings settings;
    settings.share = 0.5;
    settings.most_N = 2.0;
    settings.arm_T = {0.0, 0.1, 0.0};
    LineFeel feel = make_open(settings);
    const Quaternion turned = compute_exp(Vector3(0.0, 0.0, 0.5));
    const Wrench felt = feel.step(make_state(), {{1.0, 2.0, 3.0}, turned}, 0.0, kDt_s);
    CHECK((felt.force - Vector3(1.5, 0.0, 0.0)).norm() < 1.0e-12);
    CHECK((felt.torque - (turned * settings.arm_T).cross(felt.force)).norm() < 1.0e-12);
    const Wrench far = feel.step(make_state(), Pose::at({0.0, 2.0, 3.0}), 0.0, kDt_s);
    CHECK(far.force.norm() == Approx(2.0));
}

TEST_CASE("line feel: opens softly, and fades when the world is silent or says nothing true") {
    LineFeel feel(LineFeelSettings{});
    double last_N = 0.0;
    for (int i = 0; i < 99; ++i) {
        const double felt_N = step(feel, make_state()).norm();
        CHECK(felt_N - last_N == Approx(3.0 * kDt_s / 0.5));
        last_N = felt_N;
    }
    LineState broken = make_state();
    broken.force_W.x() = kNan;
    for (const LineState& bad : {make_state(-1.0), make_state(0.3), make_state(kNan), broken}) {
        LineFeel open = make_open();
        for (int i = 0; i < 101; ++i) {
            CHECK(step(open, bad, Vector3::Zero(), 0.15).norm() <=
                  3.0 * std::max(1.0 - 0.01 * (i + 1), 0.0) + 1.0e-9);
        }
        CHECK(step(open, bad, Vector3::Zero(), 0.15) == Vector3::Zero());
    }
    // One that is old enough likewise, and a hand that is nowhere feels nothing.
    LineFeel late = make_open();
    CHECK(step(late, make_state(), Vector3::Zero(), 0.11).norm() < 3.0);
    CHECK(is_finite(late.step(make_state(), {{kNan, 0, 0}, {kNan, 0, 0, 0}}, 0.0, kDt_s)));
}

TEST_CASE("line feel: while the world stands, a hand that goes round gains nothing from it") {
    Random random(21);
    for (int round = 0; round < 50; ++round) {
        LineFeel feel = make_open();
        const Vector3 a = 0.2 * random.in_cube();
        const Vector3 b = 0.2 * random.in_cube();
        double work_J = 0.0;
        Vector3 at = Vector3::Zero();
        Vector3 force_W = step(feel, make_state());
        constexpr int kSteps = 4000;
        for (int i = 1; i <= kSteps; ++i) {
            const double phase = 2.0 * std::numbers::pi * i / kSteps;
            const Vector3 next = std::sin(phase) * a + (1.0 - std::cos(phase)) * b;
            const Vector3 next_force_W = step(feel, make_state(), next);
            work_J += 0.5 * (force_W + next_force_W).dot(next - at);
            at = next;
            force_W = next_force_W;
        }
        constexpr double kSteps_J = 1.0e-5;  // of a round in 4000 straight steps
        CHECK(std::abs(work_J) < kSteps_J);
    }
}

TEST_CASE("line feel: what the world changes comes at 50 N/s at most, what the hand does at once") {
    LineFeel feel = make_open();
    LineState pulled = make_state();
    pulled.force_W = {5.0, 0.0, 0.0};
    double last_N = 3.0;
    double fastest_N = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const double felt_N = step(feel, pulled).x();
        fastest_N = std::max(fastest_N, felt_N - last_N);
        last_N = felt_N;
    }
    CHECK(fastest_N == Approx(2.0 * kDt_s / 0.15).epsilon(0.01));
    CHECK(last_N == Approx(5.0).epsilon(1.0e-3));
    // Slack in the world, it goes alike; the hand that goes to the kite meanwhile is not pushed.
    LineState slack = make_state();
    slack.force_W.setZero();
    CHECK(step(feel, slack).x() > 4.9);
    LineFeel rising = make_open({}, slack);
    (void)step(rising, pulled);
    CHECK(step(rising, pulled, {0.19, 0.0, 0.0}).x() == 0.0);
    LineFeel quick = make_open();
    CHECK(step(quick, make_state(), {-0.02, 0.0, 0.0}).x() == Approx(3.5));
}

TEST_CASE("line feel: a line that has snapped lets go at once, and a launch opens it anew") {
    LineFeel feel = make_open();
    LineState snapped = make_state();
    snapped.force_W.setZero();
    snapped.stiffness_N_per_m = 0.0;
    CHECK(step(feel, snapped) == Vector3::Zero());
    LineFeel flown = make_open();
    LineState launched = make_state();
    launched.n_launches = 1;
    CHECK(step(flown, launched).x() == Approx(3.0 * kDt_s / 0.5));
}

TEST_CASE("line feel: a line that is let out does not buzz in the hand") {
    KiteFlightSettings settings;
    settings.kite.knot_m = 0.68;
    settings.line.length_m = 12.0;
    settings.wind.speed_m_per_s = 4.5;
    const auto channels = std::make_unique<KiteChannels>();
    KiteLoop loop(settings, 500.0, *channels);
    LineFeel feel(LineFeelSettings{});
    KiteOrders orders;
    orders.line_m = 12.0;
    orders.wind_m_per_s = 4.5;
    channels->orders.publish(orders);
    const Pose hand_W = Pose::at({0.0, 1.0, 0.0});
    // How often the force turns by more than 0.2 N, in the two seconds from when the reel turns.
    int n_turns = 0;
    double extreme_N = 0.0;
    double sense = 1.0;
    for (int i = 0; i < 16000; ++i) {
        const double now_s = kDt_s * (i + 1);
        channels->hand_W.publish(hand_W.position);
        orders.line_m = i < 14000 ? 12.0 : 48.0;
        channels->orders.publish(orders);
        if (i % 2 == 0) {
            loop.step(now_s);
        }
        (void)channels->line.take();
        const double felt_N = feel.step(channels->line.value(), hand_W, now_s, kDt_s).force.norm();
        extreme_N = i <= 14000 ? felt_N : sense * std::max(sense * extreme_N, sense * felt_N);
        if (sense * (extreme_N - felt_N) > 0.2) {
            ++n_turns;
            sense = -sense;
            extreme_N = felt_N;
        }
    }
    CHECK(loop.flight().line().length_m() == Approx(16.0).margin(0.1));
    CHECK(n_turns <= 8);
}

TEST_CASE("line feel: a line's state is its pull, its stretch and its tension over its length") {
    KiteLine line(LineSettings{});
    WindSettings wind;
    wind.speed_m_per_s = 0.0;
    wind.ground_m = -100.0;
    const GustState gusts;
    line.lay(Vector3::Zero(), {20.2, 0.0, 0.0});
    const auto hold = [&](const Vector3& hand_W) {
        for (int i = 0; i < 500; ++i) {
            (void)line.begin_step(hand_W, 0.01, {Vector3::Zero(), wind, gusts});
            line.end_step({20.2, 0.0, 0.0});
        }
    };
    hold(Vector3::Zero());
    const LineState state = make_line_state(line, {0.0, 0.0, 0.0}, 1.5);
    CHECK(state.stamp_s == 1.5);
    CHECK((state.force_W - Vector3(5.0, 0.0, 0.0)).norm() < 1.0e-6);
    CHECK(state.stiffness_N_per_m == Approx(500.0 / 20.0));
    CHECK(state.length_m == Approx(20.0));
    // Moved by a little, the true line pulls as its state foretells.
    LineFeelSettings wide;
    wide.most_N = 10.0;
    LineFeel feel = make_open(wide, state);
    const Vector3 moved_W(-0.05, 0.1, 0.0);
    hold(moved_W);
    const Vector3 told_W = feel.step(state, Pose::at(moved_W), 1.5, kDt_s).force;
    CHECK((told_W - line.hand_force_W()).norm() < 1.0e-3 * told_W.norm());
    // Let out it is softer.
    line.set_length_m(25.0);
    CHECK(make_line_state(line, Vector3::Zero(), 2.0).stiffness_N_per_m == Approx(20.0));
    CHECK(make_line_state(line, Vector3::Zero(), 2.0).length_m == Approx(25.0));
    line.snap();
    CHECK(make_line_state(line, Vector3::Zero(), 2.0).stiffness_N_per_m == 0.0);
}

TEST_CASE("line feel: refuses settings outside their ranges") {
    using F = LineFeelSettings;
    check_refused(F{}, {{&F::share, -1.0},
                        {&F::most_N, 11.0},
                        {&F::timeout_s, 0.0},
                        {&F::fade_s, std::nan("")},
                        {&F::open_s, 0.0},
                        {&F::smooth_s, 0.0},
                        {&F::most_change_N_per_s, 0.0},
                        [](F& feel) {
                            feel.arm_T = {2.0, 0.0, 0.0};
                        }});
}
