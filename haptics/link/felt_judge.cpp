#include "haptics/link/felt_judge.h"

#include <algorithm>
#include <array>

namespace fulcrum {
namespace {

constexpr double kRounding = 1.0e-9;

// `v`, no longer than `most`.
Vector3 cut(const Vector3& v, double most) noexcept {
    return v * std::min(1.0, most / std::max(v.norm(), 1e-300));
}

}  // namespace

FeltLimits felt_limits(const SafetySettings& gate) noexcept {
    const double gentle = std::min(1.0, gate.max_slew_N_per_s / SafetySettings{}.max_slew_N_per_s);
    return {.force_N = gate.max_force_N,
            .torque_Nm = gate.max_torque_Nm,
            .slew_N_per_s = gate.max_slew_N_per_s,
            .slew_Nm_per_s = gate.max_slew_N_per_s * gate.max_torque_Nm / gate.max_force_N,
            .transient_N = gentle * gate.max_transient_N,
            .transient_Ns = gentle * gate.transient_Ns,
            .transient_N2s = gentle * gentle * gate.transient_N2s};
}

FeltLimits least_of(const FeltLimits& one, const FeltLimits& other) noexcept {
    return {.force_N = std::min(one.force_N, other.force_N),
            .torque_Nm = std::min(one.torque_Nm, other.torque_Nm),
            .slew_N_per_s = std::min(one.slew_N_per_s, other.slew_N_per_s),
            .slew_Nm_per_s = std::min(one.slew_Nm_per_s, other.slew_Nm_per_s),
            .transient_N = std::min(one.transient_N, other.transient_N),
            .transient_Ns = std::min(one.transient_Ns, other.transient_Ns),
            .transient_N2s = std::min(one.transient_N2s, other.transient_N2s)};
}

FeltLimit FeltJudge::judge(const FeltLimits& limits, const FeltRound& round) noexcept {
    const Vector3& felt_N = round.felt.force;
    const double reach_N = limits.slew_N_per_s * round.dt_s;
    const double step_N = (felt_N - felt_before_.force).norm();
    const double step_Nm = (round.felt.torque - felt_before_.torque).norm();
    const double ended_N = (felt_before_.force - lasting_N_).norm();
    const bool is_open = round.gate == GatePhase::open;
    // What lasts of it, and what is beyond.
    lasting_N_ =
        is_open ? lasting_N_ + cut(cut(round.asked.force, limits.force_N) - lasting_N_, reach_N)
                : felt_N;
    const Vector3 beyond_N = felt_N - lasting_N_;
    // What was felt before was held until now.
    const double more_s = round.dt_s - counted_s_;
    const double kept_s = std::min(round.dt_s, kLongestStep_s);
    impulse_Ns_ = (impulse_Ns_ + beyond_before_N_ * more_s) * (1.0 - kept_s / kImpulseMemory_s);
    ringing_N2s_ = (ringing_N2s_ + beyond_before_N_.squaredNorm() * more_s) *
                   (1.0 - kept_s / kRingingMemory_s);
    // A round that came late, or a slew that became less, may have left them beyond: not further then.
    const double most_Ns = std::max(limits.transient_Ns, impulse_Ns_.norm());
    const double most_N2s = std::max(limits.transient_N2s, ringing_N2s_);
    impulse_Ns_ += beyond_N * round.dt_s;
    ringing_N2s_ += beyond_N.squaredNorm() * round.dt_s;
    counted_s_ = round.dt_s;
    beyond_before_N_ = beyond_N;
    felt_before_ = round.felt;

    struct Rule {
        FeltLimit limit;
        double value, most;
    };
    const std::array rules{
        Rule{FeltLimit::force, felt_N.norm(), limits.force_N},
        Rule{FeltLimit::torque, round.felt.torque.norm(), limits.torque_Nm},
        Rule{FeltLimit::slew, step_N, reach_N + (is_open ? 2.0 * limits.transient_N : ended_N)},
        Rule{FeltLimit::torque_slew, step_Nm, limits.slew_Nm_per_s * round.dt_s},
        Rule{FeltLimit::transient, beyond_N.norm(), limits.transient_N},
        Rule{FeltLimit::impulse, impulse_Ns_.norm(), most_Ns},
        Rule{FeltLimit::ringing, ringing_N2s_, most_N2s}};
    // NaN is below nothing.
    const auto* broken = std::ranges::find_if_not(
        rules, [](const Rule& rule) { return rule.value <= rule.most + kRounding; });
    return broken == rules.end() ? FeltLimit::none : broken->limit;
}

}  // namespace fulcrum
