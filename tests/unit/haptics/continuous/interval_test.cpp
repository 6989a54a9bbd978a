// Intervals that hold the exact result (interval.h), and what is made of them: the height of a contact over a turn (turn_function.h).
#include "haptics/continuous/interval.h"

#include "haptics/continuous/turn_function.h"
#include "tests/support/continuous_trial.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <limits>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Numbers of every size, those at the ends of the range among them.
double draw_number(Random& random) {
    static const std::vector<double> kHard{0.0,      -0.0,      1.0,      -1.0,
                                           5.0e-324, -5.0e-324, 1.0e-308, -3.0e-309,
                                           1.7e308,  -1.7e308,  1.0e-160, 0.1};
    const auto which = random.integer() % 40;
    if (which < kHard.size()) {
        return kHard[which];
    }
    return random.uniform() *
           std::pow(10.0, which % 2 == 0 ? 3.0 * random.uniform() : 300.0 * random.uniform());
}
struct Drawn {
    Interval all;
    double one = 0.0;  // in it
};
Drawn draw_interval(Random& random) {
    const double first = draw_number(random);
    switch (random.integer() % 8) {
        case 0:
            return {Interval::at(first), first};
        case 1:
            return {{first, kInfinity}, std::max(first, draw_number(random))};
        case 2:
            return {{-kInfinity, first}, std::min(first, draw_number(random))};
        case 3: {  // neighbours
            const double next = std::nextafter(first, kInfinity);
            return {Interval::between(first, next), random.uniform() < 0.0 ? first : next};
        }
        default: {
            const Interval made = Interval::between(first, draw_number(random));
            const double share = 0.5 + 0.5 * random.uniform();
            const double within = made.lower * (1.0 - share) + made.upper * share;
            return {made, std::clamp(within, made.lower, made.upper)};
        }
    }
}
// Is the exact result, held in more digits than a double has, within? (What a long double rounds is far below the bounds' reserve.)
bool holds(const Interval& interval, long double exact) {
    return static_cast<long double>(interval.lower) <= exact &&
           exact <= static_cast<long double>(interval.upper);
}
void check_operations(unsigned seed, int n) {
    Random random(seed);
    for (int i = 0; i < n; ++i) {
        const auto [a, x] = draw_interval(random);
        const auto [b, y] = draw_interval(random);
        CAPTURE(a.lower, a.upper, x, b.lower, b.upper, y);
        const long double exact_x = x;
        const long double exact_y = y;
        REQUIRE(holds(a + b, exact_x + exact_y));
        REQUIRE(holds(a - b, exact_x - exact_y));
        REQUIRE(holds(a * b, exact_x * exact_y));
        REQUIRE(holds(x * b, exact_x * exact_y));
        REQUIRE(holds(-a, -exact_x));
        if (y != 0.0) {
            REQUIRE(holds(a / b, exact_x / exact_y));
        }
        REQUIRE(hull(a, b).contains(x));
        REQUIRE(hull(a, b).contains(y));
        REQUIRE(intersect(a, b).contains(x) == b.contains(x));
        REQUIRE(a.least_magnitude() <= std::abs(x));
        REQUIRE(a.greatest_magnitude() >= std::abs(x));
    }
}
TEST_CASE("interval: what an operation gives lies in what it gives of intervals") {
    check_operations(1, 20000);
}
// Any angle that has one; every third near a quarter of pi, where the series change.
double draw_angle(Random& random, int i) {
    const double angle = i % 3 == 0
                             ? 0.25 * M_PI * static_cast<double>(random.integer() % 5) +
                                   std::pow(10.0, -8.0 + 7.0 * random.uniform()) * random.uniform()
                             : 1.6 + 1.6 * random.uniform();
    return std::clamp(angle, 0.0, kMostAngle_rad);
}
// The greatest error of sine and cosine.
double find_sine_error(unsigned seed, int n) {
    Random random(seed);
    long double worst = 0.0L;
    for (int i = 0; i < n; ++i) {
        const double angle = draw_angle(random, i);
        const SineCosine turn = compute_sine_cosine(angle);
        worst = std::max({worst, std::abs(turn.sine - std::sin(static_cast<long double>(angle))),
                          std::abs(turn.cosine - std::cos(static_cast<long double>(angle)))});
    }
    return static_cast<double>(worst);
}
void check_sine_intervals(unsigned seed, int n) {
    Random random(seed);
    for (int i = 0; i < n; ++i) {
        const double first = 1.6 + 1.6 * random.uniform();
        const double width = i % 2 == 0 ? 1.6 : std::pow(10.0, -6.0 + 6.0 * random.uniform());
        const double last = std::clamp(first + width * random.uniform(), 0.0, kMostAngle_rad);
        // Every fifth a single angle.
        const Interval angles =
            i % 5 == 0 ? Interval::at(draw_angle(random, i)) : Interval::between(first, last);
        const double angle = std::clamp(
            angles.lower + (angles.upper - angles.lower) * (0.5 + 0.5 * random.uniform()),
            angles.lower, angles.upper);
        const SineCosineInterval turn = enclose_sine_cosine(angles);
        CAPTURE(angles.lower, angles.upper, angle);
        REQUIRE(holds(turn.sine, std::sin(static_cast<long double>(angle))));
        REQUIRE(holds(turn.cosine, std::cos(static_cast<long double>(angle))));
        // No wider than the angles are apart, but for the corners' margin.
        const double apart = angles.upper - angles.lower;
        REQUIRE(turn.sine.upper - turn.sine.lower <= apart + 1.0e-8);
        if (angles.upper <= M_PI) {
            REQUIRE(turn.cosine.upper - turn.cosine.lower <= apart + 1.0e-8);
        }
    }
}
TEST_CASE("interval: so it does whichever way the processor rounds, sine and cosine too") {
    struct RestoredMode {
        ~RestoredMode() { std::fesetround(FE_TONEAREST); }
    } const restored;
    for (const int mode : {FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO}) {
        REQUIRE(std::fesetround(mode) == 0);
        // The long doubles are rounded the same way, by far less than the bounds' reserve.
        check_operations(2, 6000);
        check_sine_intervals(5, 20000);
        CHECK(find_sine_error(6, 50000) < kSineError);
    }
}
TEST_CASE("interval: no number is claimed where there is none") {
    for (const Interval& none :
         {Interval::at(kNone), Interval::between(kNone, 1.0), Interval::between(1.0, kNone),
          Interval::around(kNone, 1.0), Interval::around(1.0, kNone)}) {
        CHECK(none.lower == -kInfinity);
        CHECK(none.upper == kInfinity);
        CHECK_FALSE(none.is_bounded());
    }
    const Interval all = Interval::all();
    for (const Interval& result :
         {all + all, all - all, all * all, all / all, all * Interval::at(0.0),
          Interval::at(1.0) / Interval::between(-1.0, 1.0), Interval::at(1.0) / Interval::at(0.0),
          Interval::at(kNone) * Interval::at(2.0)}) {
        CHECK(result.lower == -kInfinity);
        CHECK(result.upper == kInfinity);
    }
    // Too large for a double: the end that is left is the greatest number.
    const Interval huge = Interval::at(1.0e300) * Interval::at(1.0e300);
    CHECK(huge.upper == kInfinity);
    CHECK(holds(huge, 1.0e600L));
    // Zero times anything is zero, whatever bounds it.
    CHECK((Interval::at(0.0) * Interval{1.0, kInfinity}).contains(0.0));
    CHECK(is_empty(intersect(Interval{0.0, 1.0}, Interval{2.0, 3.0})));
    CHECK_FALSE(is_empty(intersect(Interval{0.0, 1.0}, Interval{1.0, 3.0})));
}
TEST_CASE("interval: it is four units in the last place wide, not more") {
    const Interval sum = Interval::at(1.0) + Interval::at(2.0);
    CHECK(sum.upper - sum.lower <= 3.0 * 0x1.0p-48);
    CHECK(sum.lower < 3.0);
    CHECK(sum.upper > 3.0);
}
TEST_CASE("interval: sine and cosine are within 2^-50, by the C library's in more digits") {
    CHECK(find_sine_error(3, 400000) < 0.5 * kSineError);
    CHECK(compute_sine_cosine(0.0).sine == 0.0);
    CHECK(compute_sine_cosine(0.0).cosine == 1.0);
    for (const double bad : {-1.0e-300, 3.21, kNone, kInfinity}) {
        CHECK(std::isnan(compute_sine_cosine(bad).sine));
        CHECK(std::isnan(compute_sine_cosine(bad).cosine));
    }
}
TEST_CASE("interval: sine and cosine hold those of every angle in it, and little more") {
    check_sine_intervals(4, 100000);
    CHECK(enclose_sine_cosine(Interval::all()).sine.lower == -1.0);
    CHECK(enclose_sine_cosine({-0.1, 0.1}).cosine.upper == 1.0);
    // Zero, as it is after a multiplication.
    const SineCosineInterval still = enclose_sine_cosine(0.0 * Interval::at(1.0));
    CHECK(still.cosine.lower > 1.0 - 1.0e-14);
    CHECK(still.sine.greatest_magnitude() < 1.0e-14);
    CHECK(enclose_sine_cosine({0.0, M_PI}).cosine.lower == -1.0);
    CHECK(enclose_sine_cosine({0.0, M_PI}).sine.upper == 1.0);
}

