// Times every stage of a run under a virtual clock, and compares with the truth where somebody knows it.
//
// A look at the clock costs some 25 ns: it is measured, and taken off each call. Calls are kept whole up to kMostCalls a
// stage, then every second one is dropped and only every second is kept from there on, so that a long run stays bounded.
//
// Thread: that of the virtual clock.
#pragma once

#include "haptics/handover/messages.h"
#include "haptics/loop/felt_time.h"
#include "haptics/loop/stage_listener.h"
#include "haptics/tool/beside_task.h"
#include "runtime/scene/analysis.h"
#include "runtime/scene/plan.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

class StageClock final : public StageListener, public RoundListener {
  public:
    static constexpr std::size_t kMostCalls = 200'000;

    explicit StageClock(const Plan& plan);

    /// Before a haptic round, a round of the world, a frame of the lesson.
    void begin() noexcept;
    /// A haptic stage has ended.
    void passed(HapticStage stage) noexcept override;
    /// What of the tool's stage could run beside it: it is the contact stage's, and not the tool's.
    void begins_round() noexcept override;
    void ended_round() noexcept override;
    /// The stages that end now are this hand's.
    void begins_hand(std::size_t hand) noexcept override { hand_ = hand; }
    /// What began last was a round of that effect's loop; it stands with the first of the loop's stages.
    void passed_effect(std::string_view loop, const WorldEffort& effort) noexcept;
    /// What began last was a frame of the lesson.
    void passed_lesson() noexcept;
    /// After a haptic round: what came of it, and how fast the hand really was, where that is known (world, m/s).
    void compare(const HapticState& state, const std::optional<Vector3>& true_velocity_W) noexcept;

    /// Whether the hand was ever anywhere else than at first.
    [[nodiscard]] bool hand_moved() const noexcept { return hand_moved_; }

    /// All figures; `simulated_s` and `wall_s` are the run's.
    [[nodiscard]] Analysis finish(double simulated_s, double wall_s) const;

  private:
    static constexpr std::size_t kNoStage = static_cast<std::size_t>(-1);

    struct Calls {
        std::uint64_t count = 0;
        double total_us = 0.0;
        std::uint64_t every = 1;
        std::vector<float> us;
    };
    struct Sum {
        double squares = 0.0;
        std::uint64_t count = 0;
        void add(double value) noexcept;
        [[nodiscard]] double rms() const noexcept;
    };

    void count(std::size_t stage, double ended_s) noexcept;
    void keep(std::size_t stage, double took_us) noexcept;
    [[nodiscard]] std::size_t find(std::string_view loop, std::string_view name) const noexcept;
    void add_errors(StageFigures& figures) const;
    void add_tool_errors(StageFigures& figures) const;
    void add_contact_errors(StageFigures& figures) const;

    const Plan& plan_;
    double clock_us_;
    double began_s_ = 0.0;
    double round_began_s_ = 0.0;
    std::vector<Calls> calls_;                // one a stage of the plan
    std::vector<std::size_t> haptic_stages_;  // place in the plan of each HapticStage, hand by hand
    std::size_t hand_ = 0;
    std::size_t world_stage_;
    std::size_t contact_stage_;
    std::size_t lesson_stage_;
    Sum velocity_error_m_per_s_;
    Sum withheld_N_;
    FeltTime felt_time_;
    WorldEffort world_{};
    std::optional<Vector3> first_place_W_;
    bool hand_moved_ = false;
    PortEnergy force_energy_{};
    PortEnergy torque_energy_{};
    // Of a tool.
    double tool_time_us_;  // that a live run gives it
    std::uint64_t n_longer_ = 0;
    std::int64_t most_points_ = 0;
    std::int64_t most_looks_ = 0;
    ToolEffort tool_{};
};

}  // namespace fulcrum::runtime
