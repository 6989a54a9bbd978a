#include "haptics/point/proxy_frame.h"

#include <limits>

namespace fulcrum {

bool ProxyFrame::take_pose(const Pose& pose_W) noexcept {
    if (is_same(pose_W, pose_W_)) {
        return false;
    }
    const double length = pose_W.orientation.norm();
    if (!is_finite(pose_W) || !(length > 0.0) ||
        !(length < std::numeric_limits<double>::infinity())) {
        return false;
    }
    pose_W_ = pose_W;
    origin_W_ = pose_W.position;
    turn_WB_ = Quaternion(pose_W.orientation.coeffs() / length).toRotationMatrix();
    return true;
}

}  // namespace fulcrum
