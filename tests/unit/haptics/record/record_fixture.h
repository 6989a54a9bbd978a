// A record to write, read and damage.
#pragma once

#include "haptics/math/rotation.h"
#include "haptics/record/record.h"
#include "haptics/record/record_writer.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace fulcrum {

inline RecordSample make_sample(std::uint64_t tick) {
    const auto t = static_cast<double>(tick);
    RecordSample sample;
    sample.tick = tick;
    sample.time_s = 0.001 * t;
    sample.stamp_s = 0.001 * t - 0.0002;
    sample.pose_D = {Vector3(0.1 * std::sin(t), 0.2, -0.3),
                     compute_exp(Vector3(0.01 * t, 0.0, 0.2))};
    sample.twist_W = {Vector3(1, 2, 3), Vector3(4, 5, 6)};
    sample.commanded_W = {Vector3(0.5 * t, -8, 9), Vector3(10, 11, 12)};
    sample.applied_W = {Vector3(13, 14, 15), Vector3(16, 17, 18)};
    sample.buttons = 3;
    sample.faults = tick % 7 == 0 ? Fault::device_read | Fault::command_stale : Fault::none;
    sample.gate = static_cast<GatePhase>(tick % 5);
    return sample;
}

inline std::vector<std::byte> make_bytes(int n_samples, bool finish = true) {
    RecordEncoder encoder({1000.0, "gravity"});
    for (int i = 0; i < n_samples; ++i) {
        if (i % 100 == 50) {
            encoder.append(RecordEvent{0.001 * i, RecordEventKind::caught, 2, "apple"});
        }
        encoder.append(make_sample(static_cast<std::uint64_t>(i)));
    }
    if (finish) {
        encoder.finish();
    }
    return encoder.take_bytes();
}

}  // namespace fulcrum
