#include "haptics/device/simulated/delay_line.h"
#include "haptics/device/simulated/random_hand.h"
#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/math/rotation.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

using namespace fulcrum;

namespace {

using Course = std::vector<std::pair<double, double>>;

constexpr double kDt_s = 0.001;
constexpr double kRounding = 1e-9;

// A hand with its target, and its clock.
struct Bench {
    DeviceReading run(int n, double dt_s = kDt_s) {
        DeviceReading reading;
        for (int i = 0; i < n; ++i) {
            now_s += dt_s;
            REQUIRE(hand.read(now_s, reading));
        }
        return reading;
    }

    LatestValue<HandTarget> target;
    SimulatedHand hand{SimulatedHandSettings{}, target};
    double now_s = 0.0;
};

HandTarget at(const Vector3& position_D) {
    HandTarget target;
    target.pose_D.position = position_D;
    return target;
}

std::vector<HandTarget> play(std::uint64_t seed, double seconds, RandomHand* kept = nullptr) {
    RandomHand hand(seed);
    std::vector<HandTarget> wanted;
    HandTarget planned;
    planned.buttons = 1;
    planned.sees_thing = true;
    planned.thing_D = {0.02, 0.15, 0.01};
    for (double now_s = 0.0; now_s < seconds; now_s += kDt_s) {
        planned.pose_D.position = Vector3(0.1 * std::sin(now_s), 0.2, 0.0);
        wanted.push_back(hand.step(now_s, planned));
        wanted.back().pose_D.position -= planned.pose_D.position;
        REQUIRE(wanted.back().buttons == (hand.holds() ? 1U : 0U));
    }
    if (kept != nullptr) {
        *kept = hand;
    }
    return wanted;
}

Course run(DelayLine<double>& line, double from_s, double to_s, double& acting) {
    Course course;
    line.run(from_s, to_s, acting, [&](double dt_s) { course.emplace_back(acting, dt_s); });
    return course;
}

}  // namespace

TEST_CASE("simulated hand: goes to its target, and a force moves it by f / k") {
    Bench bench;
    bench.target.publish(at(Vector3(0.1, 0.2, -0.05)));
    CHECK((bench.run(2000).pose_D.position - Vector3(0.1, 0.2, -0.05)).norm() < 1e-6);
    CHECK(bench.hand.write(bench.now_s, {Vector3(0.0, -3.0, 0.0), Vector3::Zero()}));
    const DeviceReading loaded = bench.run(2000);
    CHECK((loaded.pose_D.position - Vector3(0.1, 0.2 - 3.0 / 300.0, -0.05)).norm() < 1e-6);
    CHECK(loaded.stamp_s == bench.now_s);
}

TEST_CASE("simulated hand: the way there does not depend on the time step") {
    Vector3 ends[3];
    int i = 0;
    for (const int n : {1, 10, 1000}) {
        Bench bench;
        DeviceReading reading;
        REQUIRE(bench.hand.read(0.0, reading));
        bench.target.publish(at(Vector3(0.1, 0.0, 0.0)));
        REQUIRE(bench.hand.write(0.0, {Vector3(0.0, 2.0, 0.0), Vector3::Zero()}));
        ends[i++] = bench.run(n, 0.1 / n).pose_D.position;
    }
    CHECK((ends[0] - ends[1]).norm() < kRounding);
    CHECK((ends[0] - ends[2]).norm() < kRounding);
    CHECK(ends[0].norm() > 0.01);
}

TEST_CASE("simulated hand: no lag when told the velocity; turns, and gives way by tau / k") {
    Bench bench;
    double lag_m = 0.0;
    for (int k = 0; k < 3000; ++k) {
        HandTarget moving = at(Vector3(0.1 * (bench.now_s + kDt_s), 0.0, 0.0));
        moving.velocity_D = Vector3(0.1, 0.0, 0.0);
        bench.target.publish(moving);
        lag_m = moving.pose_D.position.x() - bench.run(1).pose_D.position.x();
    }
    CHECK(std::abs(lag_m) <
          0.1 * kDt_s);  // a step's way at most; without the velocity b v / k = 6.7 mm
    CHECK(bench.hand.velocity_D().x() ==
          Approx(0.1).epsilon(1e-4));  // the target steps, so it ripples
    Bench other;
    HandTarget turned;
    const Vector3 turn(0.3, -0.5, 0.2);
    turned.pose_D.orientation = compute_exp(turn);
    other.target.publish(turned);
    const DeviceReading there = other.run(3000);
    CHECK((compute_log(there.pose_D.orientation) - turn).norm() < 1e-6);
    CHECK(other.hand.write(other.now_s, {Vector3::Zero(), Vector3(0.0, 0.0, 0.3)}));
    const DeviceReading loaded = other.run(3000);
    const Quaternion away = loaded.pose_D.orientation * turned.pose_D.orientation.conjugate();
    CHECK((compute_log(away) - Vector3(0.0, 0.0, 0.1)).norm() < 1e-6);
    CHECK(loaded.pose_D.orientation.coeffs().norm() == Approx(1.0).epsilon(1e-14));
}

