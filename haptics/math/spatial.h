// The small types that every folder speaks in. SI units, right-handed, +Y up. A member's suffix names its frame:
// W world, D device base, T tool, P proxy, B body.
#pragma once

#include "haptics/math/matrix.h"
#include "haptics/math/quaternion.h"

namespace fulcrum {

/// A rigid pose X_AB: where B's origin lies in A (metres) and how B is turned in A.
struct Pose {
    Vector3 position{Vector3::Zero()};
    Quaternion orientation{Quaternion::Identity()};

    /// A pose that is moved but not turned. (`Pose{p, {}}` would leave the quaternion unset.)
    [[nodiscard]] static Pose at(const Vector3& position) {
        return {position, Quaternion::Identity()};
    }
    /// p_A from p_B.
    [[nodiscard]] Vector3 operator*(const Vector3& point) const {
        return orientation * point + position;
    }
    /// X_AC = X_AB * X_BC.
    [[nodiscard]] Pose operator*(const Pose& inner) const {
        return {position + orientation * inner.position, orientation * inner.orientation};
    }
    [[nodiscard]] Pose inverse() const {
        const Quaternion turned_back = orientation.conjugate();
        return {-(turned_back * position), turned_back};
    }
};

/// Velocity of a frame: metres per second of its origin, radians per second about it.
struct Twist {
    Vector3 linear{Vector3::Zero()};
    Vector3 angular{Vector3::Zero()};
};

/// Force in newtons and torque in newton metres about the frame's origin.
struct Wrench {
    Vector3 force{Vector3::Zero()};
    Vector3 torque{Vector3::Zero()};
};

[[nodiscard]] inline bool is_finite(const Vector3& v) {
    return v.allFinite();
}
[[nodiscard]] inline bool is_finite(const Pose& pose) {
    return pose.position.allFinite() && pose.orientation.coeffs().allFinite();
}
[[nodiscard]] inline bool is_finite(const Wrench& wrench) {
    return wrench.force.allFinite() && wrench.torque.allFinite();
}
/// To the bit, but for a zero's sign; never where anything is no number.
[[nodiscard]] inline bool is_same(const Pose& a, const Pose& b) noexcept {
    return a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs();
}

}  // namespace fulcrum
