// The kite's line (line.h), and the curve that it hangs in (catenary.h).
#include "haptics/flight/line.h"

#include "haptics/dynamics/rigid_body.h"
#include "haptics/flight/catenary.h"
#include "haptics/math/dense.h"
#include "haptics/math/length.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/refused.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.002;

// What a line of its own hangs in.
struct Scene {
    WindSettings wind;
    GustState gusts;
    Vector3 gravity_W{Vector3::Zero()};
    explicit Scene(bool has_weight = true) {
        wind.speed_m_per_s = 0.0;
        wind.ground_m = -1000.0;
        gravity_W.y() = has_weight ? -9.81 : 0.0;
    }
    [[nodiscard]] LineSurroundings around() const { return {gravity_W, wind, gusts}; }
    void step(KiteLine& line, const Vector3& hand_W, const Vector3& end_W,
              double dt_s = kDt_s) const {
        (void)line.begin_step(hand_W, dt_s, around());
        line.end_step(end_W);
    }
    // Both ends held there until it hangs still. Where it does is the same whatever the step; longer ones calm it sooner.
    void settle(KiteLine& line, const Vector3& hand_W, const Vector3& end_W, double seconds,
                double dt_s = kDt_s) const {
        line.lay(hand_W, end_W);
        for (int i = 0; i < static_cast<int>(seconds / dt_s); ++i) {
            step(line, hand_W, end_W, dt_s);
        }
    }
};

// Without air's drag.
LineSettings make_smooth(int segments) {
    LineSettings settings;
    settings.segments = segments;
    settings.drag_coefficient = 0.0;
    return settings;
}

// The pull at the far end of a line that hangs between two places, and half a segment's weight with it.
Vector3 find_pull(int segments, const Vector3& end_W) {
    LineSettings settings = make_smooth(segments);
    settings.mass_kg_per_m = 0.01;
    KiteLine line(settings);
    const Scene scene;
    scene.settle(line, Vector3::Zero(), end_W, 200.0, 0.1);
    return line.end_force_W() + 20.0 / segments * 0.5 * 0.01 * scene.gravity_W;
}

// Of motion, height above the ground at 0 and stretch.
double compute_energy_J(const KiteLine& line) {
    const double n = line.settings().segments;
    const double rest_m = line.length_m() / n;
    double energy_J = 0.0;
    for (std::size_t k = 1; k < line.nodes_W().size(); ++k) {
        const double share = k + 1 == line.nodes_W().size() ? 0.5 : 1.0;
        energy_J += share * line.settings().mass_kg_per_m * rest_m *
                    (0.5 * line.velocities_W()[k].squaredNorm() +
                     9.81 * std::max(line.nodes_W()[k].y(), 0.0));
        const double stretch_m = (line.nodes_W()[k] - line.nodes_W()[k - 1]).norm() - rest_m;
        energy_J +=
            0.5 * line.settings().stretch_N / rest_m * std::pow(std::max(stretch_m, 0.0), 2);
    }
    return energy_J;
}

double catenary_error(int segments, const Vector3& end_W) {
    const auto pull = compute_catenary({20.0, 0.01 * 9.81, 500.0}, end_W.x(), end_W.y());
    return (find_pull(segments, end_W) - Vector3(-pull->level_N, -pull->up_top_N, 0.0)).norm() /
           std::hypot(pull->level_N, pull->up_top_N);
}

}  // namespace

TEST_CASE("line: a catenary, slack and taut; taut it pulls by its stretch, slack it never pushes") {
    const Vector3 slack(15.0, 8.0, 0.0);
    const double coarse = catenary_error(8, slack);
    const double fine = catenary_error(32, slack);
    CHECK(fine < 1.0e-3);
    CHECK(coarse / fine > 10.0);
    CHECK(catenary_error(16, {15.0, 14.0, 0.0}) < 1.0e-3);
    Scene scene(false);
    for (const int segments : {1, 2, 16}) {
        LineSettings settings;
        settings.segments = segments;
        KiteLine line(settings);
        scene.settle(line, {1.0, 2.0, 3.0}, {21.2, 2.0, 3.0}, 1.0);
        CHECK((line.end_force_W() - Vector3(-5.0, 0.0, 0.0)).norm() < 1.0e-6);
        CHECK((line.hand_force_W() - Vector3(5.0, 0.0, 0.0)).norm() < 1.0e-6);
        scene.settle(line, {1.0, 2.0, 3.0}, {15.0, 2.0, 3.0}, 1.0);
        CHECK(line.end_force_W().norm() < 1.0e-9);
        CHECK(line.hand_force_W().norm() < 1.0e-9);
    }
}

