#include "haptics/flight/kite_flight.h"

#include "haptics/dynamics/rigid_body.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.002;
const Vector3 kHand_W(0.0, 1.0, 0.0);

void fly(KiteFlight& flight, double seconds, double dt_s = kDt_s) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / dt_s)); ++i) {
        flight.step(dt_s, kHand_W);
    }
}

// A diamond on a line that the wind does not touch: what can be balanced by hand.
KiteFlightSettings make_plain(double knot_m) {
    KiteFlightSettings settings;
    settings.kite.knot_m = knot_m;
    settings.kite.strips = 32;
    settings.line.segments = 32;
    settings.line.drag_coefficient = 0.0;
    settings.line.mass_kg_per_m = 2.0e-3;
    settings.wind.speed_m_per_s = 5.0;
    return settings;
}

// A force in the plane of spine and front at a place in it: y along the spine from its foot, z in front of it.
struct PlaneForce {
    double y_m, z_m, y_N, z_N;
};

// Forces and torques on that diamond, from its triangles in closed form: nothing of the library but the air's density.
struct Balance {
    double angle_rad = 0.0;
    double level_N = 0.0;  // what the line must hold back, downwind
    double up_N = 0.0;     // and upwards
    double torque_Nm = 0.0;
    double centre_m = 0.0;  // how much higher the centre of mass lies than the knot
};

Balance compute_balance(const KiteFlightSettings& settings, double angle_rad, double wind_m_per_s) {
    const KiteSettings& kite = settings.kite;
    const double H = kite.height_m;
    const double W = kite.width_m;
    const double A = 0.5 * W * H;
    const double fold_c = std::cos(kite.fold_rad);
    const double fold_s = std::sin(kite.fold_rad);
    const double AR = W * W * fold_c / A;
    const double q = 0.5 * kAirDensity_kg_per_m3 * wind_m_per_s * wind_m_per_s;
    // The wind comes down the spine by c and against the front by s; of that, fold_c goes across each half.
    const double s = std::sin(angle_rad);
    const double c = std::cos(angle_rad);
    const double across = s * fold_c;
    const double along = std::sqrt(1.0 - across * across);
    const double slope = 2.0 * std::numbers::pi * AR / (2.0 + std::sqrt(AR * AR + 4.0));
    const double back_m = -fold_s * W / 6.0;  // of the middle of a half's area
    const double middle_m = 7.0 / 12.0 * H;
    const double cloth_N = 9.81 * kite.cloth_kg_per_m2 * A;
    const double spine_N = 9.81 * kite.spar_kg_per_m * H;
    const double spar_N = 9.81 * kite.spar_kg_per_m * W;
    const double tail_N = 9.81 * kite.tail_kg_per_m * kite.tail_m;
    const double tail_drag_N = q * kite.tail_m * kite.tail_drag_m2_per_m;
    const double rubbed_N = q * A * 0.02 * along;
    const PlaneForce forces[] = {
        // Potential flow at the quarter chords, or a little less upstream where the stream crosses them; cross flow and friction in
        // the middle of the area.
        {middle_m + H / 6.0 * c / along, back_m, 0.0, -q * A * fold_c * slope * across * along},
        {middle_m, back_m, 0.0, -q * A * fold_c * (1.11 + 0.018 * AR) * across * across},
        {middle_m, back_m, -rubbed_N * c, -rubbed_N * s * fold_s * fold_s},
        {0.0, 0.0, -tail_drag_N * c, -tail_drag_N * s},
        {middle_m, back_m, -cloth_N * s, cloth_N * c},
        {0.5 * H, 0.0, -spine_N * s, spine_N * c},
        {0.75 * H, -fold_s * W / 4.0, -spar_N * s, spar_N * c},
        {0.0, 0.0, -tail_N * s, tail_N * c}};
    // About the knot.
    const double below = kite.knot_m;
    const double above = kite.bridle_m - below;
    const double y_k = (below * below + H * H - above * above) / (2.0 * H);
    const double z_k = std::sqrt(below * below - y_k * y_k);
    Balance balance;
    balance.angle_rad = angle_rad;
    double y_N = 0.0;
    double z_N = 0.0;
    for (const PlaneForce& force : forces) {
        y_N += force.y_N;
        z_N += force.z_N;
        balance.torque_Nm += (force.y_m - y_k) * force.z_N - (force.z_m - z_k) * force.y_N;
    }
    // The spine points upwind by c and up by s, the front upwind by s and down by c.
    balance.level_N = -y_N * c - z_N * s;
    balance.up_N = y_N * s - z_N * c;
    const double weight_N = cloth_N + spine_N + spar_N + tail_N;
    const double y_m = (cloth_N * middle_m + spine_N * 0.5 * H + spar_N * 0.75 * H) / weight_N;
    const double z_m = (cloth_N * back_m - spar_N * fold_s * W / 4.0) / weight_N;
    balance.centre_m = (y_m - y_k) * s - (z_m - z_k) * c;
    return balance;
}