struct Named {
    FeaturePair pair;
    std::uint8_t i;
    std::uint8_t j;
};

using LongVector = Matrix<long double, 3, 1>;
using LongTriangle = std::array<LongVector, 3>;

// Where the corners' paths are at t, in eleven binary digits more than the bounds have: a path's vectors are what they are.
LongTriangle find_long_place(const InBetweenMotion& motion, const MovingTriangle& moving,
                             double t) {
    const long double angle = static_cast<long double>(t) * motion.angle_rad();
    LongTriangle place;
    for (std::size_t i = 0; i < 3; ++i) {
        const PointPath& path = moving.corners[i];
        place[i] = path.a.cast<long double>() +
                   static_cast<long double>(t) * motion.travel_A().cast<long double>() +
                   std::cos(angle) * path.b.cast<long double>() +
                   std::sin(angle) * path.c.cast<long double>();
    }
    return place;
}

LongVector find_normal(const LongTriangle& t) {
    return (t[1] - t[0]).cross(t[2] - t[0]);
}
LongVector find_edge(const LongTriangle& t, std::uint8_t i) {
    return t[(i + 1U) % 3U] - t[i];
}

// Redon's equation as it stands, from corners at t; and what a metre makes of it at most: the length of the normal, of two edges that of both.
struct Height {
    long double here, per_m;
};
Height find_height(const Named& named, const LongTriangle& fixed, const LongTriangle& moving) {
    if (named.pair == FeaturePair::face_vertex) {
        const LongVector normal = find_normal(fixed);
        return {normal.dot(moving[named.j] - fixed[0]), normal.norm()};
    }
    if (named.pair == FeaturePair::vertex_face) {
        const LongVector normal = find_normal(moving);
        return {normal.dot(fixed[named.i] - moving[0]), normal.norm()};
    }
    const LongVector held = find_edge(fixed, named.i);
    const LongVector edge = find_edge(moving, named.j);
    return {held.cross(edge).dot(moving[named.j] - fixed[named.i]), held.norm() * edge.norm()};
}

