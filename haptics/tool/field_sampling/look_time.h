// The time that one look at a pair may take, on the machine's clock or a counted one, and what things cost in it, which is learned.
//
//   left    share (look's time) - reserve - held back - elapsed
//   room    leaves that fit in so much of it: share left / (what a leaf costs)
// The look's time is the budget, or what the step that it is part of can spare (step_time.h). Costs go up quickly and down slowly. The
// reserve is a twentieth of the budget, and more after a look that was late. A look that lost the processor for longer than its time is
// late whatever it does: that does not count, and it does what it had planned.
//
// Thread: that of the step. Cost: 25 ns a question to the machine's clock.
#pragma once

#include "haptics/tool/field_sampling/field_sampling_settings.h"
#include "haptics/tool/field_sampling/field_touch.h"

#include <cstddef>

namespace fulcrum {

class LookTime {
  public:
    static constexpr std::size_t kBlock = 16;  ///< leaves between two looks at the clock

    /// Takes settings that `validate` accepted.
    explicit LookTime(const FieldSamplingSettings& settings) noexcept;

    /// Looks from now on are those of one step, at one of `n_near` objects; null: each has the budget. The time must live until then.
    void begin_step(StepTime* step_time, int n_near) noexcept;
    [[nodiscard]] bool is_in_step() const noexcept { return step_time_ != nullptr; }
    /// Whether looks share an end.
    [[nodiscard]] bool is_shared() const noexcept {
        return step_time_ != nullptr && step_time_->has_end();
    }
    [[nodiscard]] bool has_budget() const noexcept { return settings_.budget_us > 0.0; }

    /// Of a look.
    void begin() noexcept;
    void end() noexcept;
    /// What was looked at since it began; the counted clock goes by that.
    [[nodiscard]] LookWork& work() noexcept { return work_; }
    [[nodiscard]] const LookWork& work() const noexcept { return work_; }

    /// Of the time, until what runs now must end.
    void set_share(double share) noexcept { share_ = share; }
    /// Of it, what is kept for so many leaves that are to be taken later.
    void hold_for(std::size_t n_leaves) noexcept {
        held_us_ = leaf_us_ * static_cast<double>(n_leaves);
    }
    [[nodiscard]] double elapsed_us() const noexcept;
    [[nodiscard]] double find_left_us() const noexcept;
    /// Leaves that fit in a share of the time that is left.
    [[nodiscard]] std::size_t find_room(double share) const noexcept;
    /// Nodes that do, if each is opened and one leaf of it taken.
    [[nodiscard]] std::size_t find_room_to_open() const noexcept;
    /// Whether each of so many nodes could be opened, and one leaf of it taken.
    [[nodiscard]] bool has_time_to_open(std::size_t n_nodes) const noexcept;
    /// Leaves that touch for one whose derivatives fit in the time that is left.
    [[nodiscard]] std::size_t find_slopes_stride(std::size_t n_touched) const noexcept;

    /// What so many took since `before_us`, which is learned of groups and derivatives. Of leaves it is told, for several blocks of them
    /// tell it together.
    void end_groups(double before_us, std::size_t n) noexcept;
    void end_slopes(double before_us, std::size_t n) noexcept;
    [[nodiscard]] double end_leaves(double before_us, std::size_t n) noexcept;
    void learn_leaves(double took_us, std::size_t n) noexcept { learn(leaf_us_, took_us, n); }

    /// Adds it to what the step that looks are part of looked at; a look does so at its end.
    void count(const LookWork& work) noexcept;
    [[nodiscard]] bool has_time_to_sweep() const noexcept {
        return step_time_ == nullptr || step_time_->has_time_for(1.0);
    }

  private:
    // What work costs on the counted clock.
    [[nodiscard]] double find_cost_us(const LookWork& work) const noexcept {
        return static_cast<double>(work.n_leaves + slopes_leaves() * work.n_sloped) *
                   settings_.leaf_us +
               static_cast<double>(work.n_groups) * settings_.group_us;
    }
    [[nodiscard]] bool is_counted() const noexcept {
        return settings_.clock == BudgetClock::counted;
    }
    // Leaves that cost what one's derivatives do.
    [[nodiscard]] std::int64_t slopes_leaves() const noexcept {
        return settings_.along == ForceAlong::slopes ? 4 : 16;
    }
    // Time since `before_us`; where it was taken by something else, it counts no longer.
    [[nodiscard]] double find_lap_us(double before_us, double expected_us) noexcept;
    // What one of `n` things costs, from what they took.
    void learn(double& cost_us, double took_us, std::size_t n) const noexcept;
    void learn_reserve() noexcept;

    FieldSamplingSettings settings_;
    double leaf_us_, group_us_, slopes_us_;  // learned
    double reserve_us_ = 0.0;                // likewise, before the end
    StepTime* step_time_ = nullptr;
    int n_near_ = 1;
    // Of the look.
    LookWork work_;
    double began_s_ = 0.0;
    double look_us_ = 0.0;
    double share_ = 1.0;
    double held_us_ = 0.0;
};

}  // namespace fulcrum
