// Hands that go a closed path round and round for ever: what a force that is no gradient gives them.
#pragma once

#include "haptics/math/spatial.h"
#include "tests/support/sent_force.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace fulcrum::test {

/// A closed path: where the hand is at a share of it.
using Path = std::function<Vector3(double share)>;

struct Given {
    double first_J = 0.0;  ///< in the first rounds
    double last_J = 0.0;   ///< in as many later ones
    double took_s = 0.0;   ///< the later ones
    double way_m = 0.0;    ///< in them
};

/// So many rounds, and as many later ones; the gate is open and the hand is on the path.
[[nodiscard]] inline Given go_round(SentForce& loop, const Path& path, double round_s,
                                    int n_rounds = 20) {
    Given given;
    Vector3 before_W = path(0.0);
    Vector3 before_N = loop.step(before_W);
    const double step = 1.0 / (round_s * loop.plan().rate_hz);
    for (int round = 0; round < 2 * n_rounds; ++round) {
        for (double share = step; share < 1.0; share += step) {
            const Vector3 hand_W = path(share);
            const double work_J = before_N.dot(hand_W - before_W);
            (round < n_rounds ? given.first_J : given.last_J) += work_J;
            given.way_m += round < n_rounds ? 0.0 : (hand_W - before_W).norm();
            before_N = loop.step(hand_W);
            before_W = hand_W;
        }
    }
    given.took_s = n_rounds * round_s;
    return given;
}

/// There and back along an arc of a ball, deeper on the way there.
[[nodiscard]] inline Path make_arc(double radius_m, double from_rad, double span_rad, double deep_m,
                                   double shallow_m) {
    static const Vector3 kAlong = Vector3(0.8, 0.1, -0.59).normalized();
    static const Vector3 kAcross = kAlong.cross(Vector3(0.2, 1.0, 0.4)).normalized();
    return [=](double share) {
        const double turn = 2.0 * std::numbers::pi * share;
        const double angle = from_rad + 0.5 * span_rad * (1.0 - std::cos(turn));
        const double depth_m =
            0.5 * (deep_m + shallow_m) + 0.5 * (deep_m - shallow_m) * std::sin(turn);
        return Vector3((radius_m - depth_m) *
                       (std::cos(angle) * kAlong + std::sin(angle) * kAcross));
    };
}

}  // namespace fulcrum::test
