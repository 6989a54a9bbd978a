#include "haptics/loop/safety.h"

#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// Scaling to a limit and squaring round; what stays this much below it is under the limit by any rounding. No command may lie
// between, for the last check would silence it.
constexpr double kBelowLimit = 1.0 - 1.0e-12;
constexpr double kArrived = 1.0e-6;     // newtons and newton metres together
constexpr double kSoftEnd = 3.0;        // from two thirds of a bound on a transient becomes less
constexpr double kForgotten = 1.0e-40;  // (N s)^2 and N^2 s; what goes on to shrink becomes slow
constexpr double kLeastSlew_N_per_s = 10.0;
constexpr double kMostSlew_N_per_s = 5000.0;
constexpr double kShortestPeriod_s = 1.0 / kMostRate_Hz;
constexpr double kLongestPeriod_s = 1.0 / kLeastRate_Hz;

// `value` pulled into [low, high]; NaN becomes `strictest`.
double clamped(double value, double low, double high, double strictest) noexcept {
    return value >= low && value <= high ? value
           : value < low                 ? low
           : value > high                ? high
                                         : strictest;
}

SafetySettings clamped(const SafetySettings& asked) noexcept {
    SafetySettings s = asked;
    s.max_force_N = clamped(asked.max_force_N, 0.0, kHardForceCap_N, 0.0);
    s.max_torque_Nm = clamped(asked.max_torque_Nm, 0.0, kHardTorqueCap_Nm, 0.0);
    s.max_slew_N_per_s = clamped(asked.max_slew_N_per_s, 0.0, kMostSlew_N_per_s, 0.0);
    // Who wants slower changes wants smaller blows.
    const double share = std::min(s.max_slew_N_per_s / SafetySettings{}.max_slew_N_per_s, 1.0);
    s.max_transient_N = share * clamped(asked.max_transient_N, 0.0, kMostTransient_N, 0.0);
    s.transient_Ns = share * clamped(asked.transient_Ns, 0.0, 0.05, 0.0);
    s.transient_N2s = share * share * clamped(asked.transient_N2s, 0.0, 0.5, 0.0);
    s.engage_below_N = clamped(asked.engage_below_N, 0.0, 1.0, 0.0);
    s.engage_cycles = std::max(asked.engage_cycles, 1);
    s.rest_speed_m_per_s = clamped(asked.rest_speed_m_per_s, 0.0, 0.2, 0.0);
    s.rest_s = clamped(asked.rest_s, 0.2, 60.0, 60.0);
    s.soft_start_N_per_s = clamped(asked.soft_start_N_per_s, 0.0, 50.0, 0.0);
    s.soft_start_s = clamped(asked.soft_start_s, 0.0, 60.0, 60.0);
    s.fade_s = clamped(asked.fade_s, 0.0, 0.5, 0.0);
    return s;
}

// `v` shortened to `limit`, its direction kept. The norm of a finite v below kInsaneForce_N cannot
// overflow.
inline Vector3 shortened(const Vector3& v, double limit) noexcept {
    const double length = v.norm();
    return length > limit ? Vector3(v * (limit / length * kBelowLimit)) : v;
}

bool is_sane(const Wrench& wrench) noexcept {
    return wrench.force.cwiseAbs().maxCoeff() < kInsaneForce_N &&
           wrench.torque.cwiseAbs().maxCoeff() < kInsaneForce_N && is_finite(wrench);
}

// One step from `from` towards `target`: at most `reach` far, and growing by at most `growth`.
Vector3 approached(const Vector3& from, const Vector3& target, double reach,
                   double growth) noexcept {
    const Vector3 next = from + shortened(target - from, reach);
    return shortened(next, from.norm() + growth);
}

// The largest s of 0 to 1 with |from + s way| <= most; of a `from` beyond that no more than what leads back.
double find_share_within(const Vector3& from, const Vector3& way, double most) noexcept {
    const double a = way.squaredNorm();
    if (!(a > 0.0)) {
        return 1.0;
    }
    const double b = from.dot(way);
    const double c = std::max(most * most * kBelowLimit - from.squaredNorm(), 0.0);
    return (from + way).squaredNorm() > most * most * kBelowLimit
               ? std::clamp((std::sqrt(b * b + a * c) - b) / a, 0.0, 1.0)
               : 1.0;
}

