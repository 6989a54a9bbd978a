// What a lesson's stages cost when it was played once, and how far they were from the truth where the truth is known.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// How wrong a stage was, against what its `against` names; or what it counted, gave away or took.
struct StageError {
    std::string what;  ///< "velocity, rms"
    double value = 0.0;
    std::string unit;     ///< "mm/s"
    std::string against;  ///< "the simulated hand's own", for people
};

/// What a knob of a stage leaves of error at the device: the run's own poses, once more with the knob converged, both through all stages
/// behind it up to the last gate.
struct KnobError {
    std::size_t stage = 0;  ///< by its place in Plan::stages
    std::string what{};     ///< "rounds of a second: 1000"
    std::string against{};  ///< how the reference was made; empty where there is none
    std::string because{};  ///< why there is none, or no figures; else empty
    double seconds = 0.0;   ///< of play that were compared
    // Of the difference that the device is sent, rms, 99 % and at most.
    std::array<double, 3> force_N{};
    std::array<double, 3> torque_Nm{};
    bool turns = false;  ///< the plan gives torques
};

/// One stage of the plan, by its place in Plan::stages.
struct StageFigures {
    std::size_t stage = 0;
    std::uint64_t calls = 0;
    double median_us = 0.0;
    double p99_us = 0.0;
    double total_us = 0.0;
    std::vector<StageError> errors;
};

struct Analysis {
    double simulated_s = 0.0;
    double wall_s = 0.0;
    double clock_us = 0.0;  ///< what one look at the clock costs; taken off each call
    /// Those stages that can be timed on their own, in the plan's order.
    std::vector<StageFigures> stages;
    /// Of each stage that has a knob, in the plan's order.
    std::vector<KnobError> knobs{};

    /// Microseconds of all stages together.
    [[nodiscard]] double total_us() const {
        double sum = 0.0;
        for (const StageFigures& figures : stages) {
            sum += figures.total_us;
        }
        return sum;
    }
};

}  // namespace fulcrum::runtime
