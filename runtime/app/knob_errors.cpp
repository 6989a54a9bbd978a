#include "runtime/app/knob_errors.h"

#include "haptics/math/rotation.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/taped_loops.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace fulcrum::runtime {
namespace {

// Differences of one quantity.
class Differences {
  public:
    void add(double value) {
        squares_ += value * value;
        all_.push_back(static_cast<float>(value));
        most_ = std::max(most_, value);
    }
    // Rms, 99 %, most.
    [[nodiscard]] std::array<double, 3> finish() {
        if (all_.empty()) {
            return {};
        }
        const auto n = static_cast<double>(all_.size());
        const auto at = all_.begin() + static_cast<std::ptrdiff_t>(0.99 * (n - 1.0));
        std::ranges::nth_element(all_, at);
        return {std::sqrt(squares_ / n), std::min(static_cast<double>(*at), most_), most_};
    }

  private:
    double squares_ = 0.0;
    double most_ = 0.0;
    std::vector<float> all_;
};

// Between two poses of a hand; where one of them follows no other, the first.
DeviceReading go_evenly(const DeviceReading& from, const DeviceReading& to, double share) {
    DeviceReading between = from;
    const Quaternion turn = to.pose_D.orientation * from.pose_D.orientation.conjugate();
    between.stamp_s += share * (to.stamp_s - from.stamp_s);
    between.pose_D.position += share * (to.pose_D.position - from.pose_D.position);
    between.pose_D.orientation = compute_exp(share * compute_log(turn)) * from.pose_D.orientation;
    return between;
}

// The run with one knob converged, beside the run.
class Reference {
  public:
    Reference(const Knob& knob, const RunTape& tape) : knob_(knob), tape_(tape) {}

    [[nodiscard]] Expected<void> build(const Plan& shipped, const std::vector<WorldCommand>& first,
                                       const PlanAnew& plan_anew) {
        Plan plan = shipped;
        if (knob_.change) {
            auto changed = plan_anew(knob_.change);
            if (!changed) {
                return tl::unexpected(changed.error());
            }
            plan = std::move(*changed);
        } else {
            knob_.converge(plan);
        }
        const std::size_t hand = knob_.hand;
        const HapticPlan& own = hand == 0 ? plan.haptic : plan.more_hands[hand - 1];
        part_s_ = 1.0 / shipped.haptic.rate_hz / knob_.n_parts;
        if (knob_.reach != KnobReach::all) {
            hand_ = std::make_unique<TapedHand>(own, tape_.hands()[hand], plan.rigid.has_value());
            return {};
        }
        return TapedLoops::create(plan, tape_.hands(), first)
            .map([&](std::unique_ptr<TapedLoops>&& loops) { loops_ = std::move(loops); });
    }

    // The round `k`, which `run` has just done.
    void step(const TapedLoops& run, std::size_t k) {
        if (loops_) {
            loops_->step(tape_);
            for (std::size_t i = 0; i < loops_->n_hands(); ++i) {
                compare(loops_->hand(i), run.hand(i));
            }
            return;
        }
        const TapedHand& beside = run.hand(knob_.hand);
        hand_->hear(beside);
        const double now_s = beside.loop().state().time_s;
        if (knob_.reach == KnobReach::answers) {
            answer(beside, k, now_s);
        }
        const TapedRound& round = tape_.round(k, knob_.hand);
        const bool is_last = k + 1 == tape_.n_rounds();
        const DeviceReading& next = (is_last ? round : tape_.round(k + 1, knob_.hand)).reading;
        for (int i = 0; i < knob_.n_parts; ++i) {
            const double share = static_cast<double>(i) / knob_.n_parts;
            hand_->step(round, i == 0 ? round.reading : go_evenly(round.reading, next, share),
                        now_s + i * part_s_);
            compare(*hand_, beside);
        }
    }

    void finish(KnobError& error) {
        error.force_N = force_N_.finish();
        error.torque_Nm = torque_Nm_.finish();
    }

  private:
    void compare(const TapedHand& converged, const TapedHand& run) {
        const Wrench& is_W = converged.loop().state().applied_W;
        const Wrench& was_W = run.loop().state().applied_W;
        force_N_.add((is_W.force - was_W.force).norm());
        torque_Nm_.add((is_W.torque - was_W.torque).norm());
    }
    // The command of the run's round, with what lies between its answer and the next one.
    void answer(const TapedHand& run, std::size_t k, double now_s) {
        ForceCommand command = run.channels().command.value();
        const LinearisedWrench before = command.linearised;
        const auto& frames = tape_.frames();
        while (next_ < frames.size() &&
               (frames[next_].round <= k ||
                frames[next_].command.linearised.stamp_s <= before.stamp_s)) {
            ++next_;
        }
        if (before.stamp_s < 0.0 || next_ == frames.size()) {
            return;
        }
        const LinearisedWrench& behind = frames[next_].command.linearised;
        const double share = (now_s - before.stamp_s) / (behind.stamp_s - before.stamp_s);
        command.linearised = blend_answers(before, behind, std::clamp(share, 0.0, 1.0), now_s);
        hand_->channels().command.publish(command);
    }

