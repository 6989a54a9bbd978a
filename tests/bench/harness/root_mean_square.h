// The root mean square of values that come one after the other, and of how they swing about their mean.
#pragma once

#include <algorithm>
#include <cmath>

namespace fulcrum::bench {

class RootMeanSquare {
  public:
    void add(double value) noexcept {
        sum_ += value;
        squares_ += value * value;
        ++n_;
    }
    /// At least one was added.
    [[nodiscard]] double value() const noexcept { return std::sqrt(squares_ / n_); }
    /// About the mean.
    [[nodiscard]] double swing() const noexcept {
        const double mean = sum_ / n_;
        return std::sqrt(std::max(squares_ / n_ - mean * mean, 0.0));
    }

  private:
    double sum_ = 0.0;
    double squares_ = 0.0;
    int n_ = 0;
};

}  // namespace fulcrum::bench
