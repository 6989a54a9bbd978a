// Where a solid is, and where in its own frame the proxy was last: what every proxy keeps of each solid.
//
//   p_W = R_WB p_B + origin_W
// A solid in which the hand began, or that was put on it, lets the proxy through until both have left it: nobody is thrown out of a
// thing that appears round the hand, nor shut up in it.
//
// Thread: haptic loop. Cost: some operations; no allocation.
#pragma once

#include "haptics/math/spatial.h"

#include <limits>

namespace fulcrum {

class ProxyFrame {
  public:
    /// Moves the solid; true when that changed anything. A pose that is not finite is ignored.
    bool take_pose(const Pose& pose_W) noexcept;
    /// Says where the proxy is; the way from where it was must be free.
    void put_proxy(const Vector3& proxy_W) noexcept { proxy_B_ = to_body(proxy_W); }
    /// Where the proxy would be, had it moved along with the solid.
    [[nodiscard]] Vector3 carried_proxy_W() const noexcept { return to_world(proxy_B_); }
    /// Is the proxy let through, as if the solid were not there?
    [[nodiscard]] bool lets_through() const noexcept { return lets_through_; }
    void let_through(bool on) noexcept { lets_through_ = on; }

  protected:
    [[nodiscard]] Vector3 to_body(const Vector3& p_W) const noexcept {
        return turn_WB_.transpose() * (p_W - origin_W_);
    }
    [[nodiscard]] Vector3 to_world(const Vector3& p_B) const noexcept {
        return turn_WB_ * p_B + origin_W_;
    }
    [[nodiscard]] const Matrix3& turn_WB() const noexcept { return turn_WB_; }
    [[nodiscard]] const Vector3& origin_W() const noexcept { return origin_W_; }
    [[nodiscard]] const Vector3& proxy_B() const noexcept { return proxy_B_; }
    /// What rounding in places as far as that amounts to, many times over: for small solids far from the origin.
    [[nodiscard]] static double rounding_m(double farthest_m) noexcept {
        return 64.0 * std::numeric_limits<double>::epsilon() * farthest_m;
    }

  private:
    Pose pose_W_;
    Matrix3 turn_WB_{Matrix3::Identity()};
    Vector3 origin_W_{Vector3::Zero()};
    Vector3 proxy_B_{Vector3::Zero()};
    bool lets_through_ = false;
};

}  // namespace fulcrum