    const Knob& knob_;
    const RunTape& tape_;
    std::unique_ptr<TapedHand> hand_;
    std::unique_ptr<TapedLoops> loops_;
    double part_s_ = 0.0;
    std::size_t next_ = 0;  // frame
    Differences force_N_;
    Differences torque_Nm_;
};

// Whether the round came out as it did.
bool is_same(const TapedLoops& again, const RunTape& tape, std::size_t k) {
    for (std::size_t i = 0; i < again.n_hands(); ++i) {
        const Wrench& is_W = again.hand(i).loop().state().applied_W;
        const Wrench& was_W = tape.round(k, i).applied_W;
        if (is_W.force != was_W.force || is_W.torque != was_W.torque) {
            return false;
        }
    }
    return true;
}

std::vector<KnobError> name_errors(const RunTape& tape, const Plan& plan,
                                   const std::vector<Knob>& knobs) {
    std::vector<KnobError> errors;
    for (const Knob& knob : knobs) {
        const HapticPlan& own = knob.hand == 0 ? plan.haptic : plan.more_hands[knob.hand - 1];
        KnobError error{.stage = knob.stage,
                        .what = knob.what,
                        .against = knob.against,
                        .because = knob.because,
                        .turns = has_torques(own)};
        error.seconds = static_cast<double>(tape.n_rounds()) / plan.haptic.rate_hz;
        if (tape.n_rounds() == 0 && error.because.empty()) {
            error.because = "nothing was played";
        }
        errors.push_back(std::move(error));
    }
    return errors;
}

// By the number of their knob, where one can be built; where not, its error says why.
using References = std::map<std::size_t, std::unique_ptr<Reference>>;

References build_references(const RunTape& tape, const Plan& plan,
                            const std::vector<WorldCommand>& first, const std::vector<Knob>& knobs,
                            const PlanAnew& plan_anew, std::vector<KnobError>& errors) {
    References references;
    for (std::size_t i = 0; i < knobs.size(); ++i) {
        if (!errors[i].because.empty()) {
            continue;
        }
        auto reference = std::make_unique<Reference>(knobs[i], tape);
        if (auto built = reference->build(plan, first, plan_anew); built) {
            references[i] = std::move(reference);
        } else {
            errors[i].because = to_sentence(built.error());
        }
    }
    return references;
}

}  // namespace

LinearisedWrench blend_answers(const LinearisedWrench& before, const LinearisedWrench& behind,
                               double share, double now_s) noexcept {
    const double left = 1.0 - share;
    const Wrench moved_W =
        compute_linearised_wrench(behind, before.at_position_W, before.at_velocity_W);
    // Each is off by half the bend times the square of the way to it; with the bend from the two slopes,
    //   (1 - s) s^2 + s (1 - s)^2 = s (1 - s)    of half of (K_behind - K_before) times the whole way.
    const double bend = 0.5 * share * left;
    const Vector3 way_m = behind.at_position_W - before.at_position_W;
    const Vector3 faster_m_per_s = behind.at_velocity_W - before.at_velocity_W;
    LinearisedWrench mixed = before;
    mixed.stamp_s = now_s;
    mixed.force_W = left * before.force_W + share * moved_W.force;
    mixed.force_W += bend * ((behind.stiffness_N_per_m - before.stiffness_N_per_m) * way_m);
    mixed.force_W += bend * ((behind.damping_Ns_per_m - before.damping_Ns_per_m) * faster_m_per_s);
    mixed.torque_W = left * before.torque_W + share * moved_W.torque;
    mixed.torque_W +=
        bend * ((behind.torque_stiffness_Nm_per_m - before.torque_stiffness_Nm_per_m) * way_m);
    mixed.stiffness_N_per_m = left * before.stiffness_N_per_m + share * behind.stiffness_N_per_m;
    mixed.damping_Ns_per_m = left * before.damping_Ns_per_m + share * behind.damping_Ns_per_m;
    mixed.torque_stiffness_Nm_per_m =
        left * before.torque_stiffness_Nm_per_m + share * behind.torque_stiffness_Nm_per_m;
    return mixed;
}

std::vector<KnobError> measure_knobs(const RunTape& tape, const Plan& plan,
                                     const std::vector<WorldCommand>& first,
                                     const std::vector<Knob>& knobs, const PlanAnew& plan_anew) {
    std::vector<KnobError> errors = name_errors(tape, plan, knobs);
    const References references = build_references(tape, plan, first, knobs, plan_anew, errors);
    auto again = TapedLoops::create(plan, tape.hands(), first);
    std::size_t n_different = again ? 0 : tape.n_rounds();
    for (std::size_t k = 0; again && k < tape.n_rounds() && !interrupted(); ++k) {
        (*again)->step(tape);
        n_different += is_same(**again, tape, k) ? 0 : 1;
        for (const auto& [i, reference] : references) {
            reference->step(**again, k);
        }
    }
    for (const auto& [i, reference] : references) {
        if (n_different > 0) {
            errors[i].because = "the run could not be repeated: " + std::to_string(n_different) +
                                " of its rounds differ";
        } else {
            reference->finish(errors[i]);
        }
    }
    return errors;
}

}  // namespace fulcrum::runtime