// What `whole` has of `part`, in its own direction: none of what is against it, no more than all.
Vector3 find_part_along(const Vector3& whole, const Vector3& part) noexcept {
    const double square = whole.squaredNorm();
    return square > 0.0 ? Vector3(whole * std::clamp(part.dot(whole) / square, 0.0, 1.0)) : whole;
}

}  // namespace

Wrench compute_last_check(const Wrench& wrench, double max_force_N, double max_torque_Nm) noexcept {
    // Squaring would make a large limit of a negative one.
    const double force_N = std::max(std::min(kHardForceCap_N, max_force_N), 0.0);
    const double torque_Nm = std::max(std::min(kHardTorqueCap_Nm, max_torque_Nm), 0.0);
    const bool holds = wrench.force.squaredNorm() <= force_N * force_N &&
                       wrench.torque.squaredNorm() <= torque_Nm * torque_Nm;
    return holds ? wrench : Wrench{};
}

SafetyGate::SafetyGate(const SafetySettings& settings, double period_s) noexcept
    : asked_(settings),
      settings_(clamped(settings)),
      period_s_(clamped(period_s, kShortestPeriod_s, kLongestPeriod_s, kLongestPeriod_s)) {
    if (settings_.max_force_N > 0.0) {
        torque_per_force_m_ = settings_.max_torque_Nm / settings_.max_force_N;
    }
}

void SafetyGate::limit_slew(double max_slew_N_per_s) noexcept {
    SafetySettings slower = asked_;
    slower.max_slew_N_per_s = std::min(
        asked_.max_slew_N_per_s,
        clamped(max_slew_N_per_s, kLeastSlew_N_per_s, kMostSlew_N_per_s, kLeastSlew_N_per_s));
    settings_ = clamped(slower);
}

void SafetyGate::reset() noexcept {
    output_D_ = Wrench{};
    rest_counts_ = true;
    enter(GatePhase::waiting);
}

void SafetyGate::silence() noexcept {
    output_D_ = Wrench{};
    enter(phase_ == GatePhase::stopped ? GatePhase::stopped : GatePhase::waiting);
}

bool SafetyGate::is_fading() const noexcept {
    const bool fades = phase_ == GatePhase::fading || phase_ == GatePhase::stopped;
    return fades && (output_D_.force.squaredNorm() > 0.0 || output_D_.torque.squaredNorm() > 0.0);
}

void SafetyGate::enter(GatePhase phase) noexcept {
    phase_ = phase;
    calm_cycles_ = 0;
    rested_s_ = 0.0;
    rise_age_s_ = 0.0;
    fade_age_s_ = 0.0;
    fade_from_D_ = {find_part_along(output_D_.force, base_D_.force), output_D_.torque};
    base_D_ = fade_from_D_;
}

double SafetyGate::find_most_N(double dt_s) const noexcept {
    const double transient_N = stays_rising(dt_s) ? 0.0 : settings_.max_transient_N;
    return lets_through(dt_s)
               ? std::min(settings_.max_force_N,
                          compute_length(base_D_.force) + find_growth_N(dt_s) + transient_N)
               : 0.0;
}

double SafetyGate::find_most_Nm(double dt_s) const noexcept {
    return lets_through(dt_s)
               ? std::min(settings_.max_torque_Nm, compute_length(base_D_.torque) +
                                                       torque_per_force_m_ * find_growth_N(dt_s))
               : 0.0;
}

bool SafetyGate::stays_rising(double dt_s) const noexcept {
    return phase_ == GatePhase::rising &&
           (opened_at_rest_ || !has_come_ ||
            rise_age_s_ + std::min(dt_s, kLongestStep_s) <= settings_.soft_start_s);
}

double SafetyGate::find_growth_N(double dt_s) const noexcept {
    // As `follow` lets it grow.
    return std::min(dt_s, kLongestStep_s) *
           (stays_rising(dt_s) ? settings_.soft_start_N_per_s : settings_.max_slew_N_per_s);
}

