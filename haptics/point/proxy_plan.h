// Which proxy a scene is touched with.
#pragma once

#include "haptics/base/error.h"
#include "haptics/collision/segment_structure_kind.h"
#include "haptics/collision/solid_shape.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

namespace fulcrum {

struct SolidPlan;  // solid_plan.h
class Proxy;       // proxy.h

/// By the names of the literature.
enum class ProxyKind : std::uint8_t {
    god_object,     ///< a point (Zilles and Salisbury 1995)
    virtual_proxy,  ///< a sphere (Ruspini, Kolarov, Khatib 1997), or any convex cursor
    friction_cone,  ///< either of them, or any convex cursor, with friction (Melder and Harwin 2002; Barrow and Harwin)
};

/// "god-object", "virtual proxy", "friction cone": for people.
[[nodiscard]] constexpr std::string_view name_of(ProxyKind kind) noexcept {
    constexpr std::string_view kNames[] = {"god-object", "virtual proxy", "friction cone"};
    return kNames[static_cast<std::size_t>(kind)];
}

/// The cursor's own shape, centred on the tool's position, turned as the hand is.
using CursorShape =
    std::variant<std::monostate, SphereShape, BoxShape, CapsuleShape, CylinderShape, HullShape>;

/// A point or a ball: alike however it is turned.
[[nodiscard]] inline bool is_round(const CursorShape& cursor) noexcept {
    return std::holds_alternative<std::monostate>(cursor) ||
           std::holds_alternative<SphereShape>(cursor);
}

struct ProxySettings {
    ProxyKind kind = ProxyKind::god_object;
    /// How a point finds triangles where all solids are made of them; where it goes is the same with all.
    SegmentStructureKind structure = SegmentStructureKind::bounding_tree;
    CursorShape cursor{};  ///< std::monostate: a point
    int friction_rounds =
        16;  ///< of the friction cone's solver where several planes hold, 1 to 200
};

}  // namespace fulcrum
