// What the bodies of rigid_world.h meet within a step, and how far they go where the step's own answer leads to what nobody looked for.
#include "haptics/collision/contact_sweep.h"
#include "haptics/collision/find_contacts.h"
#include "haptics/collision/sampled_contacts.h"
#include "haptics/collision/sampled_sweep.h"
#include "haptics/dynamics/rigid_reach.h"
#include "haptics/dynamics/rigid_world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

constexpr double kNotMet = std::numeric_limits<double>::infinity();
// What is met so little later is met at the same time.
constexpr double kSameTime = 1.01;

std::size_t to_body_place(std::int32_t i) noexcept {
    return static_cast<std::size_t>(i);
}

MovingShape make_moving(const RigidWorldBody& body, const Twist& velocity_W) noexcept {
    return {&body.shape, body.place, body.state.pose_W.position, velocity_W, body.lever_m};
}

// Where they meet the gaps are those of then; with what their ways take of them they are those of now.
void tell_from_now(double meet_s, const RigidWorldBody& first, const RigidWorldBody& second,
                   ContactManifold& manifold) noexcept {
    for (int i = 0; i < manifold.count; ++i) {
        ContactPoint& point = manifold.contacts[static_cast<std::size_t>(i)];
        point.gap_m -= meet_s * find_apart(manifold.normal_W, point.place_W, meet_s, first, second);
    }
}

// What does not move has no way to lose.
void meet_at(double at_s, RigidWorldBody& body) noexcept {
    if (body.moves) {
        body.meets_s = std::min(body.meets_s, at_s);
    }
}

// When each body first meets anything faster than what does not bounce, and which pairs that is true of: `n` of them, the k-th of which is
// `which(k)`.
template <class Which>
void find_first_of(int n, const Which& which, double least_m_per_s, RigidScene& scene) noexcept {
    const auto each_pair = [&](auto&& visit) {
        for (int k = 0; k < n; ++k) {
            ContactPair& pair = scene.pairs.at(which(k));
            if (pair.manifold.count > 0) {
                visit(pair, scene.bodies[to_body_place(pair.bodies.first)],
                      scene.bodies[to_body_place(pair.bodies.second)]);
            }
        }
    };
    each_pair([&](const ContactPair& pair, RigidWorldBody& first, RigidWorldBody& second) {
        for (const ContactPoint& point : pair.manifold.points()) {
            const double speed =
                -find_apart(pair.manifold.normal_W, point.place_W, pair.meet_s, first, second);
            if (speed > least_m_per_s) {
                const double at_s = std::max(point.gap_m, 0.0) / speed;
                meet_at(at_s, first);
                meet_at(at_s, second);
            }
        }
    });
    each_pair([&](ContactPair& pair, const RigidWorldBody& first, const RigidWorldBody& second) {
        pair.is_first = pair.meet_s <= kSameTime * std::min(first.meets_s, second.meets_s);
    });
}

void grow(const Vector3& by_m, Box& box) noexcept {
    box.lower += by_m.cwiseMin(0.0);
    box.upper += by_m.cwiseMax(0.0);
}

}  // namespace

// Where they touch now, or where their ways first bring them together.
void RigidWorld::look_ahead(ContactPair& pair, double reach_s) noexcept {
    const RigidWorldBody& first = scene_.bodies[to_body_place(pair.bodies.first)];
    const RigidWorldBody& second = scene_.bodies[to_body_place(pair.bodies.second)];
    const double margin_m = first.reach_m + second.reach_m;
    const double near_m = find_near(first, second);
    ContactManifold& manifold = pair.manifold;
    find_contacts(first.shape, first.place, second.shape, second.place, margin_m, manifold);
    pair.meet_s = 0.0;
    pair.passes = false;
    if (manifold.count == 0 ||
        std::ranges::any_of(manifold.points(),
                            [&](const ContactPoint& point) { return point.gap_m <= near_m; })) {
        return;
    }
    const MovingShape a = make_moving(first, first.ahead_W);
    const MovingShape b = make_moving(second, second.ahead_W);
    const double meet_s = find_meeting_s(a, b, near_m, reach_s);
    if (!(meet_s < reach_s)) {
        manifold.count = 0;
        pair.passes = true;
        return;
    }
    pair.meet_s = meet_s;
    find_contacts(first.shape, a.find_place(meet_s), second.shape, b.find_place(meet_s), margin_m,
                  manifold);
    tell_from_now(meet_s, first, second, manifold);
}

