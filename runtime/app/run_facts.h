// What a run is made with, as the header of its record: program, lesson, files, device, workspace, limits, options, what the plan chose.
// Two runs of the same facts give the same forces under a virtual clock; where forces differ, the facts that differ say why.
//
// Thread: load path. Cost: reads every file of the lesson once, 4 ns a byte.
#pragma once

#include "haptics/device/device.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/record/record.h"
#include "runtime/app/places.h"
#include "runtime/app/run_request.h"
#include "runtime/scene/plan.h"

#include <filesystem>
#include <vector>

namespace fulcrum::runtime {

/// Everything that the facts are read from.
struct FactSources {
    const LessonDescription& lesson;
    const Plan& plan;
    const RunRequest& request;
    const Places& places;
    const std::vector<std::filesystem::path>& files;  ///< that the lesson was read from
    const HapticLoop& loop;
    const DeviceTraits& device;
    double device_force_limit_N;  ///< to which the plan was fitted
    struct Hand {
        const HapticLoop& loop;
        const DeviceTraits& device;
    };
    std::vector<Hand> more_hands{};
};

/// The header of the run's record.
[[nodiscard]] RecordHeader describe_run(const FactSources& run);

}  // namespace fulcrum::runtime
