// Which solids let a proxy through (see proxy_frame.h), told alike for all kinds. A solid is a ProxyFrame that `holds` places.
//
// Thread: haptic loop. Cost: nothing while no solid lets it through; no allocation.
#pragma once

#include "haptics/math/spatial.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace fulcrum {

/// A proxy that starts at `proxy_W` for a hand at `hand_W`: let through by every solid that holds one of them.
template <class Solid>
void start_in(Solid& solid, const Vector3& proxy_W, const Vector3& hand_W) noexcept {
    solid.let_through(solid.holds(proxy_W) || solid.holds(hand_W));
}

/// Puts a solid elsewhere at once (Proxy::put_solid): its planes are forgotten, and it lets through what it comes to hold.
template <class Solid, class Planes>
void put_at_once(Solid& solid, const Pose& pose_W, const Vector3& proxy_W, const Vector3& hand_W,
                 std::int32_t index, Planes& planes) noexcept {
    planes.drop(index);
    solid.take_pose(pose_W);
    solid.put_proxy(proxy_W);
    start_in(solid, proxy_W, hand_W);
}

/// A proxy that found no room comes to lie at `proxy_W`: solids that hold it there let it through from now on, and their planes go.
template <class Solid, class Planes>
void give_way(std::span<Solid> solids, const Vector3& proxy_W, Planes& planes) noexcept {
    for (std::size_t i = 0; i < solids.size(); ++i) {
        if (!solids[i].lets_through() && solids[i].holds(proxy_W)) {
            solids[i].let_through(true);
            planes.drop(static_cast<std::int32_t>(i));
        }
    }
}

/// Solids that both have left are there again.
template <class Solid>
void leave_solids(std::span<Solid> solids, const Vector3& proxy_W, const Vector3& hand_W) noexcept {
    for (Solid& solid : solids) {
        if (solid.lets_through()) {
            start_in(solid, proxy_W, hand_W);
        }
    }
}

}  // namespace fulcrum
