#include "haptics/point/friction_problem.h"

#include "haptics/point/plane_constraints.h"

#include <algorithm>
#include <array>

namespace fulcrum {
namespace {

// A round that changes less than this, of the hand's distance, changes nothing that can be felt.
constexpr double kSettled = 1.0e-12;

// The drag of one plane that would be left with the slip `free` if it had none, and is pushed by `push_m`.
void solve_plane(const Vector3& free, FrictionPlane& plane) noexcept {
    const double free_m = free.norm();
    const double circle_m = plane.push_m * (plane.was_stuck ? plane.law.static_coefficient
                                                            : plane.law.dynamic_coefficient);
    plane.stuck = !(plane.push_m > 0.0) || free_m <= circle_m;
    if (!(plane.push_m > 0.0)) {
        plane.drag.setZero();
    } else if (plane.stuck) {
        plane.drag = -free;
    } else {
        // |f| = mu l + beta (|free| - |f|), for friction takes that much of the slip away; less than |free|, for mu l is.
        const double beta = plane.law.viscous_ratio;
        const double drag_m =
            (plane.law.dynamic_coefficient * plane.push_m + beta * free_m) / (1.0 + beta);
        plane.drag = free * (-drag_m / free_m);
    }
}

// How far the point, `place` from the hand, has slipped over the plane.
Vector3 find_slip(const Vector3& hand, const Vector3& place, const FrictionPlane& plane) noexcept {
    const Vector3 away = place - (plane.anchor - hand);
    return away - plane.normal.dot(away) * plane.normal;
}

// Where the point lies from the hand under the drags as they are; sets the pushes. Seen from the hand, for far from the origin
// rounding of the world's coordinates is more than a light touch.
Vector3 solve_pushes(const Vector3& hand, std::span<FrictionPlane> planes,
                     double slack_m) noexcept {
    Vector3 wish = Vector3::Zero();
    std::array<PlaneConstraint, kMaxPlanes> constraints;
    const std::size_t n = std::min(planes.size(), kMaxPlanes);
    for (std::size_t i = 0; i < n; ++i) {
        wish += planes[i].drag;
        constraints[i] = {planes[i].normal, planes[i].normal.dot(planes[i].point - hand)};
        planes[i].push_m = 0.0;
    }
    const ConstrainedPoint found =
        compute_constrained_point(wish, std::span(constraints.data(), n), slack_m);
    for (std::size_t i = 0; i < static_cast<std::size_t>(found.n_active); ++i) {
        planes[static_cast<std::size_t>(found.active[i])].push_m = found.multiplier[i];
    }
    return found.feasible ? found.position : wish;
}

}  // namespace

FrictionLaw make_friction_law(const FrictionSettings& settings, double stiffness_N_per_m,
                              double period_s) noexcept {
    const double step_Ns_per_m = stiffness_N_per_m * period_s;
    return {settings.static_coefficient, settings.dynamic_coefficient,
            step_Ns_per_m > 0.0 ? settings.viscous_Ns_per_m / step_Ns_per_m : 0.0};
}

double find_coefficient(const FrictionPlane& plane) noexcept {
    return plane.stuck && plane.was_stuck ? plane.law.static_coefficient
                                          : plane.law.dynamic_coefficient;
}

double solve_friction(const Vector3& hand, std::span<FrictionPlane> planes,
                      int max_rounds) noexcept {
    double reach_m = 0.0;
    for (FrictionPlane& plane : planes) {
        plane.drag.setZero();
        reach_m = std::max(reach_m, (plane.anchor - hand).norm());
    }
    if (planes.size() == 1) {
        FrictionPlane& plane = planes.front();
        plane.push_m = std::max(plane.normal.dot(plane.point - hand), 0.0);
        solve_plane(find_slip(hand, Vector3::Zero(), plane), plane);
        return 0.0;
    }
    const double settled_m = kSettled * reach_m;
    Vector3 place = solve_pushes(hand, planes, settled_m);
    double change_m = 0.0;
    for (int round = 0; round < max_rounds; ++round) {
        change_m = 0.0;
        for (FrictionPlane& plane : planes) {
            const Vector3 before = plane.drag;
            const double push_m = plane.push_m;
            solve_plane(find_slip(hand, place, plane) - before, plane);
            place = solve_pushes(hand, planes, settled_m);
            change_m =
                std::max({change_m, (plane.drag - before).norm(), std::abs(plane.push_m - push_m)});
        }
        if (change_m <= settled_m) {
            break;
        }
    }
    return change_m;
}

}  // namespace fulcrum
