// A tool whose contacts are found beside its steps, pressed at rest, while who finds them is silent for a while: what is felt meanwhile, and after.
#pragma once

#include "haptics/tool/contact_age.h"
#include "haptics/tool/tool_solver.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace fulcrum::test {

/// Held for hold_s, gone fade_s later, evenly, and come back as evenly. `hand_at(t)` presses from 0.25 s on; who finds contacts is silent for 0.3 s
/// from `from_s` on; `check_gone` is called in each step in which nothing may be felt.
template <class Tool, class HandAt, class CheckGone>
void check_silent_contacts(Tool& tool, const ContactAgeSettings& age, HandAt hand_at, double from_s,
                           CheckGone check_gone) {
    constexpr double kStep_s = 0.001;
    constexpr double kPressed_s = 0.25;
    constexpr double kSilent_s = 0.3;
    const MovingFrame object;
    tool.place(hand_at(0.0));
    Wrench before;
    double held_N = 0.0;
    const int n_from = static_cast<int>(from_s / kStep_s + 0.5);
    for (int i = 1; i <= n_from + 600; ++i) {
        const double t_s = i * kStep_s;
        const double silent_s = t_s - from_s;
        const ToolFelt felt =
            tool.move({hand_at(std::min(t_s, kPressed_s)), {}}, {&object, 1}, t_s, kStep_s);
        if (i <= n_from || silent_s > kSilent_s) {
            (void)tool.beside()->run_once();
        }
        held_N = i == n_from ? felt.felt_W.force.norm() : held_N;
        if (i > n_from && silent_s < age.hold_s - kStep_s) {
            REQUIRE(felt.felt_W.force.norm() == Approx(held_N).epsilon(1e-3));
            REQUIRE_FALSE(tool.contact_age().is_lost());
        }
        if (silent_s < kSilent_s && silent_s > age.hold_s + age.fade_s + 2.0 * kStep_s) {
            REQUIRE(felt.felt_W.force == Vector3::Zero());
            REQUIRE(felt.spring_W.force == Vector3::Zero());
            REQUIRE(felt.spring_energy_J == 0.0);
            REQUIRE(tool.contact_age().is_lost());
            REQUIRE(tool.contact_age().is_late());
            check_gone();
        }
        if (i > n_from + 1) {
            REQUIRE((felt.felt_W.force - before.force).norm() <
                    1.1 * held_N * kStep_s / age.fade_s);
        }
        before = felt.felt_W;
    }
    CHECK(held_N > 3.0);
    CHECK(before.force.norm() == Approx(held_N).epsilon(1e-3));
}

}  // namespace fulcrum::test