TEST_CASE("line: the open end's pull is what the closed step gives") {
    Scene scene(false);
    Random random(5);
    for (const int segments : {1, 2, 7}) {
        KiteLine line(make_smooth(segments));
        line.lay(Vector3::Zero(), {19.0, 8.0, 3.0});
        for (int i = 0; i < 50; ++i) {
            const Vector3 hand_W = 0.02 * random.in_cube();
            const Vector3 end_W = line.nodes_W().back() + 0.02 * random.in_cube();
            const LinePull pull = line.begin_step(hand_W, kDt_s, scene.around());
            const Vector3 told_N = pull.compute_at(end_W - pull.from_W).force_W;
            line.end_step(end_W);
            CHECK((told_N - line.end_force_W()).norm() < 1.0e-6 * (1.0 + told_N.norm()));
            // It yields, never the other way.
            CHECK(compute_symmetric_axes(pull.slope_W).values.maxCoeff() < 1.0e-6);
        }
    }
}

TEST_CASE("line: in the step in which it slackens it does not push either") {
    Scene scene(false);
    const Vector3 along(0.8, 0.6, 0.0);
    for (const int segments : {1, 2, 16}) {
        KiteLine line(make_smooth(segments));
        // Just taut, and let go by ten centimetres at one end or the other.
        for (const bool hand_gives : {false, true}) {
            scene.settle(line, Vector3::Zero(), 20.01 * along, 1.0);
            CHECK(line.hand_force_W().dot(along) == Approx(0.25));
            const Vector3 hand_W = (hand_gives ? 0.1 : 0.0) * along;
            const Vector3 end_W = (hand_gives ? 20.01 : 19.91) * along;
            const LinePull pull = line.begin_step(hand_W, kDt_s, scene.around());
            const LinePull::AtEnd at = pull.compute_at(end_W - pull.from_W);
            line.end_step(end_W);
            CHECK(at.force_W.dot(along) < 1.0e-9);
            CHECK(line.end_force_W().dot(along) < 1.0e-9);
            CHECK(line.hand_force_W().dot(along) > -1.0e-9);
            if (!hand_gives) {
                // Slack there, it has no stiffness along itself.
                CHECK(line.end_force_W().norm() < 1.0e-9);
                CHECK((along.transpose() * at.slope_W).norm() < 1.0e-9);
            } else {
                CHECK(line.hand_force_W().norm() < 1.0e-9);
            }
        }
    }
}

TEST_CASE("line: stretched at a steady rate, it pulls by its stretch and by its damping") {
    Scene scene(false);
    for (const int segments : {1, 4}) {
        LineSettings settings = make_smooth(segments);
        settings.damping_s = 0.2;
        KiteLine line(settings);
        scene.settle(line, Vector3::Zero(), {20.1, 0.0, 0.0}, 1.0);
        constexpr double kRate_m_per_s = 0.25;
        double end_m = 20.1;
        for (int i = 0; i < 2000; ++i) {
            end_m += kRate_m_per_s * kDt_s;
            scene.step(line, Vector3::Zero(), {end_m, 0.0, 0.0});
        }
        const double expected_N = 500.0 / 20.0 * (end_m - 20.0 + 0.2 * kRate_m_per_s);
        CHECK(-line.end_force_W().x() == Approx(expected_N).epsilon(1.0e-6));
        CHECK(line.hand_force_W().x() == Approx(expected_N).epsilon(1.0e-6));
    }
}

