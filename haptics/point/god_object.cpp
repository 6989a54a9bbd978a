#include "haptics/point/god_object.h"

#include "haptics/math/length.h"
#include "haptics/point/let_through.h"

#include <algorithm>
#include <limits>

namespace fulcrum {

namespace {

// Less than this part of the clearance is no motion.
constexpr double kNoMotion = 0.01;
// A plane counts as respected up to this part of the clearance.
constexpr double kSlack = 0.25;
// A step with no more sweeps than this has time to look ahead for the next ones.
constexpr int kFewSweeps = 6;

bool is_usable(const Vector3& hand_W) noexcept {
    return hand_W.allFinite() && largest_component(hand_W) <= GodObject::kFarthest_m;
}

}  // namespace

template <class Solid>
GodObjectAmong<Solid>::GodObjectAmong(const std::vector<SolidPlan>& solids,
                                      SegmentStructureKind structure) {
    solids_.reserve(solids.size());
    near_.resize(solids.size());
    for (const SolidPlan& solid : solids) {
        solids_.emplace_back(solid, static_cast<std::int32_t>(solids_.size()), structure);
    }
    reset(Vector3::Zero());
}

template <class Solid>
void GodObjectAmong<Solid>::reset(const Vector3& hand_W) noexcept {
    if (!is_usable(hand_W)) {
        return;
    }
    planes_.count = 0;
    n_known_ = 0;
    goal_W_ = hand_W;
    accept(hand_W);
    for (Solid& solid : solids_) {
        start_in(solid, hand_W, hand_W);
    }
    leave_surface();
    publish(proxy_W_);
}

template <class Solid>
void GodObjectAmong<Solid>::put_solid(std::size_t solid, const Pose& pose_W) noexcept {
    if (solid < solids_.size()) {
        put_at_once(solids_[solid], pose_W, proxy_W_, goal_W_, static_cast<std::int32_t>(solid),
                    planes_);
        publish(goal_W_);
    }
}

template <class Solid>
const ProxyContact& GodObjectAmong<Solid>::follow(const Vector3& goal_W) noexcept {
    if (!is_usable(goal_W)) {
        return contact_;
    }
    reach_m_ = std::max(largest_component(goal_W - goal_W_), std::numeric_limits<double>::min());
    goal_W_ = goal_W;
    find_near_solids(goal_W);
    follow_goal(goal_W);
    publish(goal_W);
    look_ahead();
    return contact_;
}

template <class Solid>
void GodObjectAmong<Solid>::look_ahead() noexcept {
    if (planes_.count == 0 || n_sweeps_ > kFewSweeps) {
        return;
    }
    for (const std::int32_t index : near_solids()) {
        solids_[static_cast<std::size_t>(index)].look_ahead(reach_m_);
    }
}

template <class Solid>
void GodObjectAmong<Solid>::find_near_solids(const Vector3& goal_W) noexcept {
    // The distance to the hand never grows, so all that follows happens in this ball.
    const double radius_m = compute_length(Vector3(proxy_W_ - goal_W));
    n_near_ = 0;
    for (std::size_t i = 0; i < solids_.size(); ++i) {
        if (!solids_[i].lets_through() && solids_[i].is_near(goal_W, radius_m)) {
            near_[n_near_++] = static_cast<std::int32_t>(i);
        }
    }
}

template <class Solid>
void GodObjectAmong<Solid>::follow_goal(const Vector3& goal_W) noexcept {
    (void)renew_planes();
    // Planes are taken anew without a sweep: rounds are counted too.
    for (int round = 0; round < kMaxSweeps && n_sweeps_ < kMaxSweeps; ++round) {
        const Vector3 way = constrain(goal_W - proxy_W_, proxy_W_, planes_);
        const Advance advanced = advance(planes_.count == 0 ? goal_W : proxy_W_ + way);
        if (advanced.blocked && !contains(planes_, advanced.plane)) {
            planes_.plane[planes_.count++] = advanced.plane;
            remember(advanced.plane);
            continue;
        }
        if (!find_way_on(goal_W, advanced.moved_m > 0.0)) {
            return;
        }
    }
}

// Where to go from `from_W` to be as near to the wish as the planes allow; keeps the planes that push.
template <class Solid>
Vector3 GodObjectAmong<Solid>::constrain(const Vector3& wish, const Vector3& from_W,
                                         Planes& planes) noexcept {
    return planes.constrain(wish, kSlack,
                            [&](const TouchedPlane& plane) { return plane.height_m(from_W); });
}

// Moves towards the target, up to the first triangle.
template <class Solid>
typename GodObjectAmong<Solid>::Advance GodObjectAmong<Solid>::advance(
    const Vector3& target_W) noexcept {
    const double least_m = planes_.count == 0 ? 0.0 : kNoMotion * planes_.plane[0].clearance_m;
    const Vector3 way = target_W - proxy_W_;
    if (largest_component(way) <= least_m) {
        return {};
    }
    const Blocker blocker = sweep_all(target_W);
    if (blocker.solid == kNoBody) {
        move_to(target_W);
        return {.blocked = false, .moved_m = compute_length(way), .plane = {}};
    }
    Advance result{.blocked = true, .moved_m = 0.0, .plane = {}};
    result.plane = solids_[static_cast<std::size_t>(blocker.solid)].find_plane(blocker.hit.triangle,
                                                                               blocker.hit.side);
    // Back along the segment to the height of the clearance; the segment up to there is free, but for rounding.
    const double height_m = result.plane.height_m(proxy_W_);
    const double fall_m = height_m - result.plane.height_m(target_W);
    const double t = fall_m > 0.0
                         ? std::min((height_m - result.plane.clearance_m) / fall_m, blocker.hit.t)
                         : 0.0;
    const Vector3 stop_W = proxy_W_ + t * way;
    if (t > 0.0 && sweep_all(stop_W).solid == kNoBody) {
        result.moved_m = compute_length(Vector3(stop_W - proxy_W_));
        move_to(stop_W);
    }
    return result;
}

template <class Solid>
typename GodObjectAmong<Solid>::Blocker GodObjectAmong<Solid>::sweep_all(
    const Vector3& to_W) noexcept {
    Blocker nearest;
    ++n_sweeps_;
    for (const std::int32_t index : near_solids()) {
        Solid& solid = solids_[static_cast<std::size_t>(index)];
        const SegmentHit hit =
            planes_.count > 0 ? solid.sweep_nearby(to_W, reach_m_) : solid.sweep(to_W);
        if (hit.found() && hit.t < nearest.hit.t) {
            nearest = {index, hit};
        }
    }
    return nearest;
}

template <class Solid>
void GodObjectAmong<Solid>::move_to(const Vector3& proxy_W) noexcept {
    proxy_W_ = proxy_W;
    for (const std::int32_t index : near_solids()) {
        solids_[static_cast<std::size_t>(index)].put_proxy(proxy_W);
    }
}

// Planes of bent solids anew where the proxy is; true when it must come nearer to one of them.
template <class Solid>
bool GodObjectAmong<Solid>::renew_planes() noexcept {
    bool any = false;
    if constexpr (Solid::kBends) {
        for (std::size_t i = 0; i < planes_.count; ++i) {
            TouchedPlane& plane = planes_.plane[i];
            any = solids_[static_cast<std::size_t>(plane.solid)].renew(plane) || any;
        }
    }
    return any;
}

// At rest, where planes that are taken anew bring it no nearer: does each plane that pushes belong to a triangle right under the proxy? Otherwise try without it.
template <class Solid>
bool GodObjectAmong<Solid>::find_way_on(const Vector3& goal_W, bool has_moved) noexcept {
    if (renew_planes() && has_moved) {
        return true;
    }
    const unsigned all = (1U << planes_.count) - 1U;
    unsigned under = 0;
    for (std::size_t i = 0; i < planes_.count; ++i) {
        const TouchedPlane& plane = planes_.plane[i];
        under |=
            solids_[static_cast<std::size_t>(plane.solid)].is_over(plane.feature) ? 1U << i : 0U;
    }
    if (under == all) {
        return false;
    }
    if (try_without(goal_W, under)) {
        return true;
    }
    for (unsigned kept = 0; kept < all; ++kept) {
        if (kept != under && try_without(goal_W, kept)) {
            return true;
        }
    }
    return false;
}

// Moves as far as the kept planes alone allow. True when that gained something: a way, or a triangle not yet known.
template <class Solid>
bool GodObjectAmong<Solid>::try_without(const Vector3& goal_W, unsigned kept) noexcept {
    if (n_sweeps_ >= kMaxSweeps) {
        return false;
    }
    const double gain_m = planes_.plane[0].clearance_m;
    Planes fewer;
    for (std::size_t i = 0; i < planes_.count; ++i) {
        if ((kept & (1U << i)) != 0) {
            fewer.plane[fewer.count++] = planes_.plane[i];
        }
    }
    const Vector3 way = constrain(goal_W - proxy_W_, proxy_W_, fewer);
    const Advance advanced = advance(fewer.count == 0 ? goal_W : proxy_W_ + way);
    const bool is_new = advanced.blocked && !is_known(advanced.plane);
    if (!is_new && !(advanced.moved_m > gain_m)) {
        return false;
    }
    if (advanced.blocked && !contains(fewer, advanced.plane)) {
        fewer.plane[fewer.count++] = advanced.plane;
        remember(advanced.plane);
    }
    planes_ = fewer;
    return true;
}

template <class Solid>
bool GodObjectAmong<Solid>::contains(const Planes& planes, const TouchedPlane& other) noexcept {
    return std::ranges::any_of(planes.all(), [&other](const TouchedPlane& mine) {
        return mine.solid == other.solid && mine.feature == other.feature;
    });
}

template <class Solid>
bool GodObjectAmong<Solid>::is_known(const TouchedPlane& plane) const noexcept {
    return std::any_of(known_.begin(), known_.begin() + static_cast<std::ptrdiff_t>(n_known_),
                       [&plane](const KnownTriangle& known) {
                           return known.solid == plane.solid && known.triangle == plane.feature;
                       });
}

template <class Solid>
void GodObjectAmong<Solid>::remember(const TouchedPlane& plane) noexcept {
    if (n_known_ < kMaxKnown && !is_known(plane)) {
        known_[n_known_++] = {plane.solid, plane.feature};
    }
}

template <class Solid>
void GodObjectAmong<Solid>::publish(const Vector3& goal_W) noexcept {
    for (Solid& solid : solids_) {
        solid.put_proxy(proxy_W_);
    }
    planes_.tell_contact(proxy_W_, goal_W, contact_);
}

template <class Solid>
std::uint64_t GodObjectAmong<Solid>::n_searches() const noexcept {
    std::uint64_t n = 0;
    for (const Solid& solid : solids_) {
        n += solid.n_searches();
    }
    return n;
}

template class GodObjectAmong<MovingSolid>;
template class GodObjectAmong<MixedSolid>;

}  // namespace fulcrum
