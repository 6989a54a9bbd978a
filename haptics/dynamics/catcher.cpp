#include "haptics/dynamics/catcher.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {

double Catcher::compute_reach_m(double body_radius_m) const noexcept {
    return std::max(plan_.opening_radius_m - 0.25 * body_radius_m, 0.5 * plan_.opening_radius_m);
}

Crossing Catcher::compute_crossing(const Vector3& before_T, const Vector3& after_T,
                                   double body_radius_m) const noexcept {
    const Vector3 a = before_T - plan_.rim_centre_T;
    const Vector3 b = after_T - plan_.rim_centre_T;
    if (!(a.y() >= 0.0 && b.y() < 0.0)) {
        return {};
    }
    Crossing crossing;
    crossing.share = a.y() / (a.y() - b.y());
    const Vector3 there = a + crossing.share * (b - a);
    crossing.radius_m = std::hypot(there.x(), there.z());
    crossing.inside = crossing.radius_m <= compute_reach_m(body_radius_m);
    return crossing;
}

Vector3 Catcher::compute_resting_place(double body_radius_m,
                                       std::span<const RigidBody> bodies) const noexcept {
    // Aside from the middle, each in another direction, as the seeds of a sunflower are.
    const double golden_angle_rad = std::numbers::pi * (3.0 - std::sqrt(5.0));
    const auto n_held = std::ranges::count_if(
        bodies, [](const RigidBody& body) { return body.where == BodyWhere::held; });
    const double aside_m = 0.6 * std::max(plan_.opening_radius_m - body_radius_m, 0.0);
    const double angle_rad = golden_angle_rad * static_cast<double>(n_held);
    Vector3 place = plan_.rim_centre_T +
                    Vector3(aside_m * std::cos(angle_rad), 0.0, aside_m * std::sin(angle_rad));
    // As low as the floor and the spheres that lie there allow: |place - other| >= r + r_other.
    place.y() = plan_.rim_centre_T.y() - plan_.depth_m + body_radius_m;
    for (const RigidBody& other : bodies) {
        if (other.where != BodyWhere::held) {
            continue;
        }
        const double reach_m = body_radius_m + other.radius_m;
        const double across_m = std::hypot(place.x() - other.resting_place_T.x(),
                                           place.z() - other.resting_place_T.z());
        if (across_m < reach_m) {
            place.y() = std::max(place.y(), other.resting_place_T.y() +
                                                std::sqrt(reach_m * reach_m - across_m * across_m));
        }
    }
    return place;
}

}  // namespace fulcrum
