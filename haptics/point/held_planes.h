// What a proxy does alike on triangles and on features of any shape: the planes that hold it, and where it goes when solids
// move. A plane has `solid`, `feature`, `normal_W` and `clearance_m`; a solid is a ProxyFrame.
//
// Thread: haptic loop. Cost: that of plane_constraints.h; no allocation.
#pragma once

#include "haptics/math/length.h"
#include "haptics/point/plane_constraints.h"
#include "haptics/point/proxy.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace fulcrum {

/// Planes that act together, with how much each pushes: the active ones, and for a moment one that was just met. Plane is a TouchedPlane
/// (moving_solid.h) or an ObstaclePlane (moving_obstacle.h).
template <class Plane>
struct HeldPlanes {
    std::array<Plane, kMaxPlanes> plane;
    std::array<double, kMaxPlanes> push_m{};
    std::size_t count = 0;

    [[nodiscard]] std::span<const Plane> all() const noexcept { return {plane.data(), count}; }

    /// The way that leads as near to the wish as the planes allow; keeps the planes that push. `height_m(plane)` is how far
    /// the proxy is from one; a plane counts as respected up to `slack` of the least clearance.
    template <class Height>
    [[nodiscard]] Vector3 constrain(const Vector3& wish, double slack, Height&& height_m) noexcept;

    /// Forgets the planes of one solid.
    void drop(std::int32_t solid) noexcept {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (plane[i].solid != solid) {
                plane[kept] = plane[i];
                push_m[kept++] = push_m[i];
            }
        }
        count = kept;
    }
    /// Says in the contact what holds the proxy.
    void tell_touches(const Vector3& proxy_W, ProxyContact& contact) const noexcept;
    /// The same before the goal is known, so that nothing pushes yet; `anchors_W` are the touches' own.
    void tell_carried(const Vector3& proxy_W, const std::array<Vector3, kMaxTouches>& anchors_W,
                      ProxyContact& contact) noexcept;
    /// The whole contact of a proxy that followed the goal; touches that do not count stay as they were.
    void tell_contact(const Vector3& proxy_W, const Vector3& goal_W,
                      ProxyContact& contact) const noexcept;
};

template <class Plane>
template <class Height>
Vector3 HeldPlanes<Plane>::constrain(const Vector3& wish, double slack,
                                     Height&& height_m) noexcept {
    if (count == 0) {
        return wish;
    }
    std::array<PlaneConstraint, kMaxPlanes> constraints;
    double clearance_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i) {
        constraints[i] = {plane[i].normal_W, plane[i].clearance_m - height_m(plane[i])};
        clearance_m = std::min(clearance_m, plane[i].clearance_m);
    }
    const std::span<PlaneConstraint> given(constraints.data(), count);
    ConstrainedPoint found = compute_constrained_point(wish, given, slack * clearance_m);
    if (!found.feasible) {
        // In a gap too narrow for the clearance: no nearer to any plane than now.
        for (PlaneConstraint& constraint : given) {
            constraint.offset_m = std::min(constraint.offset_m, 0.0);
        }
        found = compute_constrained_point(wish, given, slack * clearance_m);
    }
    if (!found.feasible) {
        // Nowhere is better: it stays, and the planes that it came with hold it.
        count = std::min(count, kMaxTouches);
        return Vector3::Zero();
    }
    // The active ones are in order, so none is written over before it has moved up.
    count = static_cast<std::size_t>(found.n_active);
    for (std::size_t i = 0; i < count; ++i) {
        if (const auto from = static_cast<std::size_t>(found.active[i]); from != i) {
            plane[i] = plane[from];
        }
        push_m[i] = found.multiplier[i];
    }
    return found.position;
}

template <class Plane>
void HeldPlanes<Plane>::tell_touches(const Vector3& proxy_W, ProxyContact& contact) const noexcept {
    contact.n_constraints = static_cast<std::int32_t>(std::min(count, kMaxTouches));
    for (std::size_t i = 0; i < contact.active().size(); ++i) {
        contact.touches[i] = {.solid = plane[i].solid,
                              .feature = plane[i].feature,
                              .normal_W = plane[i].normal_W,
                              .push_m = push_m[i],
                              .drag_W = Vector3::Zero(),
                              .anchor_W = proxy_W};
    }
}

// Inline: compiled into each god-object's step, though two use it.
template <class Plane>
inline void HeldPlanes<Plane>::tell_carried(const Vector3& proxy_W,
                                            const std::array<Vector3, kMaxTouches>& anchors_W,
                                            ProxyContact& contact) noexcept {
    push_m.fill(0.0);
    tell_touches(proxy_W, contact);
    for (std::size_t i = 0; i < contact.active().size(); ++i) {
        contact.touches[i].anchor_W = anchors_W[i];
    }
    contact.position_W = proxy_W;
}

template <class Plane>
void HeldPlanes<Plane>::tell_contact(const Vector3& proxy_W, const Vector3& goal_W,
                                     ProxyContact& contact) const noexcept {
    contact.position_W = proxy_W;
    contact.solid = kNoBody;
    contact.n_constraints = 0;
    contact.normal_W.setZero();
    if (count == 0) {
        return;
    }
    tell_touches(proxy_W, contact);
    const auto strongest = std::ranges::max_element(contact.active(), {}, &SolidTouch::push_m);
    contact.solid = strongest->solid;
    const Vector3 push = proxy_W - goal_W;
    contact.normal_W = push.squaredNorm() > 0.0 ? compute_direction(push) : strongest->normal_W;
}

/// Where the touched solid takes the proxy along to; where it stands when none is touched.
template <class Solids>
[[nodiscard]] Vector3 find_carried_wish(const Solids& solids, std::int32_t touched,
                                        const Vector3& proxy_W) noexcept {
    return touched == kNoBody ? proxy_W
                              : solids[static_cast<std::size_t>(touched)].carried_proxy_W();
}

/// Where the proxy can be after the solids moved: at the wish, where it stands, or carried by a solid that is in the way there;
/// nothing when each is blocked. `find_blocker(place_W)` tells which `solid` is met on the way there, kNoBody when none;
/// `first` is what the wish met.
template <class Solids, class FindBlocker, class Blocker>
[[nodiscard]] std::optional<Vector3> find_carried_place(const Solids& solids, const Vector3& wish_W,
                                                        const Vector3& proxy_W,
                                                        FindBlocker&& find_blocker,
                                                        Blocker& first) noexcept {
    static_assert(kMaxSolids <= 32, "each solid tried has a bit");
    first = find_blocker(wish_W);
    Blocker next = first;
    Vector3 candidate_W = wish_W;
    if (next.solid != kNoBody && wish_W != proxy_W) {
        candidate_W = proxy_W;
        next = find_blocker(candidate_W);
    }
    unsigned tried = 0;
    while (next.solid != kNoBody) {
        const unsigned bit = 1U << static_cast<unsigned>(next.solid);
        if ((tried & bit) != 0) {
            return std::nullopt;
        }
        tried |= bit;
        candidate_W = solids[static_cast<std::size_t>(next.solid)].carried_proxy_W();
        next = find_blocker(candidate_W);
    }
    return candidate_W;
}

}  // namespace fulcrum
