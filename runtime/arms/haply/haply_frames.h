// From the base A of a Haply arm to the frame D of a device, and back.
//
//   A: +X right, +Y away from the person, +Z up          D: +X right, +Y up, +Z to the person; both right-handed
//   p_D = M p_A = (x, z, -y)_A      f_A = M^T f_D = (x, -z, y)_D      q = (w, v): q_D = (w, M v_A)
// A grip's own +Y is where it points: in D terms its -Z, as a stylus points away from the person.
//
// Source: docs.haply.co/inverseSDK/service/commons/basis: "XYZ".
#pragma once

#include "haptics/math/spatial.h"

namespace fulcrum::runtime {

[[nodiscard]] inline Vector3 haply_to_D(const Vector3& v_A) noexcept {
    return {v_A.x(), v_A.z(), -v_A.y()};
}
[[nodiscard]] inline Vector3 haply_from_D(const Vector3& v_D) noexcept {
    return {v_D.x(), -v_D.z(), v_D.y()};
}
[[nodiscard]] inline Quaternion haply_to_D(const Quaternion& q_A) noexcept {
    return {q_A.w(), q_A.x(), q_A.z(), -q_A.y()};
}
[[nodiscard]] inline Quaternion haply_from_D(const Quaternion& q_D) noexcept {
    return {q_D.w(), q_D.x(), -q_D.z(), q_D.y()};
}

}  // namespace fulcrum::runtime
