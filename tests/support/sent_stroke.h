// A hand that strokes a true surface with the plan and the gate of a lesson, and what is sent to it along the surface.
#pragma once

#include "haptics/surface/material.h"
#include "tests/support/sent_force.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace fulcrum::test {

inline constexpr double kStrokePush_N = 2.0;

/// A place on a true surface along a stroke, with its normal.
struct Place {
    Vector3 at_W;
    Vector3 normal_W;
};
using Way = std::function<Place(double way_m)>;

struct SentStroke {
    double sideways_N = 0.0;    ///< root mean square, less what the spring alone has
    double along_N = -1.0e9;    ///< most that points along the way
    double cone = 0.0;          ///< most of tangential over normal force while it slides
    double least_cone = 1.0e9;  ///< and the least
};

/// Strokes with 2 N of the spring, after coming in from outside. What is sent is judged by the normal that `normal_at` has at the proxy, which
/// friction holds back; without it by that over the hand.
inline SentStroke stroke(SentForce& loop, const Material& material, const Way& way,
                         double speed_m_per_s,
                         const std::function<Vector3(const Vector3& place_W)>& normal_at = {}) {
    constexpr double kDt_s = 0.001;
    constexpr double kAway_m = 0.002;
    const auto hand_at = [&](double way_m, double deep_m) {
        const Place place = way(way_m);
        return Vector3(place.at_W - deep_m * place.normal_W);
    };
    const double deep_m = kStrokePush_N / material.coupling.stiffness_N_per_m;
    loop.open_gate(hand_at(0.0, -kAway_m));
    for (double in_m = -kAway_m; in_m < deep_m; in_m += 2.0e-5) {
        (void)loop.step(hand_at(0.0, in_m));
    }
    SentStroke sent;
    double squares = 0.0;
    int n = 0;
    Vector3 before_W = hand_at(0.0, deep_m);
    const double settled_m = 0.02 + 0.05 * speed_m_per_s;
    for (double way_m = 0.0; way_m < settled_m + 0.1; way_m += kDt_s * speed_m_per_s) {
        const Place place = way(way_m);
        const Vector3 hand_W = place.at_W - deep_m * place.normal_W;
        const Vector3 force_W = loop.step(hand_W);
        if (way_m > settled_m) {
            const Vector3 normal_W =
                normal_at ? normal_at(loop.state().proxy_position_W) : place.normal_W;
            const Vector3 side_W = force_W - force_W.dot(normal_W) * normal_W;
            const Vector3 moved_W = hand_W - before_W;
            const double cone = side_W.norm() / force_W.dot(normal_W);
            squares += side_W.squaredNorm();
            sent.along_N = std::max(sent.along_N, side_W.dot(moved_W.normalized()));
            sent.cone = std::max(sent.cone, cone);
            sent.least_cone = std::min(sent.least_cone, cone);
            ++n;
        }
        before_W = hand_W;
    }
    sent.sideways_N = std::sqrt(squares / n);
    return sent;
}

/// Without all that is felt along it.
inline Material bare(const Material& shipped) {
    Material material = shipped;
    material.friction = {};
    material.texture = {};
    material.transient = {};
    return material;
}

}  // namespace fulcrum::test
