// Two hands in one round, and what they do, kept: for tests of runs that are repeated from their records.
#pragma once

#include "haptics/device/replay/recorded_traits.h"
#include "haptics/device/replay/replay_device.h"
#include "haptics/loop/hands_loop.h"
#include "haptics/loop/told_rings.h"
#include "haptics/record/record_writer.h"
#include "tests/support/scripted_device.h"
#include "tests/unit/runtime/rig.h"

#include <bit>

namespace fulcrum::runtime::test {

struct TwoHands {
    TwoHands(const HapticPlan& plan, Device& first, Device& second)
        : loops{HapticLoop(plan, first, channels[0]), HapticLoop(plan, second, channels[1])},
          hands(std::array{HandInRound{&loops[0], &channels[0]},
                           HandInRound{&loops[1], &channels[1]}}) {
        for (std::size_t i = 0; i < 2; ++i) {
            channels[i].record = &rings[i];
            told[i] = std::make_unique<ToldRings>(channels[i]);
        }
    }
    void keep_told() {
        for (std::size_t i = 0; i < 2; ++i) {
            channels[i].told = told[i].get();
        }
    }
    void drain() {
        for (std::size_t i = 0; i < 2; ++i) {
            for (RecordRound round; rings[i].pop(round);) {
                rounds[i].push_back(round);
            }
        }
    }
    std::array<HapticChannels, 2> channels;
    std::array<RecordRing, 2> rings;
    std::array<std::unique_ptr<ToldRings>, 2> told;
    std::array<HapticLoop, 2> loops;
    HandsLoop hands;
    std::array<std::vector<RecordRound>, 2> rounds;
};

/// Of a run of two hands with these effects, the first on this device.
inline RecordHeader make_header(const ScriptedDevice& first, std::vector<std::string> effects,
                                std::vector<std::string> effects_of_second) {
    RecordHeader header;
    header.lesson = "springs";
    header.effects = std::move(effects);
    header.more_hands = {{5.0, 0.3, std::move(effects_of_second)}};
    list_traits(first.traits(), header.facts);
    return header;
}

/// To the bit.
inline bool same(const RecordSample& a, const RecordSample& b) {
    const auto same_bits = [](double x, double y) {
        return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    };
    for (int i = 0; i < 3; ++i) {
        if (!same_bits(a.applied_W.force[i], b.applied_W.force[i]) ||
            !same_bits(a.commanded_W.force[i], b.commanded_W.force[i]) ||
            !same_bits(a.twist_W.linear[i], b.twist_W.linear[i])) {
            return false;
        }
    }
    return a.tick == b.tick && same_bits(a.time_s, b.time_s) && a.faults == b.faults &&
           a.gate == b.gate;
}

}  // namespace fulcrum::runtime::test
