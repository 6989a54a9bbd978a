#include "haptics/point/friction_problem.h"

#include <algorithm>

namespace fulcrum {
namespace {

// A round that changes less than this, of the hand's distance, changes nothing that can be felt.
constexpr double kSettled = 1.0e-12;

// Push and drag of one plane, were the point at `free` without it. Returns how much that changes.
double solve_plane(const Vector3& free, FrictionPlane& plane) noexcept {
    const Vector3& n = plane.normal;
    const double push_m = std::max(n.dot(plane.point - free), 0.0);
    const Vector3 away = free - plane.anchor;
    const Vector3 slip = away - n.dot(away) * n;
    const double slip_m = slip.norm();
    const double circle_m =
        push_m * (plane.stuck ? plane.law.static_coefficient : plane.law.dynamic_coefficient);
    Vector3 drag = Vector3::Zero();
    bool stuck = true;
    if (push_m > 0.0 && slip_m <= circle_m) {
        drag = -slip;
    } else if (push_m > 0.0) {
        // |f| = mu l + beta (|slip| - |f|), for friction takes that much of the slip away.
        const double beta = plane.law.viscous_ratio;
        const double drag_m = std::min(
            (plane.law.dynamic_coefficient * push_m + beta * slip_m) / (1.0 + beta), slip_m);
        drag = slip * (-drag_m / slip_m);
        stuck = false;
    }
    const double change_m = std::abs(push_m - plane.push_m) + (drag - plane.drag).norm();
    plane.push_m = push_m;
    plane.drag = drag;
    plane.stuck = stuck;
    return change_m;
}

}  // namespace

FrictionLaw make_friction_law(const FrictionSettings& settings, double stiffness_N_per_m,
                              double period_s) noexcept {
    const double step_Ns_per_m = stiffness_N_per_m * period_s;
    return {settings.static_coefficient, settings.dynamic_coefficient,
            step_Ns_per_m > 0.0 ? settings.viscous_Ns_per_m / step_Ns_per_m : 0.0};
}

double solve_friction(const Vector3& hand, std::span<FrictionPlane> planes,
                      int max_rounds) noexcept {
    Vector3 held = Vector3::Zero();  // sum of all pushes and drags
    double reach_m = 0.0;
    for (FrictionPlane& plane : planes) {
        plane.push_m = 0.0;
        plane.drag.setZero();
        reach_m = std::max(reach_m, (plane.anchor - hand).norm());
    }
    double change_m = 0.0;
    for (int round = 0; round < max_rounds; ++round) {
        change_m = 0.0;
        for (FrictionPlane& plane : planes) {
            held -= plane.push_m * plane.normal + plane.drag;
            change_m = std::max(change_m, solve_plane(hand + held, plane));
            held += plane.push_m * plane.normal + plane.drag;
        }
        if (planes.size() < 2 || change_m <= kSettled * reach_m) {
            return planes.size() < 2 ? 0.0 : change_m;
        }
    }
    return change_m;
}

}  // namespace fulcrum