// The angle at which the torque about the knot is none.
Balance solve_balance(const KiteFlightSettings& settings, double wind_m_per_s) {
    double low = 0.02;
    double high = 1.4;
    const bool rises = compute_balance(settings, high, wind_m_per_s).torque_Nm > 0.0;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        const bool above = compute_balance(settings, middle, wind_m_per_s).torque_Nm > 0.0;
        (above == rises ? high : low) = middle;
    }
    return compute_balance(settings, 0.5 * (low + high), wind_m_per_s);
}

struct Place {
    double level_m;
    double up_m;
};

// Where a line's upper end hangs under that pull: Irvine's elastic catenary.
Place compute_place(const LineSettings& line, double level_N, double up_N) {
    const double w = line.mass_kg_per_m * 9.81;
    const double bottom_N = up_N - w * line.length_m;
    return {level_N * line.length_m / line.stretch_N +
                level_N / w * (std::asinh(up_N / level_N) - std::asinh(bottom_N / level_N)),
            line.length_m / line.stretch_N * (up_N - 0.5 * w * line.length_m) +
                (std::hypot(level_N, up_N) - std::hypot(level_N, bottom_N)) / w};
}

}  // namespace

TEST_CASE("kite flight: steady flight is the balance of forces and torques, its line a catenary") {
    for (const double knot_m : {0.67, 0.72}) {
        const KiteFlightSettings settings = make_plain(knot_m);
        // The wind at the kite's height, and the height in that wind.
        Balance expected{};
        Place knot{0.0, 15.0};
        for (int i = 0; i < 60; ++i) {
            const double centre_m = kHand_W.y() + knot.up_m + expected.centre_m;
            const double wind = settings.wind.speed_m_per_s * std::log((centre_m + 0.03) / 0.03) /
                                std::log(10.03 / 0.03);
            expected = solve_balance(settings, wind);
            knot = compute_place(settings.line, expected.level_N, expected.up_N);
        }
        KiteFlight flight(settings);
        fly(flight, 100.0,
            0.02);  // the balance is the same whatever the step; longer ones calm it sooner
        const KiteReport& report = flight.report();
        constexpr double kStrips = 2.0e-3;  // 32 strips, 32 segments instead of none
        CHECK(report.angle_of_attack_rad == Approx(expected.angle_rad).epsilon(kStrips));
        const Vector3 half_segment_W(
            0.0, -0.5 * settings.line.length_m / 32.0 * settings.line.mass_kg_per_m * 9.81, 0.0);
        const Vector3 pull_W = report.tension_W + half_segment_W;
        CHECK(-pull_W.x() == Approx(expected.level_N).epsilon(kStrips));
        CHECK(-pull_W.y() == Approx(expected.up_N).epsilon(kStrips));
        CHECK(report.knot_W.x() == Approx(knot.level_m).epsilon(kStrips));
        CHECK(report.knot_W.y() - kHand_W.y() == Approx(knot.up_m).epsilon(kStrips));
        CHECK(std::abs(report.knot_W.z()) < 1.0e-6);
        CHECK(flight.state().velocity_W.linear.norm() < 1.0e-4);
        CHECK(report.n_failed == 0);
    }
}