// Of the pair that begins there.
int RigidWorld::count_patches(int i) const noexcept {
    BodyPair next = scene_.pairs.at(i).bodies;
    int n = 0;
    for (int j = i; j < scene_.pairs.count() && n < kMostPatches; ++j, ++n) {
        if (!(scene_.pairs.at(j).bodies == next)) {
            break;
        }
        ++next.patch;
    }
    return n;
}

// The same in patches: what comes no farther than touches tell is found as it is, and what touches already.
void RigidWorld::look_ahead_in_patches(int i, double reach_s) noexcept {
    const BodyPair bodies = scene_.pairs.at(i).bodies;
    const RigidWorldBody& first = scene_.bodies[to_body_place(bodies.first)];
    const RigidWorldBody& second = scene_.bodies[to_body_place(bodies.second)];
    const auto n = static_cast<std::size_t>(count_patches(i));
    std::array<ContactManifold*, kMostPatches> all{};
    for (std::size_t k = 0; k < n; ++k) {
        ContactPair& pair = scene_.pairs.at(i + static_cast<int>(k));
        pair.meet_s = 0.0;
        pair.passes = false;
        all[k] = &pair.manifold;
    }
    const auto patches = std::span(all).first(n);
    const double size_m = std::min(first.shape.bounding_radius_m, second.shape.bounding_radius_m);
    const double margin_m = first.reach_m + second.reach_m;
    const double near_m = find_near(first, second);
    const auto find_at = [&](const ContactPlace& a, const ContactPlace& b, double within_m) {
        find_sampled_contacts({*first.shape.sampled, a}, {*second.shape.sampled, b}, size_m,
                              {.margin_m = within_m, .ahead_m = within_m - near_m}, patches);
    };
    const double slack_m = find_sampled_slack_m(first.shape, second.shape);
    const MovingShape a = make_moving(first, first.ahead_W);
    const MovingShape b = make_moving(second, second.ahead_W);
    const bool is_far = margin_m > slack_m + near_m;
    const double meet_s = is_far ? find_sampled_meeting_s(a, b, near_m, reach_s) : 0.0;
    if (!(meet_s < reach_s)) {
        std::ranges::for_each(patches, [](ContactManifold* patch) { patch->count = 0; });
        scene_.pairs.at(i).passes = true;
        return;
    }
    if (!(meet_s > 0.0)) {
        find_at(first.place, second.place, margin_m);
        return;
    }
    find_at(a.find_place(meet_s), b.find_place(meet_s), std::min(margin_m, slack_m + near_m));
    for (std::size_t k = 0; k < n; ++k) {
        scene_.pairs.at(i + static_cast<int>(k)).meet_s = meet_s;
        tell_from_now(meet_s, first, second, *patches[k]);
    }
}

bool RigidWorld::bounces_at_all() const noexcept {
    return std::ranges::any_of(scene_.bodies,
                               [](const RigidWorldBody& body) { return body.restitution > 0.0; });
}

void RigidWorld::find_first_met() noexcept {
    if (!bounces_at_all()) {
        return;
    }
    for (RigidWorldBody& body : scene_.bodies) {
        body.meets_s = kNotMet;
    }
    find_first_of(
        scene_.pairs.count(), [](int k) { return k; }, settings_.least_bounce_m_per_s, scene_);
}

