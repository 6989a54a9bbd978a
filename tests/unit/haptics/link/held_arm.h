// A program that holds an arm over the link and asks for the same wrench in every round.
#pragma once

#include "tests/support/link.h"
#include "tests/support/scripted_device.h"

#include <catch2/catch.hpp>

#include <cstdint>

namespace fulcrum::test_link {

inline constexpr double kStep_s = LinkPair::kStep_s;

// A program that asks for `wrench` in every round, after a soft start.
struct Held {
    explicit Held(const LinkFaults& faults = {}, const ArmServerSettings& server = {},
                  const LinkDeviceSettings& device = {})
        : pair(hand, faults, server, device) {}

    void run(int n) {
        for (int i = 0; i < n; ++i) {
            pair.now_s += kStep_s;
            if (serves) {
                pair.server.step(pair.now_s);
            }
            gives_pose = pair.device.read(pair.now_s, reading);
            if (commands) {
                takes = pair.device.write(pair.now_s, wrench);
            }
            n_poses += gives_pose ? 1 : 0;
        }
    }
    // Linked, and the arm feels 3 N.
    void engage() {
        REQUIRE(pair.link());
        run(200);
        wrench.force = {3.0, 0.0, 0.0};
        run(3000);
        REQUIRE(hand.written_D.force.x() == Approx(3.0).epsilon(1e-9));
    }
    [[nodiscard]] ArmServerStatus arm() { return pair.server.status(); }
    [[nodiscard]] std::uint64_t refused(Refusal why) {
        return arm().counts.received[static_cast<std::size_t>(why)];
    }

    ScriptedDevice hand;
    LinkPair pair;
    Wrench wrench{};
    DeviceReading reading{};
    bool serves = true;
    bool commands = true;
    bool gives_pose = false;
    bool takes = false;
    int n_poses = 0;
};

}  // namespace fulcrum::test_link
