// A hand that slides over a ball with bumps of 3 %, pressed in 2 % of the radius, and what a step takes where every pass does the same
// steps: the least over the passes is what it costs when the machine does nothing else.
#pragma once

#include "haptics/point/proxy.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/wander.h"

namespace fulcrum::bench {

inline constexpr double kPressedIn = 0.02;
inline constexpr double kBumpHeight = 0.03;
inline constexpr double kBumpsRound = 20.0;
inline constexpr int kWarmSteps = 200;

[[nodiscard]] inline double bumpy_radius(const Vector3& u) {
    return 1.0 + kBumpHeight *
                     (std::sin(kBumpsRound * u.x()) + std::sin(kBumpsRound * u.y()) +
                      std::sin(kBumpsRound * u.z())) /
                     3.0;
}

/// So far over the place pressed to: the radius of what is pressed.
[[nodiscard]] inline std::vector<Vector3> make_hands(int n, double step, double over = 0.0) {
    Wanderer wanderer(1, step);
    std::vector<Vector3> hands;
    for (int i = 0; i < n; ++i) {
        const Vector3& u = wanderer.next();
        hands.emplace_back(u * (bumpy_radius(u) + over - kPressedIn));
    }
    return hands;
}

/// Steps a proxy along the hands, `n_passes` times; `look(contact, hand, is_warm)` after each of the first pass.
template <class Look>
[[nodiscard]] Cost measure_passes(Proxy& proxy, const std::vector<Vector3>& hands, int n_passes,
                                  const Look& look) {
    std::vector<double> least_us(hands.size(), HUGE_VAL);
    for (int pass = 1; pass <= n_passes; ++pass) {
        proxy.reset(1.1 * hands[0]);
        for (std::size_t i = 0; i < hands.size(); ++i) {
            const ProxyContact* contact = nullptr;
            least_us[i] = std::min(least_us[i],
                                   time_by_clock_us([&] { contact = &proxy.step(hands[i], {}); }));
            if (pass == 1) {
                look(*contact, hands[i], i >= kWarmSteps);
            }
        }
    }
    least_us.erase(least_us.begin(), least_us.begin() + kWarmSteps);
    return summarise(std::move(least_us));
}

}  // namespace fulcrum::bench
