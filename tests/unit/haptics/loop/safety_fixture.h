// What the tests of the gate share.
#pragma once

#include "haptics/loop/safety.h"
#include "tests/unit/haptics/loop/rounds.h"

#include <catch2/catch.hpp>

namespace fulcrum {

inline Wrench along_x(double force_N) {
    return {Vector3(force_N, 0, 0), Vector3::Zero()};
}

// So many calls alike; what the last one lets through.
inline Wrench pass(SafetyGate& gate, const Wrench& commanded, int n = 1,
                   Fault fault = Fault::none) {
    Wrench out{};
    for (int i = 0; i < n; ++i) {
        out = gate.pass(commanded, fault, kDt_s);
    }
    return out;
}

// A gate with the soft start behind it, holding `force_N` along x.
inline SafetyGate open_gate(const SafetySettings& settings, double force_N,
                            double period_s = kDt_s) {
    SafetyGate gate(settings, period_s);
    pass(gate, along_x(0.0), 3000);
    pass(gate, along_x(force_N), 3000);
    REQUIRE(gate.phase() == GatePhase::open);
    return gate;
}

}  // namespace fulcrum