TEST_CASE("simulated hand: turns like a damped oscillator in closed form, whatever the steps") {
    const SimulatedHandSettings settings;
    Bench bench;
    DeviceReading reading;
    REQUIRE(bench.hand.read(0.0, reading));
    HandTarget turned;
    turned.pose_D.orientation = compute_exp(Vector3(0.0, 0.0, 0.4));
    bench.target.publish(turned);
    // Underdamped: e = -0.4 e^(-at) (cos wt + a/w sin wt).
    const double a = 0.5 * settings.turn_damping_Nms_per_rad / settings.inertia_kg_m2;
    const double w = std::sqrt(settings.turn_stiffness_Nm_per_rad / settings.inertia_kg_m2 - a * a);
    double t_s = 0.0;
    for (int k = 0; k < 300; ++k) {
        t_s += k % 2 == 0 ? 0.001 : 0.0013;
        REQUIRE(bench.hand.read(t_s, reading));
        const double left = std::exp(-a * t_s) * (std::cos(w * t_s) + a / w * std::sin(w * t_s));
        REQUIRE(compute_log(reading.pose_D.orientation).z() ==
                Approx(0.4 * (1.0 - left)).margin(1e-9));
    }
}

TEST_CASE("random hand: in minutes it does all that it can, and stays near and whole") {
    std::array<std::uint64_t, kHandDeeds> done{};
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        RandomHand hand(0);
        const auto wanted = play(seed, 120.0, &hand);
        CAPTURE(seed);
        std::ranges::transform(done, hand.done(), done.begin(), std::plus<>());
        double farthest_m = 0.0;
        for (const HandTarget& target : wanted) {
            REQUIRE(is_usable(target));
            farthest_m = std::max(farthest_m, target.pose_D.position.norm());
        }
        CHECK(farthest_m <= RandomHand::kFarthest_m + 1e-12);
        CHECK(farthest_m > 0.05);
    }
    CHECK(*std::ranges::min_element(done) >= 20);
}

TEST_CASE(
    "random hand: it follows at least as often as it does not, and one deed leads to the next") {
    RandomHand hand(0);
    const auto wanted = play(5, 120.0, &hand);
    std::uint64_t others = 0;
    for (std::size_t i = 1; i < kHandDeeds; ++i) {
        others += hand.done()[i];
    }
    CHECK(hand.done()[0] >= others);
    // No leap: the fastest is a jerk, 2 pi 8 Hz 4 cm, and what it cut short, on top of the quickest way there.
    constexpr double kFastest_m_per_s = 2.1 + 6.0;
    for (std::size_t i = 1; i < wanted.size(); ++i) {
        const Vector3 way = wanted[i].pose_D.position - wanted[i - 1].pose_D.position;
        REQUIRE(way.norm() <= kFastest_m_per_s * kDt_s);
    }
}

TEST_CASE(
    "random hand: it finds a thing that it sees, stays at it, and lifts off a gate that waits") {
    // A ball of 4 cm that pushes as a spring; once it was let go its gate waits until nobody presses.
    const Vector3 middle_D(0.02, 0.15, 0.01);
    constexpr double kRadius_m = 0.04;
    constexpr double kStiffness_N_per_m = 300.0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        RandomHand hand(seed);
        HandTarget planned = at(Vector3(0.0, 0.25, 0.0));
        planned.sees_thing = true;
        planned.thing_D = middle_D;
        HandFeeling felt;
        bool waits = false;
        int n_felt = 0;
        int n_reopened = 0;
        for (int tick = 0; tick < 60'000; ++tick) {
            felt.position_D = hand.step(kDt_s * tick, planned, felt).pose_D.position;
            const Vector3 out_D = felt.position_D - middle_D;
            const double deep_m = std::max(kRadius_m - out_D.norm(), 0.0);
            n_reopened += waits && deep_m == 0.0 ? 1 : 0;
            waits = tick % 5000 == 0 || (waits && deep_m > 0.0);
            felt.force_D = out_D.norm() > 0.0 && !waits
                               ? Vector3(out_D * (kStiffness_N_per_m * deep_m / out_D.norm()))
                               : Vector3(Vector3::Zero());
            n_felt += felt.force_D.norm() > 0.05 ? 1 : 0;
        }
        CAPTURE(seed);
        CHECK(n_felt > 30'000);
        CHECK(n_reopened >= 10);
    }
}

