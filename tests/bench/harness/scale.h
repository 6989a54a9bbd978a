// From values to places on paper, linear or logarithmic, with round ticks.
#pragma once

#include <string>
#include <vector>

namespace fulcrum::bench {

/// The range of a set of values.
class Extent {
  public:
    /// Takes in a value; one that is not finite, or not above zero where the axis is logarithmic, is left out.
    void add(double value, bool logarithmic);
    [[nodiscard]] bool empty() const { return !(low_ <= high_); }
    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }

  private:
    double low_ = 1e300;
    double high_ = -1e300;
};

class Scale {
  public:
    /// Puts the extent, widened a little (to whole decades at most), between two places; an empty one becomes 0 to 1, or
    /// 1 to 10. `from` may be above `to`, as y on a screen.
    Scale(const Extent& extent, bool logarithmic, double from, double to);

    /// Where a value lies; what is outside, or has no logarithm, lies on the nearer end.
    [[nodiscard]] double place(double value) const;
    /// Round values inside: 1, 2, 5 times a power of ten, or the decades (with 2 and 5 between when there are few).
    [[nodiscard]] std::vector<double> ticks() const;

  private:
    bool logarithmic_;
    double low_, high_;  // of the value, or of its decimal logarithm
    double from_, to_;
};

}  // namespace fulcrum::bench