TEST_CASE("kite flight: in steady flight four forces cancel, and their torques about the knot") {
    for (const KiteShape shape : kKiteShapes) {
        KiteFlightSettings settings;
        settings.kite.shape = shape;
        settings.kite.width_m = shape == KiteShape::box ? 0.4 : 0.75;
        settings.kite.knot_m = 0.72;  // with a lower one the delta loops
        KiteFlight flight(settings);
        fly(flight, 100.0, 0.02);
        INFO(to_string(shape));
        const KiteReport& report = flight.report();
        CHECK(flight.state().velocity_W.linear.norm() < 1.0e-3);
        // Half a segment of line hangs on the kite as well.
        const double slack_N = 0.5 * settings.line.mass_kg_per_m * 20.0 / 16.0 * 9.81 + 0.02;
        const Vector3 air_W = report.lift_W + report.drag_W;
        CHECK((report.weight_W + air_W + report.tension_W).norm() < slack_N);
        CHECK(std::abs(report.lift_W.dot(report.drag_W)) < 1.0e-9);
        CHECK(report.lift_W.y() > 0.0);
        CHECK(report.drag_W.x() > 0.0);
        const Vector3 torque = (report.centre_W - report.knot_W).cross(report.weight_W) +
                               (report.pressure_W - report.knot_W).cross(air_W);
        CHECK(torque.norm() < 0.02 * air_W.norm());
        // What the hand holds is what pulls the kite, less what the wind and weight of the line take.
        CHECK((report.hand_force_W + report.tension_W).norm() < 0.5);
    }
}

TEST_CASE("kite flight: it flies by its knot and its tail, and without wind comes down") {
    const auto height_m = [](double knot_m, double tail_m) {
        KiteFlightSettings settings;
        settings.kite.knot_m = knot_m;
        settings.kite.tail_m = tail_m;
        KiteFlight flight(settings);
        fly(flight, 30.0);
        double lowest_m = 100.0;
        for (int i = 0; i < 10; ++i) {
            fly(flight, 1.0);
            lowest_m = std::min(lowest_m, flight.report().centre_W.y());
        }
        return lowest_m;
    };
    CHECK(height_m(0.68, 2.0) > 15.0);
    CHECK(height_m(0.60, 2.0) < 2.0);  // too low: it stands too steep, and dives
    CHECK(height_m(0.68, 0.0) < 2.0);  // without a tail it turns over
    KiteFlightSettings settings;
    settings.wind.speed_m_per_s = 0.0;
    KiteFlight flight(settings);
    fly(flight, 40.0);
    CHECK(flight.report().centre_W.y() < 0.5);
    CHECK(flight.state().velocity_W.linear.norm() < 0.05);
    for (const Vector3& corner_B : flight.kite().corners_B) {
        CHECK((flight.state().pose_W * corner_B).y() > -0.02);
    }
    CHECK(flight.report().hand_force_W.norm() < 0.2);
    CHECK(flight.report().n_failed == 0);
}

TEST_CASE("kite flight: a line that is too weak snaps, and then nothing pulls") {
    KiteFlightSettings settings;
    settings.line.strength_N = 2.0;
    KiteFlight flight(settings);
    double elapsed_s = 0.0;
    double most_N = 0.0;
    for (; !flight.report().is_snapped && elapsed_s < 20.0; elapsed_s += kDt_s) {
        fly(flight, kDt_s);
        most_N = std::max(most_N, flight.report().tension_W.norm());
    }
    CHECK(most_N <= 2.0);
    CHECK(most_N > 1.9);                                  // it held until then
    CHECK(flight.report().tension_W == Vector3::Zero());  // in the very step already
    fly(flight, 20.0 - elapsed_s);
    const KiteReport& report = flight.report();
    CHECK(report.is_snapped);
    CHECK(report.tension_W == Vector3::Zero());
    CHECK(report.hand_force_W.norm() < 0.1);
    CHECK(report.centre_W.x() > 25.0);  // gone with the wind, and down
    CHECK(report.centre_W.y() < 2.0);
    flight.launch(kHand_W, 0.7, 1.1);
    CHECK_FALSE(flight.report().is_snapped);
}

TEST_CASE("kite flight: more wind pulls harder, more line goes higher, twice the same to the bit") {
    KiteFlight flight{KiteFlightSettings{}};
    fly(flight, 30.0);
    const double pull_N = flight.report().hand_force_W.norm();
    const double height_m = flight.report().centre_W.y();
    flight.set_wind_speed_m_per_s(9.0);
    fly(flight, 30.0);
    CHECK(flight.report().hand_force_W.norm() > 1.5 * pull_N);
    flight.set_wind_speed_m_per_s(6.0);
    for (int i = 0; i < 100; ++i) {
        flight.set_line_length_m(20.0 + 0.1 * i);
        fly(flight, 0.2);
    }
    fly(flight, 30.0);
    CHECK(flight.report().centre_W.y() > height_m + 5.0);
    CHECK(flight.report().line_m == Approx(29.9));
    flight.set_wind_speed_m_per_s(kNan);
    fly(flight, 1.0);
    CHECK(is_finite(flight.report().pose_W));
    KiteFlightSettings settings;
    settings.wind.gustiness = 1.5;
    KiteFlight one(settings);
    KiteFlight other(settings);
    fly(one, 10.0);
    fly(other, 10.0);
    CHECK(one.report().centre_W == other.report().centre_W);
    CHECK(one.report().hand_force_W == other.report().hand_force_W);
}

