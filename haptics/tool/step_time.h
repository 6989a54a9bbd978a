// The time that one step of a tool may take for looking at its points, shared by all looks of its solver at all objects.
//
//   a look     at most a sixth of the time, divided among the objects that are near, and no more than is left
//   has_time   left >= 2 t, t the dearest look of this step so far: for one more with derivatives, and for that where the step ends
// So five looks always have their time, as many as an explicit integrator makes and what ends the step; Newton's method goes on
// while there is time, and then ends with the best it has found. The clock is the machine's, or a counted one, which is the same in
// each run. Without a budget there is always time, and no clock is asked.
//
// Thread: that of the step. Cost: 25 ns a question to the machine's clock.
#pragma once

#include "haptics/base/clock.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace fulcrum {

/// How a budget is told: by the machine's clock, or by what leaves and groups are taken to cost, which is the same in each run.
enum class BudgetClock : std::uint8_t { measured, counted };

class StepTime {
  public:
    static constexpr int kLooks = 6;  ///< that have their time in any case

    /// `budget_us` of each step; 0: as long as it takes.
    explicit StepTime(double budget_us = 0.0, BudgetClock clock = BudgetClock::measured) noexcept
        : budget_us_(budget_us), clock_(clock) {}

    /// A step begins, of so many looks as dear as can be.
    void begin(int n_looks = kLooks) noexcept {
        began_s_ = reads_clock() ? monotonic_now_s() : 0.0;
        n_planned_ = n_looks;
        counted_us_ = dearest_us_ = look_began_us_ = 0.0;
        n_points_ = n_looks_ = 0;
    }

    [[nodiscard]] bool has_end() const noexcept { return budget_us_ > 0.0; }
    [[nodiscard]] double elapsed_us() const noexcept {
        return reads_clock() ? 1.0e6 * (monotonic_now_s() - began_s_) : counted_us_;
    }
    /// 0 or more; without end where there is none.
    [[nodiscard]] double left_us() const noexcept {
        return has_end() ? std::max(budget_us_ - elapsed_us(), 0.0)
                         : std::numeric_limits<double>::infinity();
    }
    /// What a look that begins now may take at one of `n_near` objects.
    [[nodiscard]] double find_look_us(int n_near) const noexcept {
        return std::min(left_us(), budget_us_ / static_cast<double>(n_planned_ * n_near));
    }

    /// A look of the solver at all objects begins, and ends.
    void begin_look() noexcept { look_began_us_ = has_end() ? elapsed_us() : 0.0; }
    void end_look() noexcept {
        ++n_looks_;
        if (has_end()) {
            dearest_us_ = std::max(dearest_us_, elapsed_us() - look_began_us_);
        }
    }
    /// What was looked at, and what that is taken to cost on the counted clock.
    void count(std::int64_t n_points, double cost_us) noexcept {
        n_points_ += n_points;
        counted_us_ += cost_us;
    }

    /// Whether the solver may go on: for one look more, and the one that ends the step.
    [[nodiscard]] bool has_time() const noexcept { return has_time_for(2.0); }
    /// For so many looks as dear as the dearest so far.
    [[nodiscard]] bool has_time_for(double n_looks) const noexcept {
        return !has_end() || left_us() >= n_looks * dearest_us_;
    }

    /// Since it began.
    [[nodiscard]] std::int64_t n_points() const noexcept { return n_points_; }
    [[nodiscard]] std::int64_t n_looks() const noexcept { return n_looks_; }

  private:
    [[nodiscard]] bool reads_clock() const noexcept {
        return has_end() && clock_ == BudgetClock::measured;
    }

    double budget_us_;
    BudgetClock clock_;
    int n_planned_ = kLooks;
    double began_s_ = 0.0;
    double counted_us_ = 0.0;
    double look_began_us_ = 0.0;
    double dearest_us_ = 0.0;
    std::int64_t n_points_ = 0;
    std::int64_t n_looks_ = 0;
};

}  // namespace fulcrum
