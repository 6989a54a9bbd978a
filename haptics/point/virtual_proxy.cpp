#include "haptics/point/virtual_proxy.h"

#include "haptics/point/let_through.h"

#include <algorithm>
#include <limits>

namespace fulcrum {

namespace {

// Less than this part of the clearance is no motion.
constexpr double kProxyNoMotion = 0.01;
// A plane counts as respected up to this part of the clearance.
constexpr double kProxySlack = 0.1;
// After a free way shorter than this many clearances (1e-8 of the solid's size) the proxy has settled for this step.
constexpr double kProxySettled = 1.0e2;
// Steps of Newton's method from a tangent plane to the surface.
constexpr int kMostCorrections = 3;
// A plane of a gap of up to this many clearances is touched.
constexpr double kTouching = 2.0;
// A way over a bent feature is made longer by at most this.
constexpr double kLongest = 1000.0;
// What shrinks faster than to this part of itself a round needs no help.
constexpr double kSlow = 0.3;

bool is_for_proxy(const Vector3& hand_W) noexcept {
    return hand_W.allFinite() && hand_W.cwiseAbs().maxCoeff() <= VirtualProxy::kFarthest_m;
}

}  // namespace

VirtualProxy::VirtualProxy(std::vector<MovingObstacle> solids, const CursorTurning& turning)
    : solids_(std::move(solids)), turning_(turning) {
    near_.resize(solids_.size());
    reset(Vector3::Zero());
}

void VirtualProxy::reset(const Vector3& hand_W) noexcept {
    if (!is_for_proxy(hand_W)) {
        return;
    }
    planes_.count = 0;
    is_fresh_ = true;
    goal_W_ = hand_W;
    accept(hand_W);
    for (MovingObstacle& solid : solids_) {
        start_in(solid, hand_W, hand_W);
    }
    leave_surfaces();
    publish(proxy_W_);
}

void VirtualProxy::put_solid(std::size_t solid, const Pose& pose_W) noexcept {
    if (solid < solids_.size()) {
        put_at_once(solids_[solid], pose_W, proxy_W_, goal_W_, static_cast<std::int32_t>(solid),
                    planes_);
        publish(goal_W_);
    }
}

const ProxyContact& VirtualProxy::follow(const Vector3& goal_W) noexcept {
    if (!is_for_proxy(goal_W)) {
        return contact_;
    }
    reach_m_ = std::max((goal_W - goal_W_).norm(), std::numeric_limits<double>::min());
    goal_W_ = goal_W;
    find_near_solids(goal_W);
    follow_goal(goal_W, kMostCasts);
    publish(goal_W);
    return contact_;
}

void VirtualProxy::find_near_solids(const Vector3& goal_W) noexcept {
    // The distance to the hand never grows, but for clearances, so all that follows happens in this ball.
    const double radius_m = (proxy_W_ - goal_W).norm();
    n_near_ = 0;
    for (std::size_t i = 0; i < solids_.size(); ++i) {
        if (!solids_[i].lets_through() && solids_[i].is_near(goal_W, radius_m)) {
            near_[n_near_++] = static_cast<std::int32_t>(i);
        }
    }
}

void VirtualProxy::follow_goal(const Vector3& goal_W, int most_casts) noexcept {
    look_again();
    double least_m2 = std::numeric_limits<double>::infinity();
    while (n_casts_ < most_casts && go_on(goal_W, least_m2)) {
    }
}

// One round: to the place that the planes allow, or to what is met on the way. False when that was the last. `least_m2`: the squared
// distance to the goal from which a way was last made longer.
bool VirtualProxy::go_on(const Vector3& goal_W, double& least_m2) noexcept {
    Vector3 way = constrain(goal_W - proxy_W_, planes_);
    const bool is_free = planes_.count == 0;
    const double clearance_m = is_free ? 0.0 : planes_.plane[0].clearance_m;
    if (way.cwiseAbs().maxCoeff() <= kProxyNoMotion * clearance_m) {
        return false;
    }
    const double settled_m = kProxySettled * clearance_m;
    const bool is_long = way.squaredNorm() > settled_m * settled_m;
    // Longer ways only as long as they lead nearer to the goal.
    const double apart_m2 = (goal_W - proxy_W_).squaredNorm();
    if (is_long && apart_m2 < least_m2) {
        const Vector3 longer = lengthen(way);
        least_m2 = longer == way ? least_m2 : apart_m2;
        way = longer;
    }
    const Vector3 target_W = is_free ? goal_W : Vector3(proxy_W_ + way);
    const Blocker blocker = cast_all(target_W);
    if (blocker.solid != kNoBody) {
        return go_round(blocker, target_W, goal_W) || stop_at(blocker, target_W);
    }
    move_to(target_W);
    look_again();
    return !is_free && is_long;
}

// A feature that is not convex may be in the way along its own tangent plane: then to the surface over the plane's place.
bool VirtualProxy::go_round(const Blocker& blocker, const Vector3& target_W,
                            const Vector3& goal_W) noexcept {
    if (!holds(blocker)) {
        return false;
    }
    const MovingObstacle& solid = solids_[static_cast<std::size_t>(blocker.solid)];
    Vector3 over_W = target_W;
    for (int i = 0; i < kMostCorrections; ++i) {
        over_W = solid.move_off(blocker.hit.feature, over_W);
    }
    if (!((over_W - goal_W).squaredNorm() < (proxy_W_ - goal_W).squaredNorm()) ||
        cast_all(over_W).solid != kNoBody) {
        return false;
    }
    move_to(over_W);
    look_again();
    return true;
}

bool VirtualProxy::holds(const Blocker& blocker) const noexcept {
    const auto end = planes_.plane.begin() + static_cast<std::ptrdiff_t>(planes_.count);
    return std::any_of(planes_.plane.begin(), end, [&](const ObstaclePlane& plane) {
        return plane.solid == blocker.solid && plane.feature == blocker.hit.feature;
    });
}

// Goes to the first meeting on the way, and takes what is met there to the planes. False when that is nothing new.
bool VirtualProxy::stop_at(const Blocker& blocker, const Vector3& target_W) noexcept {
    move_to(proxy_W_ + blocker.hit.t * (target_W - proxy_W_));
    look_again();
    // What no longer touches need not be known: it will be met again if it is in the way.
    Planes touching;
    for (std::size_t i = 0; i < planes_.count && touching.count < kMaxTouches; ++i) {
        if (planes_.plane[i].gap_m <= kTouching * planes_.plane[i].clearance_m) {
            touching.plane[touching.count++] = planes_.plane[i];
        }
    }
    planes_ = touching;
    const bool is_known = holds(blocker);
    if (!is_known) {
        planes_.plane[planes_.count++] =
            solids_[static_cast<std::size_t>(blocker.solid)].find_plane(blocker.hit.feature);
    }
    return !is_known || blocker.hit.t > 0.0;
}

// Where to go to be as near to the wish as the planes allow; keeps the planes that push.
Vector3 VirtualProxy::constrain(const Vector3& wish, Planes& planes) noexcept {
    return planes.constrain(wish, kProxySlack,
                            [](const ObstaclePlane& plane) { return plane.gap_m; });
}

// A way along tangent planes stops short where the surface turns with the proxy, and beyond a ridge hardly leaves it: what is left
// shrinks to q = sum push_i curvature_i of itself a round. The way to the end of that series is 1 / (1 - q) as long, but at
// most as far as the features are bent.
Vector3 VirtualProxy::lengthen(const Vector3& way) const noexcept {
    if (planes_.count == 0 || planes_.count > 2) {
        return way;
    }
    const ObstaclePlane& first = planes_.plane[0];
    // The part of the way along which the surface bends: across the straight direction, or along both planes.
    Vector3 bent = way - first.normal_W.dot(way) * first.normal_W;
    if (planes_.count == 1) {
        bent -= first.straight_W.dot(bent) * first.straight_W;
    } else {
        const Vector3 along = first.normal_W.cross(planes_.plane[1].normal_W).normalized();
        bent = along.dot(way) * along;
    }
    const double length_m = bent.norm();
    double q = 0.0;
    for (std::size_t i = 0; i < planes_.count && length_m > 0.0; ++i) {
        const ObstaclePlane& plane = planes_.plane[i];
        const double along = plane.straight_W.dot(bent) / length_m;
        q += planes_.push_m[i] * plane.curvature_per_m * (1.0 - along * along);
    }
    if (!(q > kSlow)) {
        return way;
    }
    double factor = q < 1.0 - 1.0 / kLongest ? 1.0 / (1.0 - q) : kLongest;
    for (std::size_t i = 0; i < planes_.count; ++i) {
        const ObstaclePlane& plane = planes_.plane[i];
        if (plane.curvature_per_m > 0.0) {
            const double bend_m = solids_[static_cast<std::size_t>(plane.solid)].find_bend(
                plane.feature, bent / length_m);
            factor = std::min(factor, bend_m / length_m);
        }
    }
    return way + std::max(factor - 1.0, 0.0) * bent;
}

VirtualProxy::Blocker VirtualProxy::cast_all(const Vector3& to_W) noexcept {
    std::array<Vector3, kMaxPlanes> normals_W;
    for (std::size_t i = 0; i < planes_.count; ++i) {
        normals_W[i] = planes_.plane[i].normal_W;
    }
    Blocker nearest;
    ++n_casts_;
    for (std::size_t i = 0; i < n_near_; ++i) {
        const CastHit hit = solids_[static_cast<std::size_t>(near_[i])].cast(
            to_W, reach_m_, std::span(normals_W.data(), planes_.count));
        if (hit.found() && hit.t < nearest.hit.t) {
            nearest = {near_[i], hit};
        }
    }
    return nearest;
}

void VirtualProxy::move_to(const Vector3& proxy_W) noexcept {
    proxy_W_ = proxy_W;
    for (std::size_t i = 0; i < n_near_; ++i) {
        solids_[static_cast<std::size_t>(near_[i])].put_proxy(proxy_W);
    }
}

// The planes anew, from where the proxy is now.
void VirtualProxy::look_again() noexcept {
    for (std::size_t i = 0; i < planes_.count; ++i) {
        ObstaclePlane& plane = planes_.plane[i];
        plane = solids_[static_cast<std::size_t>(plane.solid)].find_plane(plane.feature);
    }
}

void VirtualProxy::publish(const Vector3& goal_W) noexcept {
    for (MovingObstacle& solid : solids_) {
        solid.put_proxy(proxy_W_);
    }
    planes_.tell_contact(proxy_W_, goal_W, contact_);
}

}  // namespace fulcrum
