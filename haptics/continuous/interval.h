// Intervals of real numbers with outward rounding: whatever numbers lie in the operands, the exact result lies in the result.
//
//   [a] op [b]  contains  { x op y : x in [a], y in [b] }      an end that no number bounds is infinite
// An end x that was computed is moved outwards by w = 2^-50 |x| + 2^-1000. That is enough in every rounding mode, with denormal numbers
// or without, contracted or not: with v = 2^-52 an operation's exact result e has |x - e| <= v |x| + 2^-1022 (the second where results
// are flushed to zero), and x - w is rounded by at most v (|x| + w) + 2^-1022 again; both together are below 2^-50 |x| + 2^-1000 - 2 v w,
// so the rounded x - w is at most e, and the rounded x + w at least. It costs four operations without a branch, and four ulp where
// nextafter would cost one. Beyond 2^1023, and where it is not a number, an end becomes infinite: nothing is claimed then. Where denormal
// numbers are read as zeros, they are zeros.
//
// Sine and cosine are this file's own, by their series, not the C library's: so their error has a proof, and every machine finds the
// same numbers. See interval.cpp.
//
// Thread: any. Cost: 1 to 8 ns an operation.
// Source: R. E. Moore, R. B. Kearfott, M. J. Cloud 2009, Introduction to Interval Analysis, SIAM, chapters 2 (arithmetic), 3.4 (outward
// rounding) and 6.1 (mean value form).
#pragma once

#include "haptics/math/spatial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#ifdef __FAST_MATH__
#error "intervals need the arithmetic of IEEE 754: compile without -ffast-math"
#endif

namespace fulcrum {

struct Interval {
    static constexpr double kInfinite = std::numeric_limits<double>::infinity();

    double lower = 0.0;
    double upper = 0.0;

    /// Just this number; not-a-number becomes all numbers.
    [[nodiscard]] static constexpr Interval at(double x) noexcept {
        return x == x ? Interval{x, x} : all();
    }
    /// Between two numbers, given in any order; one that is not a number becomes all numbers.
    [[nodiscard]] static constexpr Interval between(double x, double y) noexcept {
        return x <= y ? Interval{x, y} : (y < x ? Interval{y, x} : all());
    }
    /// Within `error` >= 0 of `x`.
    [[nodiscard]] static Interval around(double x, double error) noexcept;
    [[nodiscard]] static constexpr Interval all() noexcept { return {-kInfinite, kInfinite}; }

    [[nodiscard]] constexpr bool contains(double x) const noexcept {
        return lower <= x && x <= upper;
    }
    [[nodiscard]] constexpr bool is_bounded() const noexcept {
        return lower > -kInfinite && upper < kInfinite;
    }
    /// A number in it, of a bounded one about the middle.
    [[nodiscard]] constexpr double middle() const noexcept { return 0.5 * lower + 0.5 * upper; }
    /// The least and the greatest magnitude of what it holds.
    [[nodiscard]] constexpr double least_magnitude() const noexcept {
        return lower > 0.0 ? lower : (upper < 0.0 ? -upper : 0.0);
    }
    [[nodiscard]] constexpr double greatest_magnitude() const noexcept {
        return std::max(-lower, upper);
    }
};

namespace interval_details {

inline constexpr double kRelative = 0x1.0p-50;
inline constexpr double kAbsolute = 0x1.0p-1000;

inline constexpr double kHuge = 0x1.0p+1023;

// What is not a number fails both comparisons. Huge numbers are as good as infinite: rounded towards zero, they would stay finite.
[[nodiscard]] inline double round_down(double x) noexcept {
    const double below = x - (std::abs(x) * kRelative + kAbsolute);
    if (!(below > -kHuge)) {
        return -Interval::kInfinite;
    }
    return below;
}
[[nodiscard]] inline double round_up(double x) noexcept {
    const double above = x + (std::abs(x) * kRelative + kAbsolute);
    if (!(above < kHuge)) {
        return Interval::kInfinite;
    }
    return above;
}

}  // namespace interval_details

[[nodiscard]] inline Interval widen(double lower, double upper) noexcept {
    return {interval_details::round_down(lower), interval_details::round_up(upper)};
}

inline Interval Interval::around(double x, double error) noexcept {
    return widen(x - error, x + error);
}

[[nodiscard]] inline Interval operator-(const Interval& a) noexcept {
    return {-a.upper, -a.lower};
}
[[nodiscard]] inline Interval operator+(const Interval& a, const Interval& b) noexcept {
    return widen(a.lower + b.lower, a.upper + b.upper);
}
[[nodiscard]] inline Interval operator-(const Interval& a, const Interval& b) noexcept {
    return widen(a.lower - b.upper, a.upper - b.lower);
}
/// Zero times an infinite end, not a number, is passed over (std::min and std::max keep their first argument then): the other products
/// hold what is needed, or all four are none and nothing is claimed.
[[nodiscard]] inline Interval operator*(const Interval& a, const Interval& b) noexcept {
    double least = Interval::kInfinite;
    double most = -Interval::kInfinite;
    for (const double product :
         {a.lower * b.lower, a.lower * b.upper, a.upper * b.lower, a.upper * b.upper}) {
        least = std::min(least, product);
        most = std::max(most, product);
    }
    return least <= most ? widen(least, most) : Interval::all();
}
[[nodiscard]] inline Interval operator*(double a, const Interval& b) noexcept {
    return Interval::at(a) * b;
}
/// By an interval with zero in it: all numbers.
[[nodiscard]] inline Interval operator/(const Interval& a, const Interval& b) noexcept {
    if (b.contains(0.0) || !(b.lower <= b.upper)) {
        return Interval::all();
    }
    return a * widen(1.0 / b.upper, 1.0 / b.lower);
}

[[nodiscard]] inline Interval hull(const Interval& a, const Interval& b) noexcept {
    return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}
/// What both hold; where that is nothing, `lower` is above `upper`.
[[nodiscard]] inline Interval intersect(const Interval& a, const Interval& b) noexcept {
    return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}
[[nodiscard]] inline bool is_empty(const Interval& a) noexcept {
    return !(a.lower <= a.upper);
}

/// Three intervals: a box that a point lies in.
using IntervalVector = std::array<Interval, 3>;

[[nodiscard]] inline Interval dot(const Vector3& a, const IntervalVector& b) noexcept {
    return a.x() * b[0] + a.y() * b[1] + a.z() * b[2];
}

/// A rotation's two numbers.
struct SineCosine {
    double sine = 0.0;
    double cosine = 1.0;
};

/// The largest angle whose sine and cosine are told, radians: pi and a little.
inline constexpr double kMostAngle_rad = 3.2;
/// By how much either may be wrong. The proof stands in interval.cpp.
inline constexpr double kSineError = 0x1.0p-50;

/// Of an angle from 0 to kMostAngle_rad; beyond, and of no number, not-a-number.
[[nodiscard]] SineCosine compute_sine_cosine(double angle_rad) noexcept;

struct SineCosineInterval {
    Interval sine;
    Interval cosine;
};

/// Of all angles in the interval. Where it leaves 0 to kMostAngle_rad: between -1 and 1.
[[nodiscard]] SineCosineInterval enclose_sine_cosine(const Interval& angle_rad) noexcept;

}  // namespace fulcrum
