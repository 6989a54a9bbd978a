// What the tests of the gate share.
#pragma once

#include "haptics/loop/safety.h"
#include "tests/unit/haptics/loop/rounds.h"

#include <catch2/catch.hpp>

namespace fulcrum {

inline Wrench along_x(double force_N) {
    return {Vector3(force_N, 0, 0), Vector3::Zero()};
}

// A gate with the soft start behind it, holding `force_N` along x.
inline SafetyGate open_gate(const SafetySettings& settings, double force_N) {
    SafetyGate gate(settings);
    for (int i = 0; i < 3000; ++i) {
        (void)gate.pass(along_x(0.0), Fault::none, kDt_s);
    }
    for (int i = 0; i < 3000; ++i) {
        (void)gate.pass(along_x(force_N), Fault::none, kDt_s);
    }
    REQUIRE(gate.phase() == GatePhase::open);
    return gate;
}

}  // namespace fulcrum