TEST_CASE("line: both ends carry the air that passes across it, less its own way, none along it") {
    Scene scene(false);
    scene.wind.ground_m = 0.0;
    LineSettings settings;
    settings.stretch_N = 1.0e5;
    // 10 m high everywhere, just taut, carried along across itself.
    const Vector3 hand_W(0.0, 10.0, 0.0);
    const auto carry_N = [&](double wind_m_per_s, double speed_m_per_s, const Vector3& along) {
        scene.wind.speed_m_per_s = wind_m_per_s;
        KiteLine line(settings);
        scene.settle(line, hand_W, hand_W + 20.02 * along, 10.0);
        for (int i = 1; speed_m_per_s != 0.0 && i <= 2000; ++i) {
            const Vector3 at_W = hand_W + Vector3(speed_m_per_s * kDt_s * i, 0.0, 0.0);
            scene.step(line, at_W, at_W + 20.02 * along);
        }
        return line.end_force_W().x() + line.hand_force_W().x();
    };
    // Half a segment's share at the hand is felt by neither.
    const double square = 0.5 * kAirDensity_kg_per_m3 * 1.1 * 7.0e-4 * 20.0;
    const double felt = 1.0 - 0.5 / 16;
    const Vector3 across = Vector3::UnitZ();
    CHECK(carry_N(10.0, 0.0, across) / felt == Approx(square * 100.0).epsilon(0.01));
    CHECK(carry_N(4.0, 0.0, across) / felt == Approx(square * 16.0).epsilon(0.01));
    CHECK(carry_N(4.0, 4.0, across) / felt == Approx(0.0).margin(1.0e-3));
    CHECK(carry_N(4.0, -3.0, across) / felt == Approx(square * 49.0).epsilon(0.01));
    CHECK(carry_N(4.0, 6.0, across) / felt == Approx(-square * 4.0).epsilon(0.01));
    CHECK(carry_N(10.0, 0.0, Vector3::UnitX()) == Approx(0.0).margin(1.0e-6));
}

TEST_CASE("line: a hand or an end that is nowhere, or a length that is none, leaves it as it was") {
    const Scene scene;
    KiteLine line(LineSettings{});
    scene.settle(line, Vector3::Zero(), {16.0, 13.0, 0.0}, 1.0);
    for (const double bad : {kNan, kInfinity, -kInfinity, 1.0e300}) {
        line.set_length_m(kNan);
        const LinePull pull = line.begin_step({0.0, bad, 0.0}, kDt_s, scene.around());
        CHECK(is_finite(pull.force_W));
        line.end_step({bad, 0.0, 0.0});
        CHECK(line.nodes_W().front() == Vector3::Zero());
        CHECK(line.nodes_W().back() == Vector3(16.0, 13.0, 0.0));
        CHECK(is_finite(line.hand_force_W()));
        CHECK(line.length_m() == 20.0);
    }
    scene.step(line, {0.0, 0.1, 0.0}, {16.0, 13.0, 0.0});
    CHECK(line.nodes_W().front() == Vector3(0.0, 0.1, 0.0));
    CHECK(line.end_force_W().norm() > 1.0);
}

TEST_CASE("line: a snapped one falls, gains no energy, and comes to lie on the ground") {
    Scene scene;
    scene.wind.ground_m = 0.0;
    KiteLine line(LineSettings{});
    const Vector3 hand_W(0.0, 1.0, 0.0);
    line.lay(hand_W, {12.0, 17.0, 0.0});
    line.snap();
    double last_J = compute_energy_J(line);
    for (int i = 0; i < 20000; ++i) {
        CHECK(line.begin_step(hand_W, kDt_s, scene.around()).force_W == Vector3::Zero());
        line.end_step(Vector3::Constant(kNan));
        // A step is linearised, so what turns quickly may gain a little in one; not over a tenth of a second.
        if (i % 50 == 49) {
            const double energy_J = compute_energy_J(line);
            REQUIRE(energy_J <= last_J + 1.0e-9);
            last_J = energy_J;
        }
    }
    CHECK(line.is_snapped());
    CHECK(line.end_force_W() == Vector3::Zero());
    for (std::size_t k = 4; k < line.nodes_W().size(); ++k) {
        CHECK(std::abs(line.nodes_W()[k].y()) < 0.02);
        CHECK(line.velocities_W()[k].norm() < 0.02);
    }
}

