#include "runtime/app/stage_clock.h"

#include "haptics/base/clock.h"
#include "runtime/app/tool_lacks.h"
#include "runtime/effect/tool/check_tool.h"
#include "runtime/scene/plan_hands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace fulcrum::runtime {
namespace {

// The least of many: what two looks at the clock are apart when nothing lies between them.
double measure_clock_us() {
    double least_s = 1.0;
    for (int i = 0; i < 2000; ++i) {
        const double before_s = monotonic_now_s();
        least_s = std::min(least_s, monotonic_now_s() - before_s);
    }
    return 1e6 * least_s;
}

double quantile(std::vector<float>& sorted, double share) {
    return sorted.empty()
               ? 0.0
               : sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

}  // namespace

void StageClock::Sum::add(double value) noexcept {
    squares += value * value;
    ++count;
}

double StageClock::Sum::rms() const noexcept {
    return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0.0;
}

StageClock::StageClock(const Plan& plan)
    : plan_(plan),
      clock_us_(measure_clock_us()),
      calls_(plan.stages.size()),
      haptic_stages_(kHapticStages * (1 + plan.more_hands.size())),
      world_stage_(find("world", {})),
      contact_stage_(find("contact", {})),
      lesson_stage_(find("lesson", {})),
      tool_time_us_(find_tool_time_us(plan.haptic.rate_hz)) {
    for (std::size_t i = 0; i < haptic_stages_.size(); ++i) {
        haptic_stages_[i] = find(name_of_loop(i / kHapticStages),
                                 name_of(static_cast<HapticStage>(i % kHapticStages)));
    }
}

std::size_t StageClock::find(std::string_view loop, std::string_view name) const noexcept {
    const auto& stages = plan_.stages;
    const auto found = std::ranges::find_if(stages, [&](const PlanStage& stage) {
        return stage.loop == loop && (name.empty() || stage.name == name);
    });
    return found == stages.end() ? kNoStage : static_cast<std::size_t>(found - stages.begin());
}

void StageClock::begin() noexcept {
    began_s_ = monotonic_now_s();
}

void StageClock::passed(HapticStage stage) noexcept {
    const double ended_s = monotonic_now_s();
    count(haptic_stages_[hand_ * kHapticStages + static_cast<std::size_t>(stage)], ended_s);
}

void StageClock::begins_round() noexcept {
    round_began_s_ = monotonic_now_s();
}

void StageClock::ended_round() noexcept {
    const double ended_s = monotonic_now_s();
    if (contact_stage_ != kNoStage) {
        keep(contact_stage_, std::max(1e6 * (ended_s - round_began_s_) - clock_us_, 0.0));
    }
    // The stage in which it lies began so much later.
    began_s_ += monotonic_now_s() - round_began_s_;
}

void StageClock::passed_effect(std::string_view loop, const WorldEffort& effort) noexcept {
    const double ended_s = monotonic_now_s();
    count(find(loop, {}), ended_s);
    world_ = effort;
}

void StageClock::passed_lesson() noexcept {
    const double ended_s = monotonic_now_s();
    count(lesson_stage_, ended_s);
}

void StageClock::count(std::size_t stage, double ended_s) noexcept {
    const double took_us = std::max(1e6 * (ended_s - began_s_) - clock_us_, 0.0);
    if (stage != kNoStage) {
        const bool is_tool = stage == haptic_stages_[static_cast<std::size_t>(HapticStage::tool)];
        n_longer_ += is_tool && took_us > tool_time_us_ ? 1 : 0;
        keep(stage, took_us);
    }
    // What was done here is no stage's.
    began_s_ = monotonic_now_s();
}

void StageClock::keep(std::size_t stage, double took_us) noexcept {
    Calls& calls = calls_[stage];
    calls.total_us += took_us;
    if (calls.count++ % calls.every == 0) {
        calls.us.push_back(static_cast<float>(took_us));
    }
    if (calls.us.size() == kMostCalls) {
        for (std::size_t i = 0; i < kMostCalls / 2; ++i) {
            calls.us[i] = calls.us[2 * i];
        }
        calls.us.resize(kMostCalls / 2);
        calls.every *= 2;
    }
}

void StageClock::compare(const HapticState& state,
                         const std::optional<Vector3>& true_velocity_W) noexcept {
    if (true_velocity_W) {
        velocity_error_m_per_s_.add((state.tool_twist_W.linear - *true_velocity_W).norm());
    }
    const Vector3& place_W = state.tool_pose_W.position;
    hand_moved_ = hand_moved_ || place_W != first_place_W_.value_or(place_W);
    first_place_W_ = first_place_W_.value_or(place_W);
    withheld_N_.add((state.commanded_W.force - state.applied_W.force).norm());
    felt_time_.add(state, 1.0 / plan_.haptic.rate_hz);
    force_energy_ = state.force_energy;
    torque_energy_ = state.torque_energy;
    most_points_ = std::max(most_points_, state.tool.n_points);
    most_looks_ = std::max(most_looks_, state.tool.n_looks);
    tool_ = state.tool;
}

void StageClock::add_tool_errors(StageFigures& figures) const {
    if (tool_.n_inexact > 0) {
        figures.errors.push_back({"left out by the budget at most", tool_.most_error_N, "N",
                                  "all points looked at that may touch"});
    }
    for (std::size_t i = 0; i < kToolLacks; ++i) {
        if (tool_.n_lacking[i] > 0) {
            figures.errors.push_back({std::string("steps that ") + kToolLackWords[i],
                                      static_cast<double>(tool_.n_lacking[i]),
                                      "of them",
                                      {}});
        }
    }
    figures.errors.push_back({"points looked at in a step at most",
                              1e-3 * static_cast<double>(most_points_),
                              "thousand",
                              {}});
    figures.errors.push_back(
        {"looks in a step at most", static_cast<double>(most_looks_), "of its solver", {}});
    figures.errors.push_back(
        {"steps longer than a live run gives it",
         100.0 * static_cast<double>(n_longer_) / static_cast<double>(figures.calls), "%",
         std::to_string(std::lround(tool_time_us_)) + " us"});
}

// By the rounds that were made here; a live run tells how it was (live_loops.h).
void StageClock::add_contact_errors(StageFigures& figures) const {
    const double looks_Hz = plan_.stages[contact_stage_].rate_hz;
    const double step_ms = 1e3 / plan_.haptic.rate_hz;
    const double rate_Hz =
        std::min({plan_.haptic.rate_hz, looks_Hz, 1e6 / std::max(figures.p99_us, 1.0)});
    // A place is told in a step, looked for within half of one, and the answer is taken in the step after it came.
    const double age_ms = step_ms * std::ceil((1e3 / looks_Hz + 1e-3 * figures.p99_us) / step_ms);
    figures.errors.push_back(
        {"rounds a second on a thread, 99 % of them", rate_Hz, "Hz", "as many as steps at most"});
    figures.errors.push_back(
        {"age of contact in a step then, 99 %", age_ms, "ms", "here each step finds its own"});
}

void StageClock::add_errors(StageFigures& figures) const {
    const auto is = [&](HapticStage stage) {
        return haptic_stages_[static_cast<std::size_t>(stage)] == figures.stage;
    };
    if (is(HapticStage::estimate) && velocity_error_m_per_s_.count > 0) {
        figures.errors.push_back({"velocity, rms", 1e3 * velocity_error_m_per_s_.rms(), "mm/s",
                                  "the simulated hand's own"});
    }
    if (is(HapticStage::tool)) {
        add_tool_errors(figures);
    }
    if (figures.stage == world_stage_ && world_.n_steps > 0) {
        figures.errors.push_back({"steps that were not within the solver's tolerance",
                                  static_cast<double>(world_.n_unconverged),
                                  "of them",
                                  {}});
    }
    if (figures.stage == contact_stage_) {
        add_contact_errors(figures);
    }
    if (is(HapticStage::passivity)) {
        const std::string ideal = "the scene felt without sampling";
        figures.errors.push_back(
            {"excess energy at most", 1e3 * force_energy_.peak_J, "mJ", ideal});
        figures.errors.push_back({"braked", 1e3 * force_energy_.braked_J, "mJ", {}});
        if (torque_energy_.peak_J != 0.0 || torque_energy_.braked_J != 0.0) {
            figures.errors.push_back(
                {"excess energy of turning at most", 1e3 * torque_energy_.peak_J, "mJ", ideal});
            figures.errors.push_back(
                {"braked of turning", 1e3 * torque_energy_.braked_J, "mJ", {}});
        }
    }
    if (is(HapticStage::limits)) {
        figures.errors.push_back(
            {"force kept back, rms", withheld_N_.rms(), "N", "what scene and brake asked for"});
        std::array<char, 64> asked{};
        std::snprintf(asked.data(), asked.size(), "%.1f s in which a force was asked for",
                      felt_time_.asked_s);
        figures.errors.push_back({"gate shut", felt_time_.shut_s(), "s", asked.data()});
    }
}

Analysis StageClock::finish(double simulated_s, double wall_s) const {
    Analysis analysis{simulated_s, wall_s, clock_us_, {}};
    for (std::size_t i = 0; i < calls_.size(); ++i) {
        if (calls_[i].count == 0) {
            continue;
        }
        std::vector<float> sorted = calls_[i].us;
        std::ranges::sort(sorted);
        StageFigures figures{
            i, calls_[i].count, quantile(sorted, 0.5), quantile(sorted, 0.99), calls_[i].total_us,
            {}};
        add_errors(figures);
        analysis.stages.push_back(std::move(figures));
    }
    return analysis;
}

}  // namespace fulcrum::runtime
