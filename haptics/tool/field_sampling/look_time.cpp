#include "haptics/tool/field_sampling/look_time.h"

#include <algorithm>

namespace fulcrum {

LookTime::LookTime(const FieldSamplingSettings& settings) noexcept
    : settings_(settings),
      leaf_us_(settings.leaf_us),
      group_us_(settings.group_us),
      slopes_us_(static_cast<double>(slopes_leaves()) * settings.leaf_us) {}

void LookTime::begin_step(StepTime* step_time, int n_near) noexcept {
    step_time_ = step_time;
    n_near_ = std::max(n_near, 1);
}

void LookTime::begin() noexcept {
    work_ = {};
    look_us_ = is_shared() ? step_time_->find_look_us(n_near_) : settings_.budget_us;
    began_s_ = has_budget() && !is_counted() ? settings_.now_s() : 0.0;
}

void LookTime::count(const LookWork& work) noexcept {
    if (step_time_ != nullptr) {
        step_time_->count(static_cast<std::int64_t>(kLeafPoints) * work.n_leaves,
                          is_counted() ? find_cost_us(work) : 0.0);
    }
}

void LookTime::end() noexcept {
    count(work_);
    if (has_budget() && !is_shared()) {
        learn_reserve();
    }
}

double LookTime::elapsed_us() const noexcept {
    return is_counted() ? find_cost_us(work_) : 1.0e6 * (settings_.now_s() - began_s_);
}

double LookTime::find_left_us() const noexcept {
    return std::max(share_ * look_us_ - reserve_us_ - held_us_ - elapsed_us(), 0.0);
}

std::size_t LookTime::find_room(double share) const noexcept {
    constexpr double kRounding = 1.0e-9;  // a leaf that fits exactly does
    return static_cast<std::size_t>(share * find_left_us() / leaf_us_ + kRounding);
}

std::size_t LookTime::find_room_to_open() const noexcept {
    return static_cast<std::size_t>(find_left_us() / (group_us_ + leaf_us_));
}

bool LookTime::has_time_to_open(std::size_t n_nodes) const noexcept {
    return static_cast<double>(n_nodes) * (group_us_ + leaf_us_) <= find_left_us();
}

std::size_t LookTime::find_slopes_stride(std::size_t n_touched) const noexcept {
    if (!has_budget()) {
        return 1;
    }
    const auto room =
        std::max<std::size_t>(static_cast<std::size_t>(find_left_us() / slopes_us_), 1);
    return std::max<std::size_t>((n_touched + room - 1) / room, 1);
}

double LookTime::find_lap_us(double before_us, double expected_us) noexcept {
    constexpr double kUnlikely = 10.0;
    const double lap_us = elapsed_us() - before_us;
    if (lap_us > look_us_ && lap_us > kUnlikely * expected_us) {
        // Something else had the processor. The step is late whatever it does: what it had planned is done all the same.
        began_s_ += 1.0e-6 * lap_us;
    }
    return lap_us;
}

void LookTime::end_groups(double before_us, std::size_t n) noexcept {
    learn(group_us_, find_lap_us(before_us, group_us_ * static_cast<double>(n)), n);
}

void LookTime::end_slopes(double before_us, std::size_t n) noexcept {
    learn(slopes_us_, find_lap_us(before_us, slopes_us_ * static_cast<double>(n)), n);
}

double LookTime::end_leaves(double before_us, std::size_t n) noexcept {
    return find_lap_us(before_us, leaf_us_ * static_cast<double>(n));
}

void LookTime::learn(double& cost_us, double took_us, std::size_t n) const noexcept {
    if (is_counted() || n == 0) {
        return;
    }
    // Quickly up, slowly down, and a part more: what is thought too cheap misses deadlines. One step that was interrupted tells
    // little, and so do few.
    constexpr double kMore = 1.25;
    constexpr double kMostAtOnce = 2.0;
    const double seen_us =
        std::min(kMore * took_us / static_cast<double>(n), kMostAtOnce * cost_us);
    const double tells = std::min(static_cast<double>(n) / static_cast<double>(kBlock), 1.0);
    const double share = tells * (seen_us > cost_us ? 0.2 : 0.1);
    cost_us = std::clamp(cost_us + share * (seen_us - cost_us), 0.01, 10.0);
}

// Up by what was too much at once, down slowly: a deadline that was missed once is not missed again by as much.
void LookTime::learn_reserve() noexcept {
    if (is_counted()) {
        return;
    }
    constexpr double kFirst = 0.05;  // of the budget, as all below
    constexpr double kMost = 0.25;
    constexpr double kUp = 0.01;
    constexpr double kDown = kUp / 2000.0;
    const double late_us = elapsed_us() - settings_.budget_us;
    // A step that lost the processor tells nothing of its own work.
    const double more_us =
        late_us > 0.0 ? std::min(late_us, kFirst * settings_.budget_us) + kUp * settings_.budget_us
                      : -kDown * settings_.budget_us;
    reserve_us_ = std::clamp(reserve_us_ + more_us, kFirst * settings_.budget_us,
                             kMost * settings_.budget_us);
}

}  // namespace fulcrum