TEST_CASE("line: the ground pushes out what is in it, its grass holds what moves, in closed form") {
    Scene scene(false);
    scene.wind.ground_m = 0.0;
    KiteLine line(make_smooth(1));
    // Slack and five centimetres deep, its end goes sideways at 1 m/s, and then is free.
    constexpr double kDepth_m = 0.05;
    const Vector3 hand_W(0.0, -kDepth_m, 0.0);
    const Vector3 end_W(5.0, -kDepth_m, kDt_s);
    line.lay(hand_W, {5.0, -kDepth_m, 0.0});
    scene.step(line, hand_W, end_W);
    line.snap();
    scene.step(line, hand_W, Vector3::Zero());
    // (m/h^2 + 2 m omega / h) d = m v / h;  upwards (m/h^2 + 2 m omega / h + m omega^2) d = m omega^2 depth.
    constexpr double kOmega_h = 60.0 * kDt_s;
    CHECK(line.velocities_W()[1].z() == Approx(1.0 / (1.0 + 2.0 * kOmega_h)));
    CHECK(line.nodes_W()[1].y() + kDepth_m ==
          Approx(kDepth_m * kOmega_h * kOmega_h / std::pow(1.0 + kOmega_h, 2)));
}

TEST_CASE("line: let out, it slackens within bounds; settings that no line has are refused") {
    Scene scene;
    KiteLine line(LineSettings{});
    scene.settle(line, Vector3::Zero(), {16.0, 13.0, 0.0}, 1.0);
    CHECK(line.end_force_W().norm() > 5.0);
    line.set_length_m(22.0);
    for (int i = 0; i < 3000; ++i) {
        scene.step(line, Vector3::Zero(), {16.0, 13.0, 0.0});
    }
    CHECK(line.end_force_W().norm() < 0.5);
    line.set_length_m(1000.0);
    CHECK(line.length_m() == Approx(80.0));
    line.set_length_m(0.0);
    CHECK(line.length_m() == Approx(0.5));
    using L = LineSettings;
    check_refused(L{}, {{&L::length_m, 0.0},
                        {&L::segments, 0},
                        {&L::segments, kMostLineSegments + 1},
                        {&L::mass_kg_per_m, 0.0},
                        {&L::stretch_N, 0.0},
                        {&L::strength_N, std::nan("")}});
}

TEST_CASE("catenary: a level chain sags as the hyperbolic cosine") {
    // 2 H/w sinh(w l / 2 H) = L; sag H/w (cosh(w l / 2 H) - 1).
    const double H = 3.0;
    const double w = 0.5;
    const double l = 8.0;
    const CatenarySettings chain{2.0 * H / w * std::sinh(w * l / (2.0 * H)), w, 1.0e12};
    const auto pull = compute_catenary(chain, l, 0.0);
    REQUIRE(pull);
    CHECK(pull->level_N == Approx(H).epsilon(1.0e-8));
    CHECK(pull->up_top_N == Approx(0.5 * w * chain.length_m));
    CHECK(pull->up_bottom_N == Approx(-0.5 * w * chain.length_m));
}

TEST_CASE("catenary: a taut light line pulls as a spring along its chord") {
    const CatenarySettings line{10.0, 1.0e-6, 500.0};
    const auto pull = compute_catenary(line, 6.06, 8.08);  // 1 % longer than it is
    REQUIRE(pull);
    CHECK(pull->level_N == Approx(5.0 * 0.6).epsilon(1.0e-4));
    CHECK(pull->up_top_N == Approx(5.0 * 0.8).epsilon(1.0e-4));
}

TEST_CASE("catenary: both ends carry its weight, slack or taut, steep or level") {
    const CatenarySettings line{20.0, 0.05, 300.0};
    for (const double level_m : {2.0, 10.0, 18.0}) {
        for (const double up_m : {0.0, 5.0, 15.0, 20.0}) {
            const auto pull = compute_catenary(line, level_m, up_m);
            REQUIRE(pull);
            CHECK(pull->up_top_N - pull->up_bottom_N == Approx(1.0));
            CHECK(pull->level_N > 0.0);
        }
    }
}