TEST_CASE("kite flight: on land that lies higher it flies alike, gusts and all") {
    KiteFlightSettings settings;
    settings.wind.gustiness = 1.5;
    KiteFlight low(settings);
    constexpr double kRaised_m = 64.0;  // to the bit
    settings.wind.ground_m = kRaised_m;
    KiteFlight high(settings);
    low.launch(kHand_W, 0.7, 1.1);
    high.launch(kHand_W + Vector3(0.0, kRaised_m, 0.0), 0.7, 1.1);
    for (int i = 0; i < 5000; ++i) {
        low.step(kDt_s, kHand_W);
        high.step(kDt_s, kHand_W + Vector3(0.0, kRaised_m, 0.0));
    }
    CHECK((high.report().centre_W - low.report().centre_W - Vector3(0.0, kRaised_m, 0.0)).norm() <
          1.0e-6);
    CHECK((high.report().wind_W - low.report().wind_W).norm() < 1.0e-6);
}

TEST_CASE("kite flight: the mean wind carries; what is no number or no part is refused") {
    KiteFlight flight{KiteFlightSettings{}};
    fly(flight, 2.0);
    CHECK(flight.report().air_way_m == Approx(12.0));
    flight.set_wind_speed_m_per_s(0.0);
    fly(flight, 1.0);
    CHECK(flight.report().air_way_m == Approx(12.0));
    flight.launch(kHand_W, 0.7, 1.1);
    flight.set_wind_speed_m_per_s(3.0);
    fly(flight, 1.0);
    CHECK(flight.report().air_way_m == Approx(15.0));
    flight = KiteFlight{KiteFlightSettings{}};
    fly(flight, 1.0);
    const Vector3 before_W = flight.report().centre_W;
    flight.step(0.0, kHand_W);
    flight.step(-1.0, kHand_W);
    flight.step(kNan, kHand_W);
    flight.step(kDt_s, {kNan, 0.0, 0.0});
    flight.launch({kNan, 0.0, 0.0}, 0.7, 1.1);
    flight.launch(kHand_W, kNan, 1.1);
    flight.launch(kHand_W, 0.7, kNan);
    CHECK(flight.report().centre_W == before_W);
    using F = KiteFlightSettings;
    check_refused(F{}, {{&F::gravity_m_per_s2, -1.0},
                        {&F::ground_N_per_m, 0.0},
                        [](F& all) { all.kite.height_m = 0.0; },
                        [](F& all) { all.line.segments = 0; },
                        [](F& all) { all.wind.speed_m_per_s = -1.0; }});
}

TEST_CASE("kite flight: gusts that change once in some steps are those of steps as long") {
    KiteFlightSettings settings;
    settings.wind.gustiness = 1.0;
    settings.line.length_m = 20.0;
    KiteFlight coarse(settings);
    settings.steps_a_gust = 4;
    KiteFlight fine(settings);
    KiteFlightSettings own = settings;
    own.steps_a_gust = 1;
    KiteFlight other(own);
    for (KiteFlight* flight : {&coarse, &fine, &other}) {
        flight->launch(kHand_W, 0.7, 1.1);
    }
    fly(coarse, 0.5);
    fly(fine, 0.5, 0.25 * kDt_s);
    fly(other, 0.5, 0.25 * kDt_s);
    const auto apart_m = [&](const KiteFlight& flight) {
        return (flight.report().centre_W - coarse.report().centre_W).norm();
    };
    INFO(apart_m(fine) << " m, in gusts of its own " << apart_m(other) << " m");
    constexpr double kStepsOwn = 0.25;  // what is left is backward Euler's error of the steps
    CHECK(apart_m(fine) < kStepsOwn * apart_m(other));
    settings.steps_a_gust = 0;
    CHECK(is_refused(validate(settings), "gusts"));
    settings.steps_a_gust = 101;
    CHECK(is_refused(validate(settings), "gusts"));
}
