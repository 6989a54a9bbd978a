#include "haptics/dynamics/contacts_ahead.h"

#include "haptics/collision/find_contacts.h"
#include "haptics/collision/sampled_contacts.h"
#include "haptics/collision/sampled_sweep.h"
#include "haptics/dynamics/rigid_reach.h"

#include <algorithm>
#include <array>
#include <limits>

namespace fulcrum {
namespace {

constexpr double kNotMet = std::numeric_limits<double>::infinity();
// What is met so little later is met at the same time.
constexpr double kSameTime = 1.01;

// Where they meet the gaps are those of then; with what their ways take of them they are those of now.
void tell_from_now(double meet_s, const RigidWorldBody& first, const RigidWorldBody& second,
                   ContactManifold& manifold) noexcept {
    for (int i = 0; i < manifold.count; ++i) {
        ContactPoint& point = manifold.contacts[static_cast<std::size_t>(i)];
        point.gap_m -= meet_s * find_apart(manifold.normal_W, point.place_W, meet_s, first, second);
    }
}

// Where they touch now, or where their ways first bring them together.
void look_ahead(double reach_s, ContactPair& pair, const RigidScene& scene) noexcept {
    const RigidWorldBody& first = scene.body(pair.bodies.first);
    const RigidWorldBody& second = scene.body(pair.bodies.second);
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
int count_patches(int i, const ContactPairs& pairs) noexcept {
    BodyPair next = pairs.at(i).bodies;
    int n = 0;
    for (int j = i; j < pairs.count() && n < kMostPatches; ++j, ++n) {
        if (!(pairs.at(j).bodies == next)) {
            break;
        }
        ++next.patch;
    }
    return n;
}

// The same in patches: what comes no farther than touches tell is found as it is, and what touches already.
void look_ahead_in_patches(double reach_s, int i, RigidScene& scene) noexcept {
    const BodyPair bodies = scene.pairs.at(i).bodies;
    const RigidWorldBody& first = scene.body(bodies.first);
    const RigidWorldBody& second = scene.body(bodies.second);
    const auto n = static_cast<std::size_t>(count_patches(i, scene.pairs));
    std::array<ContactManifold*, kMostPatches> all{};
    for (std::size_t k = 0; k < n; ++k) {
        ContactPair& pair = scene.pairs.at(i + static_cast<int>(k));
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
        scene.pairs.at(i).passes = true;
        return;
    }
    if (!(meet_s > 0.0)) {
        find_at(first.place, second.place, margin_m);
        return;
    }
    find_at(a.find_place(meet_s), b.find_place(meet_s), std::min(margin_m, slack_m + near_m));
    for (std::size_t k = 0; k < n; ++k) {
        scene.pairs.at(i + static_cast<int>(k)).meet_s = meet_s;
        tell_from_now(meet_s, first, second, *patches[k]);
    }
}

// Of pair i, and of one with patches in those that follow as well.
void find_contacts_of(double reach_s, int i, RigidScene& scene) noexcept {
    ContactPair& pair = scene.pairs.at(i);
    if (scene.meets_in_patches(pair.bodies)) {
        look_ahead_in_patches(reach_s, i, scene);
    } else {
        look_ahead(reach_s, pair, scene);
    }
}

}  // namespace

// What does not move has no way to lose.
void ContactsAhead::meet_at(double at_s, std::int32_t body, const RigidScene& scene) noexcept {
    if (scene.body(body).moves) {
        meets_s(body) = std::min(meets_s(body), at_s);
    }
}

// When each body first meets anything faster than what does not bounce, and which pairs that is true of: `n` of them, the k-th of which is
// `which(k)`.
template <class Which>
void ContactsAhead::find_first(int n, const Which& which, RigidScene& scene) noexcept {
    const auto each_pair = [&](auto&& visit) {
        for (int k = 0; k < n; ++k) {
            ContactPair& pair = scene.pairs.at(which(k));
            if (pair.manifold.count > 0) {
                visit(pair);
            }
        }
    };
    each_pair([&](const ContactPair& pair) {
        const RigidWorldBody& first = scene.body(pair.bodies.first);
        const RigidWorldBody& second = scene.body(pair.bodies.second);
        for (const ContactPoint& point : pair.manifold.points()) {
            const double speed =
                -find_apart(pair.manifold.normal_W, point.place_W, pair.meet_s, first, second);
            if (speed > least_bounce_m_per_s_) {
                const double at_s = std::max(point.gap_m, 0.0) / speed;
                meet_at(at_s, pair.bodies.first, scene);
                meet_at(at_s, pair.bodies.second, scene);
            }
        }
    });
    each_pair([&](ContactPair& pair) {
        pair.is_first = pair.meet_s <= kSameTime * std::min(meets_s(pair.bodies.first),
                                                            meets_s(pair.bodies.second));
    });
}

void ContactsAhead::find(double reach_s, RigidScene& scene) noexcept {
    for (int i = 0; i < scene.pairs.count(); ++i) {
        const ContactPair& pair = scene.pairs.at(i);
        RigidWorldBody& first = scene.body(pair.bodies.first);
        RigidWorldBody& second = scene.body(pair.bodies.second);
        // Those that sleep touch where they did.
        if (pair.bodies.patch == 0 && (!first.is_still() || !second.is_still())) {
            find_contacts_of(reach_s, i, scene);
        }
        // What was moved by a command wakes what it touches, though it makes no island with it.
        if (pair.manifold.count > 0 && (first.touched || second.touched)) {
            first.wake();
            second.wake();
        }
    }
    if (bounces_) {
        std::ranges::fill(meets_s_.all(), kNotMet);
        find_first(
            scene.pairs.count(), [](int k) { return k; }, scene);
    }
    for (RigidWorldBody& body : scene.bodies) {
        body.touched = body.touched && body.moves;
    }
}

void ContactsAhead::find_of(const IslandParts& parts, double reach_s, RigidScene& scene) noexcept {
    std::int32_t last = -1;
    for (const std::int32_t i : parts.pairs) {
        // Of one with patches the first, which finds them all.
        const std::int32_t first = i - scene.pairs.at(i).bodies.patch;
        if (first != last) {
            find_contacts_of(reach_s, first, scene);
            last = first;
        }
    }
    if (!bounces_) {
        return;
    }
    for (const std::int32_t i : parts.bodies) {
        meets_s(i) = kNotMet;
    }
    find_first(
        static_cast<int>(parts.pairs.size()),
        [&](int k) { return parts.pairs[static_cast<std::size_t>(k)]; }, scene);
}

bool ContactsAhead::is_apart(int i, const RigidScene& scene) noexcept {
    if (scene.pairs.at(i).bodies.patch > 0) {
        return false;
    }
    for (int k = 0; k < count_patches(i, scene.pairs); ++k) {
        if (scene.pairs.at(i + k).manifold.count > 0) {
            return false;
        }
    }
    return true;
}

}  // namespace fulcrum
