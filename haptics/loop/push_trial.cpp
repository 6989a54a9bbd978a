#include "haptics/loop/push_trial.h"

#include "haptics/base/range.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

double smoothstep(double x) {
    const double held = std::clamp(x, 0.0, 1.0);
    return held * held * (3.0 - 2.0 * held);
}

// Whether what is asked for now is felt.
bool is_ready(const HapticState& state) {
    return !any(state.faults) && (state.gate == GatePhase::rising || state.gate == GatePhase::open);
}

}  // namespace

Expected<void> validate(const PushSettings& settings) {
    const Range ranges[] = {
        {"force in newtons", settings.force_N, 0.1, kMostPush_N},
        {"ramp in seconds", settings.ramp_s, 0.2, 2.0},
        {"hold in seconds", settings.hold_s, 0.3, 3.0},
        {"rest in seconds", settings.settle_s, 0.3, 3.0},
    };
    return check_ranges("the push's", ranges);
}

PushTrial::PushTrial(const PushSettings& settings, const Vector3& way_W)
    : settings_(settings), way_W_(way_W) {}

void PushTrial::enter(Phase phase, double now_s) {
    phase_ = phase;
    entered_s_ = now_s;
}

// The hand was disturbed, by itself or by a fault; without force until it rests again.
void PushTrial::begin_anew(double now_s) {
    enter(Phase::settle, now_s);
    waited_from_s_ = now_s;
    before_ = {};
    during_ = {};
    if (++beginnings_ > kMostBeginnings) {
        end_ = PushEnd::disturbed;
    }
}

void PushTrial::look(Mean& mean, const HapticState& state, double left_s) {
    if (left_s <= kLook_s) {
        mean.sum += state.tool_pose_W.position;
        ++mean.n;
    }
}

Vector3 PushTrial::step(const HapticState& state, double now_s) {
    if (end_ != PushEnd::running || !std::isfinite(now_s) || (started_ && !(now_s > last_s_)) ||
        !is_finite(state.tool_pose_W.position)) {
        return Vector3::Zero();
    }
    if (!started_) {
        started_ = true;
        entered_s_ = waited_from_s_ = now_s;
    }
    last_s_ = now_s;
    if (phase_ == Phase::settle) {
        return settle(state, now_s);
    }
    if (!is_ready(state)) {
        begin_anew(now_s);
        return Vector3::Zero();
    }
    return push(state, now_s);
}

Vector3 PushTrial::settle(const HapticState& state, double now_s) {
    if (!is_ready(state)) {
        enter(Phase::settle, now_s);
        before_ = {};
    }
    if (now_s - waited_from_s_ > kLongestWait_s) {
        end_ = PushEnd::disturbed;
    }
    const double left_s = settings_.settle_s - (now_s - entered_s_);
    look(before_, state, left_s);
    if (left_s <= 0.0) {
        enter(Phase::rise, now_s);
    }
    return Vector3::Zero();
}

Vector3 PushTrial::push(const HapticState& state, double now_s) {
    // Where has it gone to?
    const Vector3 way_W = state.tool_pose_W.position - before_.sum / before_.n;
    if (phase_ != Phase::fall && !(way_W.dot(way_W_) >= -kMostBack_m)) {
        end_ = PushEnd::ran_against;
        return Vector3::Zero();
    }
    if (!(way_W.norm() <= kMostWay_m)) {
        end_ = PushEnd::ran_away;
        return Vector3::Zero();
    }
    // What is its share of the force now?
    const double age_s = now_s - entered_s_;
    double share = 1.0;
    switch (phase_) {
        case Phase::settle:
            break;
        case Phase::rise:
            share = smoothstep(age_s / settings_.ramp_s);
            if (age_s >= settings_.ramp_s) {
                enter(Phase::hold, now_s);
            }
            break;
        case Phase::hold:
            look(during_, state, settings_.hold_s - age_s);
            if (age_s >= settings_.hold_s) {
                enter(Phase::fall, now_s);
            }
            break;
        case Phase::fall:
            share = 1.0 - smoothstep(age_s / settings_.ramp_s);
            if (age_s >= settings_.ramp_s) {
                motion_W_ = during_.sum / during_.n - before_.sum / before_.n;
                end_ = PushEnd::done;
            }
            break;
    }
    return settings_.force_N * share * way_W_;
}

PushVerdict judge_pushes(const Vector3& way_W, const Vector3& plus_W, const Vector3& minus_W) {
    const Vector3 motion_W = 0.5 * (plus_W - minus_W);
    const double along_m = motion_W.dot(way_W);
    const double across_m = (motion_W - along_m * way_W).norm();
    if (!motion_W.allFinite() || motion_W.norm() < kLeastMotion_m) {
        return PushVerdict::unfelt;
    }
    if (across_m > kMostAside * std::abs(along_m)) {
        return PushVerdict::aside;
    }
    return along_m < 0.0 ? PushVerdict::against : PushVerdict::with;
}

}  // namespace fulcrum
