// Where the middle of an arm's space is: where somebody holds the handle still when asked to hold it in the middle.
//
//   within kStill_m of where it was for kRest_s: that is it, the mean of what was seen meanwhile
// The maker names no centre: positions count from the plate under the base. The preset that moves the origin sets basis and mount with
// it, so it is left alone. Whoever knows the place gives it in the settings instead.
//
// Thread: any. Cost: nanoseconds.
// Source: ours.
#pragma once

#include "haptics/math/spatial.h"

#include <optional>

namespace fulcrum::runtime {

class RestFinder {
  public:
    static constexpr double kStill_m = 0.003;  ///< more than a hand trembles
    static constexpr double kRest_s = 0.4;

    /// Takes a position in any frame; the middle, once the handle has rested.
    [[nodiscard]] std::optional<Vector3> step(const Vector3& position_m, double now_s) noexcept {
        if (n_ == 0 || (position_m - begin_).norm() > kStill_m) {
            begin_ = position_m;
            begin_s_ = now_s;
            sum_ = Vector3::Zero();
            n_ = 0;
        }
        sum_ += position_m;
        ++n_;
        const bool has_rested = now_s - begin_s_ >= kRest_s;
        return has_rested ? std::optional(Vector3(sum_ / static_cast<double>(n_))) : std::nullopt;
    }

  private:
    int n_ = 0;
    double begin_s_ = 0.0;
    Vector3 begin_{Vector3::Zero()};
    Vector3 sum_{Vector3::Zero()};
};

}  // namespace fulcrum::runtime
