// What a lesson's stages cost when it was played once, and how far they were from the truth where the truth is known.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// How wrong a stage was, against what its `against` names; or what it gave away or took.
struct StageError {
    std::string what;     ///< "velocity, rms"
    double value = 0.0;   ///< no number: nothing bounds it
    std::string unit;     ///< "mm/s"
    std::string against;  ///< "the simulated hand's own", for people
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
