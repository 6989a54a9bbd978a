#include "haptics/dynamics/way_bounds.h"

#include "haptics/collision/sampled_sweep.h"
#include "haptics/dynamics/contacts_ahead.h"
#include "haptics/dynamics/rigid_reach.h"

#include <algorithm>

namespace fulcrum {

bool WayBounds::goes_far(std::int32_t body, const RigidScene& scene) noexcept {
    return find_farthest(way_of(body), scene.body(body).lever_m) > scene.body(body).reach_m;
}

// Both go no farther than to where they meet.
void WayBounds::hold_pair(const BodyPair& bodies, const SceneIslands& islands,
                          const RigidScene& scene) noexcept {
    const RigidWorldBody& first = scene.body(bodies.first);
    const RigidWorldBody& second = scene.body(bodies.second);
    const MovingShape a = make_moving(first, way_of(bodies.first));
    const MovingShape b = make_moving(second, way_of(bodies.second));
    const double near_m = find_near(first, second);
    const double part = scene.meets_in_patches(bodies) ? find_sampled_meeting_s(a, b, near_m, 1.0)
                                                       : find_meeting_s(a, b, near_m, 1.0);
    // What is near already has contacts, or is kept from having any.
    if (!(part > 0.0 && part < 1.0)) {
        return;
    }
    for (const std::int32_t i : {bodies.first, bodies.second}) {
        if (const std::int32_t island = islands.island_of(i); island >= 0) {
            double& goes = parts_[static_cast<std::size_t>(island)];
            goes = std::min(goes, part);
        }
    }
}

void WayBounds::find(std::span<const DueIsland> due, const SceneIslands& islands,
                     const RigidScene& scene, NearBodies& near) noexcept {
    parts_.set_count(static_cast<std::size_t>(islands.count()));
    std::ranges::fill(parts_.all(), 1.0);
    std::ranges::fill(ways_W_.all(), Twist{});
    for (const DueIsland& one : due) {
        for (const std::int32_t i : islands.bodies_of(one.island)) {
            const Twist& drift_W = scene.body(i).drift_W;
            way_of(i) = {one.dt_s * drift_W.linear, one.dt_s * drift_W.angular};
        }
    }
    for (int i = 0; i < scene.pairs.count(); ++i) {
        const ContactPair& pair = scene.pairs.at(i);
        if (ContactsAhead::is_apart(i, scene) &&
            (pair.passes || goes_far(pair.bodies.first, scene) ||
             goes_far(pair.bodies.second, scene))) {
            hold_pair(pair.bodies, islands, scene);
        }
    }
    const auto n_bodies = static_cast<std::int32_t>(scene.bodies.size());
    bool any_far = false;
    for (std::int32_t i = 0; i < n_bodies && !any_far; ++i) {
        any_far = goes_far(i, scene);
    }
    if (any_far) {
        near.find_far(ways_W_.all(), scene,
                      [&](const BodyPair& pair) noexcept { hold_pair(pair, islands, scene); });
    }
}

int WayBounds::n_held() const noexcept {
    return static_cast<int>(
        std::ranges::count_if(parts_.all(), [](double part) { return part < 1.0; }));
}

}  // namespace fulcrum