Wrench SafetyGate::pass(const Wrench& commanded_D, Fault faults, double dt_s,
                        double hand_m_per_s) noexcept {
    // What cannot be trusted is a fault, and a time that cannot be trusted ends a fade at once.
    faults_ = faults;
    const bool time_is_good = dt_s >= 0.0 && std::isfinite(dt_s);
    if (!time_is_good || !is_sane(commanded_D)) {
        faults_ |= Fault::command_invalid;
    }
    const double fade_dt_s = time_is_good ? std::max(dt_s, period_s_) : settings_.fade_s;
    const double rise_dt_s = time_is_good ? std::min(dt_s, kLongestStep_s) : 0.0;

    Wrench limited{};
    if (!any(faults_)) {
        limited = {shortened(commanded_D.force, settings_.max_force_N * kBelowLimit),
                   shortened(commanded_D.torque, settings_.max_torque_Nm * kBelowLimit)};
    }
    judge(commanded_D, rise_dt_s, hand_m_per_s);
    if (time_is_good) {
        count_held(dt_s);
    }
    forget(rise_dt_s);
    switch (phase_) {
        case GatePhase::waiting:
            output_D_ = Wrench{};
            break;
        case GatePhase::rising:
        case GatePhase::open:
            follow(limited, rise_dt_s);
            break;
        case GatePhase::fading:
        case GatePhase::stopped:
            fade(fade_dt_s);
            break;
    }
    output_D_ = compute_last_check(output_D_, settings_.max_force_N, settings_.max_torque_Nm);
    return output_D_;
}

// Chooses the phase of this call.
void SafetyGate::judge(const Wrench& commanded, double dt_s, double hand_m_per_s) noexcept {
    rest_counts_ = rest_counts_ && !any(faults_ & kThrown);
    // An emergency stop wins over everything and stays; a fade under way goes on from where it is.
    if (any(faults_ & kStops) && phase_ != GatePhase::stopped) {
        if (phase_ == GatePhase::fading) {
            phase_ = GatePhase::stopped;
        } else {
            enter(GatePhase::stopped);
        }
    }
    if (phase_ == GatePhase::stopped || phase_ == GatePhase::fading) {
        return;
    }
    if (any(faults_)) {
        if (phase_ == GatePhase::waiting) {
            calm_cycles_ = 0;
            rested_s_ = 0.0;
        } else {
            enter(GatePhase::fading);
        }
        return;
    }
    if (phase_ == GatePhase::waiting) {
        if (may_rise(commanded, dt_s, hand_m_per_s)) {
            opened_at_rest_ = calm_cycles_ < settings_.engage_cycles;
            rest_counts_ = true;
            enter(GatePhase::rising);
        }
        return;
    }
    rise_age_s_ += dt_s;
    // It is open when the force has come, however long that takes.
    if (phase_ == GatePhase::rising && rise_age_s_ > settings_.soft_start_s && !opened_at_rest_ &&
        has_come_) {
        phase_ = GatePhase::open;
    }
}

// While it waits: has what is commanded been small for long enough, or the hand rested?
bool SafetyGate::may_rise(const Wrench& commanded, double dt_s, double hand_m_per_s) noexcept {
    // Of a device without torque none is felt, whatever is commanded.
    const bool calm = commanded.force.norm() < settings_.engage_below_N &&
                      (torque_per_force_m_ == 0.0 ||
                       commanded.torque.norm() < settings_.engage_below_N * torque_per_force_m_);
    calm_cycles_ = calm ? calm_cycles_ + 1 : 0;
    rested_s_ = hand_m_per_s < settings_.rest_speed_m_per_s ? rested_s_ + dt_s : 0.0;
    return calm_cycles_ >= settings_.engage_cycles ||
           (rest_counts_ && rested_s_ >= settings_.rest_s);
}

