// A clock that goes by a tool's motion instead of time, so that what was free by so much stays free until so late.
//
//   m   sum over steps of the largest way of any point of the tool in the object's frame O, voxels:
//       |p' - p| + 2 |sin(phi / 2)| reach        p, p' the tool's origin before and after, phi what it turned by
//   turned   sum of 2 |sin(phi / 2)|, rad
// Rounded up, so that no point has gone farther. Beyond 4096 voxels, or 100 rad, single precision is too coarse: it is to begin anew.
//
// Thread: that of the step. Cost: 20 ns.
// Source: W. McNeely, K. Puterbaugh, J. Troy 2006, Voxel-based 6-DOF haptic rendering improvements, Haptics-e 3(7), section 4.
#pragma once

#include "haptics/math/spatial.h"

namespace fulcrum {

class MotionClock {
  public:
    /// For single precision places and times.
    static constexpr float kMargin_voxels = 2.0e-3F;

    /// At 0, where no tool has been.
    void reset() noexcept { *this = {}; }
    /// At 0 with the tool where it is; what was told before lies `now()` back.
    void rebase() noexcept;
    /// The tool is at `X_OT`, its farthest point `reach_m` from its origin.
    void advance(const Pose& X_OT, double reach_m, double voxel_m) noexcept;

    [[nodiscard]] bool is_to_rebase() const noexcept;
    /// m, voxels.
    [[nodiscard]] float now() const noexcept { return now_; }
    [[nodiscard]] double turned_rad() const noexcept { return turned_rad_; }

  private:
    double voxels_ = 0.0;
    float now_ = 0.0F;  // rounded up
    double turned_rad_ = 0.0;
    Pose last_OT_;
    bool has_last_ = false;
};

}  // namespace fulcrum