TEST_CASE("turn function: it holds heights and rates of all fifteen contacts, without a margin") {
    Random random(1);
    for (int trial = 0; trial < 400; ++trial) {
        const TrianglePair pair =
            trial % 4 == 0 ? draw_hard_pair(random, trial / 4 % kHardPairs) : draw_pair(random);
        const InBetweenMotion motion = pair.motion();
        const MovingTriangle moving = MovingTriangle::of(motion, pair.moving_B);
        const SweepBounds bounds =
            SweepBounds::of(motion, moving.reach_m, find_reach_m(pair.fixed_A), {});
        const LongTriangle fixed{pair.fixed_A[0].cast<long double>(),
                                 pair.fixed_A[1].cast<long double>(),
                                 pair.fixed_A[2].cast<long double>()};
        for (std::uint8_t k = 0; k < 15; ++k) {
            const Named named =
                k < 3   ? Named{FeaturePair::face_vertex, 0, k}
                : k < 6 ? Named{FeaturePair::vertex_face, static_cast<std::uint8_t>(k - 3), 0}
                        : Named{FeaturePair::edge_edge, static_cast<std::uint8_t>((k - 6) / 3),
                                static_cast<std::uint8_t>((k - 6) % 3)};
            const TurnFunction f = make_turn_function(motion, pair.fixed_A, moving, named.pair,
                                                      named.i, named.j, bounds);
            const double t = 0.5 + 0.499 * random.uniform();
            const auto height = [&](double at) {
                return find_height(named, fixed, find_long_place(motion, moving, at)).here;
            };
            const double size = bounds.length_m * bounds.length_m * bounds.length_m;
            const Interval times = Interval::between(t, std::min(1.0, t + 1.0e-3));
            const Interval here = f.find_value(Interval::at(t), motion.turn_over(Interval::at(t)));
            CAPTURE(trial, k, t);
            REQUIRE(holds(here, height(t)));
            REQUIRE(here.upper - here.lower <= 1.0e-11 * size);
            const Interval over = f.find_value(times, motion.turn_over(times));
            REQUIRE(holds(over, height(times.upper)));
            // The mean value theorem, with the rate over all of the time.
            const Interval rate = f.find_rate(times, motion.turn_over(times));
            const Interval passed = Interval::at(times.upper) - Interval::at(t);
            REQUIRE(holds(here + rate * passed, height(times.upper)));
            REQUIRE(rate.upper - rate.lower <= 0.1 * size);
            // A metre more of distance is at most so much, and no bound is far above it.
            const long double per_m =
                find_height(named, fixed, find_long_place(motion, moving, 0.0)).per_m;
            REQUIRE(static_cast<long double>(f.per_m) >= per_m);
            REQUIRE(static_cast<long double>(f.per_m) <=
                    per_m + 1.0e-12L * bounds.length_m * bounds.length_m);
        }
    }
}

}  // namespace
}  // namespace fulcrum