// rising and open: towards the limited command, no faster than the slew and soft-start laws allow.
void SafetyGate::follow(const Wrench& limited, double dt_s) noexcept {
    if (!(dt_s > 0.0)) {
        return;
    }
    const double reach_N = settings_.max_slew_N_per_s * dt_s;
    const double growth_N =
        phase_ == GatePhase::rising ? settings_.soft_start_N_per_s * dt_s : reach_N;
    base_D_.force = approached(base_D_.force, limited.force, reach_N, growth_N);
    base_D_.torque = approached(base_D_.torque, limited.torque, reach_N * torque_per_force_m_,
                                growth_N * torque_per_force_m_);
    output_D_ = base_D_;
    if (phase_ == GatePhase::open) {
        counted_s_ = std::max(dt_s, period_s_);
        transient_N_ = ring(limited.force - base_D_.force, counted_s_);
        output_D_.force += transient_N_;
    }
    const double left_N = (base_D_.force - limited.force).norm();
    const double left_Nm = (base_D_.torque - limited.torque).norm();
    opened_at_rest_ = opened_at_rest_ && left_N + left_Nm > kArrived;
    has_come_ = left_N <= settings_.engage_below_N &&
                left_Nm <= settings_.engage_below_N * torque_per_force_m_;
}

// The last t was held for `dt_s`, whatever it was thought to be.
void SafetyGate::count_held(double dt_s) noexcept {
    const double more_s = dt_s - counted_s_;
    impulse_Ns_ += transient_N_ * more_s;
    ringing_N2s_ = std::max(ringing_N2s_ + transient_N_.squaredNorm() * more_s, 0.0);
    transient_N_ = Vector3::Zero();
    counted_s_ = dt_s;
}

void SafetyGate::forget(double dt_s) noexcept {
    const Vector3 impulse_Ns = impulse_Ns_ * (1.0 - dt_s / kImpulseMemory_s);
    const double ringing_N2s = ringing_N2s_ * (1.0 - dt_s / kRingingMemory_s);
    // One that is no number stays so: then nothing passes.
    impulse_Ns_ = impulse_Ns.squaredNorm() <= kForgotten ? Vector3(Vector3::Zero()) : impulse_Ns;
    ringing_N2s_ = ringing_N2s <= kForgotten ? 0.0 : ringing_N2s;
}

// t, of what is commanded beyond b; I and Q count it as held for `dt_s` from now on.
Vector3 SafetyGate::ring(const Vector3& beyond_N, double dt_s) noexcept {
    if (!(settings_.transient_Ns > 0.0) || !(settings_.transient_N2s > 0.0)) {
        return Vector3::Zero();
    }
    Vector3 t_N = shortened(beyond_N, settings_.max_transient_N);
    // Less where a bound is near, so that it doesn't end at once; of the impulse's where it would grow.
    const double pushed =
        impulse_Ns_.dot(t_N) > 0.0 ? compute_length(impulse_Ns_) / settings_.transient_Ns : 0.0;
    const double rung = ringing_N2s_ / settings_.transient_N2s;
    t_N *= std::clamp(kSoftEnd * (1.0 - pushed), 0.0, 1.0) *
           std::clamp(kSoftEnd * (1.0 - rung), 0.0, 1.0);
    // And never beyond one.
    const double left_N2s = std::max(settings_.transient_N2s - ringing_N2s_, 0.0);
    if (const double square_N2s = t_N.squaredNorm() * dt_s; square_N2s > left_N2s) {
        t_N *= std::sqrt(left_N2s / square_N2s);
    }
    t_N *= find_share_within(impulse_Ns_, t_N * dt_s, settings_.transient_Ns);
    impulse_Ns_ += t_N * dt_s;
    ringing_N2s_ += t_N.squaredNorm() * dt_s;
    return t_N;
}

// fading and stopped: a straight line from the force at the fault to zero.
void SafetyGate::fade(double dt_s) noexcept {
    fade_age_s_ += dt_s;
    if (!(fade_age_s_ < settings_.fade_s)) {
        output_D_ = Wrench{};
        if (phase_ == GatePhase::fading) {
            enter(GatePhase::waiting);
        }
        return;
    }
    const double left = 1.0 - fade_age_s_ / settings_.fade_s;
    output_D_ = {fade_from_D_.force * left, fade_from_D_.torque * left};
}

}  // namespace fulcrum
