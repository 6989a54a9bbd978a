// A bound as a sentence names it: two digits, and never less than it is, so that what is said does.
//
// Thread: any.
#pragma once

#include <cmath>

namespace fulcrum::runtime {

/// The least number of two digits that is not below `value`, which is above 0: 0.0421 gives 0.043, 430 stays 430.
[[nodiscard]] inline double round_up(double value) {
    constexpr double kRounding = 1.0e-9;  // of a digit: 0.3 / 0.01 is above 30
    const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
    return std::ceil(value / digit - kRounding) * digit;
}

}  // namespace fulcrum::runtime
