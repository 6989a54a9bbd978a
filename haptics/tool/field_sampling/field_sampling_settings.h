// How a tool's points are sampled in a distance field (field_sampler.h): what is chosen at load.
#pragma once

#include "haptics/base/clock.h"
#include "haptics/base/error.h"
#include "haptics/tool/step_time.h"
#include "haptics/voxel/distance_field_batch.h"

#include <cstdint>

namespace fulcrum {

enum class SamplingMode : std::uint8_t { brute_force, tree, coherent };

/// Fixed at load.
struct FieldSamplingSettings {
    double stiffness_N_per_m = 100.0;  ///< k of one point, 0 to 1e6
    ForceAlong along = ForceAlong::slopes;
    SamplingMode mode = SamplingMode::coherent;
    double budget_us = 0.0;  ///< of a step, 0: as long as it takes; else 5 to 1e5, coherent only
    BudgetClock clock = BudgetClock::measured;
    double leaf_us = 0.3;    ///< what a leaf of points costs, until it is known; 0.01 to 10
    double group_us = 0.06;  ///< what a group of balls costs, likewise
    double (*now_s)() noexcept = &monotonic_now_s;  ///< what is measured by, where no StepTime is
};

/// Checks all fields.
[[nodiscard]] Expected<void> validate(const FieldSamplingSettings& settings);

}  // namespace fulcrum
