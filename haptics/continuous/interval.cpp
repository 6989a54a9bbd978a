// Sine and cosine of x, 0 <= x <= 3.2, and why either errs by less than 2^-50. With v = 2^-52, what an operation errs by at most for
// results up to 1, in any rounding mode:
//   1. n, the integer nearest to x / (pi / 2), is 0, 1 or 2. pi / 2 = P + Q + r, P of 29 bits, so n P and x - n P are exact (for n > 0 they
//      are within a factor of 2: Sterbenz), |r| < 2^-82. y = (x - n P) - n Q errs by |y| v + 2^-80 < 0.8 v, and so do sine and cosine of it.
//   2. |y| < 0.7860. The series of the sine is left at y^17, that of the cosine at y^16; their terms alternate and fall, so what is left
//      out is below 0.786^19 / 19! < 2^-63 and 0.786^18 / 18! < 2^-58.
//   3. Horner's rule errs by sum_k (2 k + 2) v |c_k| z^k, z = y^2 < 0.618, which itself errs by v z: for the cosine's part
//      z (1/2 - z/24 + ...) below z (5/2 + 7 z / 24 + ...) v < 1.7 v, for the sine's y z (1/6 - ...) below 0.49 (5/6 + ...) v < 0.5 v.
//   4. The last sum errs by v at most.
// Together below (0.8 + 1.7 + 1 + 0.1) v < 4 v = 2^-50.
#include "haptics/continuous/interval.h"

namespace fulcrum {
namespace {

constexpr double kHalfPi = 0x1.921fb54p+0;             // P
constexpr double kHalfPiRest = 0x1.10b4611a62633p-30;  // Q
constexpr double kQuarterPi = 0.78539816339744831;
// A little on either side of pi / 2 and pi.
constexpr double kBelowHalfPi = 1.5707;
constexpr double kAboveHalfPi = 1.5709;
constexpr double kBelowPi = 3.1415;

double compute_sine_series(double y, double z) noexcept {
    double sum = 1.0 / 355687428096000.0;
    sum = sum * z - 1.0 / 1307674368000.0;
    sum = sum * z + 1.0 / 6227020800.0;
    sum = sum * z - 1.0 / 39916800.0;
    sum = sum * z + 1.0 / 362880.0;
    sum = sum * z - 1.0 / 5040.0;
    sum = sum * z + 1.0 / 120.0;
    sum = sum * z - 1.0 / 6.0;
    return y + y * (z * sum);
}

double compute_cosine_series(double z) noexcept {
    double sum = 1.0 / 20922789888000.0;
    sum = sum * z - 1.0 / 87178291200.0;
    sum = sum * z + 1.0 / 479001600.0;
    sum = sum * z - 1.0 / 3628800.0;
    sum = sum * z + 1.0 / 40320.0;
    sum = sum * z - 1.0 / 720.0;
    sum = sum * z + 1.0 / 24.0;
    sum = sum * z - 0.5;
    return 1.0 + z * sum;
}

}  // namespace

SineCosine compute_sine_cosine(double angle_rad) noexcept {
    if (!(angle_rad >= 0.0 && angle_rad <= kMostAngle_rad)) {
        constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
        return {kNone, kNone};
    }
    const int quarter = (angle_rad > kQuarterPi ? 1 : 0) + (angle_rad > 3.0 * kQuarterPi ? 1 : 0);
    const double n = quarter;
    const double y = (angle_rad - n * kHalfPi) - n * kHalfPiRest;
    const double z = y * y;
    const double sine = compute_sine_series(y, z);
    const double cosine = compute_cosine_series(z);
    if (quarter == 0) {
        return {sine, cosine};
    }
    return quarter == 1 ? SineCosine{cosine, -sine} : SineCosine{-sine, -cosine};
}

SineCosineInterval enclose_sine_cosine(const Interval& angle_rad) noexcept {
    constexpr Interval kAny{-1.0, 1.0};
    // Outward rounding makes a little less than zero of zero; what that is worth is far below kSineError.
    constexpr double kZero = -0x1.0p-900;
    if (!(angle_rad.lower >= kZero && angle_rad.upper <= kMostAngle_rad)) {
        return {kAny, kAny};
    }
    const SineCosine first = compute_sine_cosine(std::max(0.0, angle_rad.lower));
    const SineCosine last = compute_sine_cosine(std::max(0.0, angle_rad.upper));
    // The cosine falls up to pi, the sine rises up to pi / 2 and falls from there.
    Interval cosine = widen(last.cosine - kSineError, first.cosine + kSineError);
    if (angle_rad.upper > kBelowPi) {
        cosine.lower = -1.0;
        cosine.upper = std::max(cosine.upper, last.cosine + 2.0 * kSineError);
    }
    Interval sine = widen(std::min(first.sine, last.sine) - kSineError,
                          std::max(first.sine, last.sine) + kSineError);
    if (angle_rad.lower < kAboveHalfPi && angle_rad.upper > kBelowHalfPi) {
        sine.upper = 1.0;
    }
    return {intersect(sine, kAny), intersect(cosine, kAny)};
}

}  // namespace fulcrum