void RigidWorld::find_first_met(const IslandParts& parts) noexcept {
    for (const std::int32_t i : parts.bodies) {
        scene_.bodies[to_body_place(i)].meets_s = kNotMet;
    }
    find_first_of(
        static_cast<int>(parts.pairs.size()),
        [&](int k) { return parts.pairs[static_cast<std::size_t>(k)]; },
        settings_.least_bounce_m_per_s, scene_);
}

void RigidWorld::find_ways() noexcept {
    for (RigidWorldBody& body : scene_.bodies) {
        body.way_W = {};
    }
    for (const DueIsland& due : due_.all()) {
        for (const std::int32_t i : islands_.bodies(due.island)) {
            RigidWorldBody& body = scene_.bodies[to_body_place(i)];
            body.way_W = {due.dt_s * body.drift_W.linear, due.dt_s * body.drift_W.angular};
        }
    }
}

// Both go no farther than to where they meet.
void RigidWorld::hold_pair(const BodyPair& bodies) noexcept {
    const RigidWorldBody& first = scene_.bodies[to_body_place(bodies.first)];
    const RigidWorldBody& second = scene_.bodies[to_body_place(bodies.second)];
    const MovingShape a = make_moving(first, first.way_W);
    const MovingShape b = make_moving(second, second.way_W);
    const double near_m = find_near(first, second);
    const double part = meets_in_patches(bodies) ? find_sampled_meeting_s(a, b, near_m, 1.0)
                                                 : find_meeting_s(a, b, near_m, 1.0);
    // What is near already has contacts, or is kept from having any.
    if (!(part > 0.0 && part < 1.0)) {
        return;
    }
    for (const std::int32_t i : {bodies.first, bodies.second}) {
        if (const std::int32_t island = islands_.island_of(i); island >= 0) {
            double& goes = parts_[to_body_place(island)];
            goes = std::min(goes, part);
        }
    }
}

// Of bodies that go farther than anybody looked for them.
void RigidWorld::hold_far() noexcept {
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
        const RigidWorldBody& body = scene_.bodies[i];
        grow(body.way_W.linear, boxes_[i]);
        const double turned_m = compute_length(body.way_W.angular) * body.lever_m;
        grow(Vector3::Constant(turned_m), boxes_[i]);
        grow(Vector3::Constant(-turned_m), boxes_[i]);
    }
    for (const BodyPair& pair : broad_phase_.find_pairs(boxes_.all(), moves_.all())) {
        const auto near = near_.all();
        if (!is_joined(pair) && !std::binary_search(near.begin(), near.end(), pair)) {
            hold_pair(pair);
        }
    }
    report_.n_dropped += broad_phase_.n_dropped();
}

// In none of its patches, told at the first of them.
bool RigidWorld::is_apart(int i) const noexcept {
    if (scene_.pairs.at(i).bodies.patch > 0) {
        return false;
    }
    for (int k = 0; k < count_patches(i); ++k) {
        if (scene_.pairs.at(i + k).manifold.count > 0) {
            return false;
        }
    }
    return true;
}

void RigidWorld::hold_back() noexcept {
    parts_.set_count(static_cast<std::size_t>(islands_.count()));
    std::ranges::fill(parts_.all(), 1.0);
    find_ways();
    const auto goes_far = [](const RigidWorldBody& body) noexcept {
        return find_farthest(body.way_W, body.lever_m) > body.reach_m;
    };
    for (int i = 0; i < scene_.pairs.count(); ++i) {
        const ContactPair& pair = scene_.pairs.at(i);
        if (is_apart(i) &&
            (pair.passes || goes_far(scene_.bodies[to_body_place(pair.bodies.first)]) ||
             goes_far(scene_.bodies[to_body_place(pair.bodies.second)]))) {
            hold_pair(pair.bodies);
        }
    }
    if (std::ranges::any_of(scene_.bodies, goes_far)) {
        hold_far();
    }
    report_.n_held = static_cast<int>(
        std::ranges::count_if(parts_.all(), [](double part) { return part < 1.0; }));
}

}  // namespace fulcrum
