// SpaceMice: a cap that is pushed and turned in six directions and gives back how far it was, and buttons.
//
//   two reports   number 1: x y z   2: rotations about x y z                    6 bytes each
//   one report    number 1: x y z and the rotations                            12 bytes
//   both          number 3: buttons, one bit each
// Numbers are 16-bit little-endian in two's complement. Which kind it is, the length of report 1 tells; the table of ids only says what
// is a SpaceMouse. Their frame: x to the right, y towards the user, z down; turns by the right-hand rule. In ours:
//   D = (x, -z, y)     for pushes and for turns
//
// Thread: the device's own. Cost: nanoseconds.
// Source: the family's report descriptors (Generic Desktop, Multi-axis Controller: X Y Z in one report, Rx Ry Rz in it or in the next).
#pragma once

#include "haptics/math/spatial.h"

#include <cstdint>
#include <span>

namespace fulcrum::hid {

/// How far the cap is pushed and turned, 1 is as far as it goes, in the device's frame D; and which buttons are down.
struct CapState {
    Vector3 push_D{Vector3::Zero()};
    Vector3 turn_D{Vector3::Zero()};
    std::uint32_t buttons = 0;
};

/// What most of the family give at the cap's end.
inline constexpr double kFullCap = 350.0;

/// True for the vendor's and product's numbers of a SpaceMouse.
[[nodiscard]] bool is_space_mouse(std::uint16_t vendor, std::uint16_t product) noexcept;

/// Takes a report over, its number first. False, and `cap` as it was, for one that is none of the above.
/// `full` is the number that the device gives at the end of the cap's way, above 0; what goes beyond it counts as 1.
bool take_cap_report(std::span<const std::uint8_t> report, double full, CapState& cap) noexcept;

}  // namespace fulcrum::hid
