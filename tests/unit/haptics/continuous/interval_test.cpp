#include "haptics/continuous/interval.h"

#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
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

TEST_CASE(
    "interval: sine and cosine of an interval hold those of every angle in it, and little more") {
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

}  // namespace
}  // namespace fulcrum
