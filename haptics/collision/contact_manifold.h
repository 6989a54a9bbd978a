// What is known of where two bodies touch from step to step: a normal and up to four points, which stay the same points.
//
// A point is the same as an old one, and has its id, where it lies within `kSamePlace` of the smaller body's size of it, in either
// body's frame, or where the same two edges meet; each old one becomes one new one. So a body that rests and trembles keeps its
// ids, though edges that coincide change their order each step; and what is learnt of a contact, its impulse, can go by the id.
#pragma once

#include "haptics/math/spatial.h"

#include <array>
#include <cstdint>
#include <span>

namespace fulcrum {

inline constexpr int kMostContacts = 4;

/// Of the smaller body's size: how near an old point a new one is the same.
inline constexpr double kSamePlace = 0.02;

struct ContactPoint {
    Vector3 place_W{Vector3::Zero()};  ///< half way between the surfaces
    double gap_m = 0.0;                ///< along the normal; below 0: overlap
    std::uint32_t id = 0;              ///< the same while the point is; of each pair by itself
    std::uint16_t feature = 0;         ///< which edges meet there
    Vector3 place_A{Vector3::Zero()};  ///< in the first body's frame
    Vector3 place_B{Vector3::Zero()};  ///< in the second's
};

/// What is known of a pair from step to step.
struct ContactManifold {
    Vector3 normal_W{Vector3::UnitY()};  ///< unit, from the second to the first
    std::array<ContactPoint, kMostContacts> contacts{};
    int count = 0;
    std::int32_t which_axis = 0;  ///< contact_axis.h
    std::uint32_t next_id = 1;

    [[nodiscard]] std::span<const ContactPoint> points() const noexcept {
        return {contacts.data(), static_cast<std::size_t>(count)};
    }
};

/// Where a body is, with its axes worked out once a step for all its pairs.
struct ContactPlace {
    Vector3 position_W{Vector3::Zero()};
    Matrix3 turn_WB{Matrix3::Identity()};

    [[nodiscard]] static ContactPlace of(const Pose& pose) noexcept {
        return {pose.position, pose.orientation.toRotationMatrix()};
    }
    [[nodiscard]] Vector3 to_body(const Vector3& place_W) const noexcept {
        return turn_WB.transpose() * (place_W - position_W);
    }
};

[[nodiscard]] inline bool is_finite(const ContactPlace& place) noexcept {
    return place.position_W.allFinite() && place.turn_WB.allFinite();
}

}  // namespace fulcrum
