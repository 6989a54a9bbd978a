// Where the program's own hand is seen by who wants calm pictures: it does not glide, but stands where it last rested, or where it was
// a second ago at most.
//
// Thread: lesson loop. Cost: none to speak of.
#pragma once

#include "haptics/math/spatial.h"

#include <optional>

namespace fulcrum::runtime {

class StillHand {
  public:
    /// Each frame: where the hand points, nothing where it does not, and the lesson's own time.
    void look(const std::optional<Vector3>& at_W, double time_s) {
        const bool rests = at_W && before_W_ && (*at_W - *before_W_).norm() < kRest_m;
        if (!at_W || !seen_W_ || rests || time_s - seen_s_ >= kLongest_s) {
            seen_W_ = at_W;
            seen_s_ = time_s;
        }
        before_W_ = at_W;
    }
    [[nodiscard]] const std::optional<Vector3>& seen_W() const { return seen_W_; }

  private:
    static constexpr double kRest_m = 0.0005;  // from frame to frame: below a dot of the picture
    static constexpr double kLongest_s = 1.0;

    std::optional<Vector3> seen_W_;
    std::optional<Vector3> before_W_;
    double seen_s_ = 0.0;
};

}  // namespace fulcrum::runtime
