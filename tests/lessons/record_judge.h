// Judges what a hand was given by the record of its run, as `soak` judges what an arm is given.
#pragma once

#include "haptics/device/replay/recorded_traits.h"
#include "haptics/link/felt_judge.h"
#include "haptics/link/spoiled_arm.h"
#include "haptics/math/felt.h"
#include "tests/lessons/program.h"

#include <cstdlib>

namespace fulcrum::test {

inline double number_of(const Record& record, std::string_view name) {
    const auto found = find_fact(record.header, name);
    REQUIRE(found);
    return std::strtod(std::string(*found).c_str(), nullptr);
}

/// The limits that stand in the record: that its gate has the least of those of lesson, site and device is no lesson's to say.
inline FeltLimits limits_in(const Record& record) {
    SafetySettings gate;
    gate.max_force_N = number_of(record, "limit.plan N");
    gate.max_torque_Nm = number_of(record, "limit.plan Nm");
    gate.max_slew_N_per_s = number_of(record, "limit.slew N/s");
    gate.max_transient_N = number_of(record, "limit.transient N");
    gate.transient_Ns = number_of(record, "limit.transient N s");
    gate.transient_N2s = number_of(record, "limit.transient N2 s");
    return felt_limits(gate);
}

inline bool is_gone(const Wrench& wrench) {
    constexpr double kGone_N = 1.0e-9;
    constexpr double kGone_Nm = 1.0e-9;
    return wrench.force.norm() <= kGone_N && wrench.torque.norm() <= kGone_Nm;
}

/// Empty where each round keeps all limits, no force is there before the gate opens, and one that must fade is gone in time.
inline std::string find_trouble(const Record& record) {
    const FeltLimits limits = limits_in(record);
    constexpr double kRound_s = 0.001;
    FeltJudge judge;
    const RecordSample* before = nullptr;
    double shut_s = 0.0;  // since when nothing may be felt but what fades
    for (const RecordSample& sample : record.samples) {
        const std::string at = " at " + std::to_string(sample.time_s) + " s";
        const double dt_s = before == nullptr ? kRound_s : sample.time_s - before->time_s;
        if (const FeltLimit broken =
                judge.judge(limits, {sample.commanded_W, sample.applied_W, sample.gate, dt_s});
            broken != FeltLimit::none) {
            return name_of(broken) + at;
        }
        const bool is_shut = sample.gate != GatePhase::rising && sample.gate != GatePhase::open;
        shut_s = is_shut ? shut_s : sample.time_s;
        if (sample.time_s - shut_s > SpoiledArm::kMostFade_s && !is_gone(sample.applied_W)) {
            return "a force that had to be gone" + at;
        }
        before = &sample;
    }
    const bool failed = std::ranges::any_of(record.events, [](const RecordEvent& event) {
        return event.kind == RecordEventKind::failed;
    });
    const bool is_left = failed && before != nullptr && !is_gone(before->applied_W);
    return is_left ? "a force is left after a lesson that failed" : "";
}

}  // namespace fulcrum::test
