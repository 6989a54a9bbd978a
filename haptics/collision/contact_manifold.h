// Where two convex bodies touch: a normal and up to four points, which stay the same points from step to step.
//
//   gap = height of the upper body over the lower along n at a place; below 0 they overlap. n from the second to the first
// The direction comes of contact_axis.h, the points of contact_shadow.h: the corners of what both bodies' features share, of which those
// within the margin count. Of more than four, four are kept that span the largest area, the deepest among them. A point's place lies half
// way between both surfaces.
//
// What was there last time is kept where it can be. A point is the same as an old one, and has its id, where it lies within
// `kSamePlace` of the smaller body's size of it, in either body's frame, or where the same two edges meet; each old one becomes one new
// one. The four kept are those of last time unless others span a tenth more, or are deeper. So a body that rests and trembles keeps its
// ids, though edges that coincide change their order each step; and what is learnt of a contact, its impulse, can go by the id.
//
// Thread: that which steps the pair. Cost: two boxes face to face 0.4 us; no allocation.
// Source: symmetric in both bodies by the shadows' law; the four points as D. Gregorius 2015, Robust contact creation for physics
// simulations, GDC, chooses them.
#pragma once

#include "haptics/collision/contact_axis.h"
#include "haptics/collision/contact_shape.h"

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

/// Finds the pair's contacts anew; `manifold` is that of the last time, or a fresh one. Points with a gap above `margin_m`, 0 or more, are
/// left out. A place that is not finite has no contacts. Two half spaces never touch.
void find_contacts(const ContactShape& first, const ContactPlace& first_place,
                   const ContactShape& second, const ContactPlace& second_place, double margin_m,
                   ContactManifold& manifold) noexcept;

}  // namespace fulcrum