TEST_CASE("random hand: one seed is one hand, another is another") {
    const auto once = play(7, 20.0);
    const auto again = play(7, 20.0);
    const auto other = play(8, 20.0);
    bool is_other = false;
    for (std::size_t i = 0; i < once.size(); ++i) {
        REQUIRE(once[i].pose_D.position == again[i].pose_D.position);
        is_other = is_other || once[i].pose_D.position != other[i].pose_D.position;
    }
    CHECK(is_other);
}

// Forces on their way: each acts from its own time to the next one's, and none is lost but those that say so.

TEST_CASE("delay line: every force acts from its time to the next one's") {
    DelayLine<double> line;
    double acting = 7.0;
    REQUIRE(line.put(0.25, 1.0, 0.0, acting));
    REQUIRE(line.put(0.5, 2.0, 0.0, acting));
    REQUIRE(line.put(2.0, 3.0, 0.0, acting));
    CHECK(acting == 7.0);
    CHECK(run(line, 0.0, 1.0, acting) == Course{{7.0, 0.25}, {1.0, 0.25}, {2.0, 0.5}});
    CHECK(acting == 2.0);
    CHECK(run(line, 1.0, 2.0, acting) == Course{{2.0, 1.0}});
    CHECK(acting == 3.0);
    CHECK(run(line, 2.0, 2.5, acting) == Course{{3.0, 0.5}});
}

TEST_CASE("delay line: what is due at once overtakes nothing; times a rounding apart are one") {
    DelayLine<double> line;
    double acting = 0.0;
    REQUIRE(line.put(1.0, 1.0, 1.0, acting));
    CHECK(acting == 1.0);
    REQUIRE(line.put(1.5, 2.0, 1.0, acting));
    REQUIRE(line.put(1.0, 3.0, 1.0, acting));
    CHECK(acting == 1.0);
    CHECK(run(line, 1.0, 2.0, acting) == Course{{1.0, 0.5}, {3.0, 0.5}});
    CHECK(acting == 3.0);
    line = DelayLine<double>();
    acting = 0.0;
    REQUIRE(line.put(1.0 + 5.0e-13, 1.0, 0.0, acting));
    const Course course = run(line, 0.0, 1.0, acting);
    REQUIRE(course.size() == 1);
    CHECK(course[0].first == 0.0);
    CHECK(course[0].second == Approx(1.0).margin(1.0e-12));
    CHECK(acting == 1.0);
}

TEST_CASE("delay line: more than there is room for are refused, and what is cleared never acts") {
    DelayLine<double> line;
    double acting = -1.0;
    constexpr auto kMost = DelayLine<double>::kMost;
    for (int round = 0; round < 3; ++round) {
        for (std::size_t i = 0; i < kMost; ++i) {
            REQUIRE(line.put(1.0 + static_cast<double>(i), static_cast<double>(i), 0.0, acting));
        }
        CHECK_FALSE(line.put(1000.0, 9.0, 0.0, acting));
        const Course course = run(line, 0.0, 1000.0, acting);
        REQUIRE(course.size() == kMost + 1);
        for (std::size_t i = 1; i <= kMost; ++i) {
            REQUIRE(course[i].first == static_cast<double>(i - 1));
        }
        acting = -1.0;
        // One more, so that the next round begins elsewhere in the ring.
        REQUIRE(line.put(1.0, 5.0, 0.0, acting));
        CHECK(run(line, 0.0, 1.0, acting) == Course{{-1.0, 1.0}});
        acting = -1.0;
    }
    line = DelayLine<double>();
    acting = 4.0;
    REQUIRE(line.put(1.0, 1.0, 0.0, acting));
    line.clear();
    CHECK(run(line, 0.0, 2.0, acting) == Course{{4.0, 2.0}});
}
