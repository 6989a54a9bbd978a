// The stage of a tool in six degrees of freedom: it moves the tool (tool_solver.h) towards the hand among the plan's solids, and
// says what the hand feels and how each solid is pressed.
//
//   force on the hand    the coupling's, as the tool gives it
//   torque on the hand   about the grip, over the workspace's scale: forces are felt unscaled and lengths are not, so that a turn
//                        of the handle takes from the hand as much as from the tool, in the hand's metres
//   of both, reliefs     what the objects' materials add, where the tool feels it: ideal as far as their bumps' loan goes (energy_loan.h)
//   even normals         what they turn of the springs' part is lent likewise, by the hand's way against what is pressed hardest
//   force on a solid     -(W_i + w_i (felt - sum of W)),  w_i = |F_i| / sum of |F|    W_i its own wrench on the tool, F_i the force
//                        of it, all about the grip. Together they are what the hand presses, minus the force and torque that it
//                        feels: all of that where one solid is touched. Where the tool is twisted between two that push against
//                        each other, each has about its own. Given at the place on the line it acts along that is nearest to
//                        the grip, p = g + F x tau / F^2, and with the couple that is left, (tau . F) F / F^2
// A solid's velocity is the way between the last two places it was told to be at over the time between; one that is not told to
// move for longer than that stands still, and so does one that was put elsewhere at once.
//
// The tool follows the hand without a force until nothing is touched where the hand holds it: at the start, after a fault, a stop,
// a jump of the hand, when a solid was put elsewhere, and when the thread that finds contact has been silent for long (contact_age.h).
// So no force begins inside a solid.
//
// Thread: haptic loop. Cost: the tool's, and 20 ns a solid. No allocation in `step`.
// Source: the place of a wrench's line: R. S. Ball 1900, A Treatise on the Theory of Screws, chapter I (Poinsot's central axis).
#pragma once

#include "haptics/coupling/passivity.h"
#include "haptics/loop/contact_lateness.h"
#include "haptics/loop/haptic_plan.h"
#include "haptics/loop/solid_push.h"
#include "haptics/surface/energy_loan.h"
#include "haptics/tool/beside_task.h"
#include "haptics/tool/tool_solver.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace fulcrum {

/// What the stage is told in one round.
struct ToolRound {
    MovingFrame hand{};  ///< where the device is, in the world
    std::span<const Pose> solid_poses_W{};
    bool is_fit = true;  ///< no fault, no stop, no fade: forces may be given
    double now_s = 0.0;
    double dt_s = 0.0;
};

/// What it gives.
struct ToolForce {
    Wrench wrench_W{};   ///< on the hand: newtons, and newton metres as the hand feels them
    Wrench spring_W{};   ///< the springs' part of it
    Wrench texture_W{};  ///< what reliefs add to it
    ElasticForce elastic_force{};   ///< what of springs and reliefs gives the hand's work back
    ElasticForce elastic_torque{};  ///< likewise
    ContactSpring contact{};        ///< the force's; energy in metres of the world
    bool failed = false;            ///< something was no number; there is no force
};

class ToolStage {
  public:
    /// Takes a plan with a tool that `validate` accepted.
    explicit ToolStage(const HapticPlan& plan);
    ~ToolStage();

    [[nodiscard]] ToolForce step(const ToolRound& round) noexcept;
    /// The hand has jumped, or solids were put elsewhere, one a bit: nothing is felt until the tool is free.
    void let_go(std::uint32_t put = 0) noexcept;

    /// Of the last step, and so far.
    [[nodiscard]] const ToolEffort& effort() const noexcept { return effort_; }
    /// What a thread has to run beside the steps; null where they do all.
    [[nodiscard]] BesideTask* beside() const noexcept {
        return beside_ != nullptr ? beside_->beside() : nullptr;
    }
    void listen_to_rounds(RoundListener* listener) noexcept {
        if (beside_ != nullptr) {
            beside_->listen_to_rounds(listener);
        }
    }
    /// How old what it told was, of each step; null without such a thread.
    [[nodiscard]] const ContactLateness* lateness() const noexcept { return lateness_.get(); }
    /// Where the tool's handle is.
    [[nodiscard]] const Pose& pose_W() const noexcept { return pose_W_; }
    /// Index in the plan of the solid that is pressed hardest; kNoBody where none is.
    [[nodiscard]] std::int32_t solid() const noexcept { return solid_; }
    /// Of the last step, one a solid of the plan.
    [[nodiscard]] std::span<const SolidPush> pushes() const noexcept { return pushes_; }
    /// Whether some solid's relief is felt.
    [[nodiscard]] bool has_texture() const noexcept { return has_texture_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    struct Track {
        MovingFrame frame{};
        double told_s = 0.0;      // when it was last told to be elsewhere
        double interval_s = 0.0;  // between the last two such times
        bool is_known = false;
        Pose hand_B{};  // the hand as seen from it in the round before, where that is told
        bool tells_hand = false;
    };
    void follow_solids(const ToolRound& round) noexcept;
    void follow_hand(const ToolRound& round) noexcept;
    void tell_pushes(const Wrench& felt_W) noexcept;
    void add_up(const ToolEffort& step) noexcept;
    void count(const ToolFelt& felt, const ToolRound& round, ToolForce& force) noexcept;
    void forget_hand() noexcept;
    [[nodiscard]] WrenchLoan::Way find_way_against(const ToolRound& round) const noexcept;
    void add_lent(const WrenchLoan::Counted& lent, ToolForce& force) const noexcept;

    std::unique_ptr<ToolSolver> tool_;
    BesideSolver* beside_;  // the same, where it has work that can run beside; else null
    double scale_;
    bool has_texture_, has_shading_;
    std::vector<Track> tracks_;
    std::vector<MovingFrame> frames_;  // of the solids, for the tool
    std::vector<SolidPush> pushes_;
    WrenchLoan relief_loan_{};
    WrenchLoan even_loan_;
    Pose hand_W_{};  // in the round before
    bool is_engaged_ = false;
    ToolEffort effort_{};
    std::unique_ptr<ContactLateness> lateness_;
    Pose pose_W_{};
    std::int32_t solid_ = kNoBody;
};

/// Refuses what the tool's method does, and a tool that has not one map a solid.
[[nodiscard]] Expected<void> validate_tool(const HapticPlan& plan);

/// Null where the plan has no tool.
[[nodiscard]] std::unique_ptr<ToolStage> make_tool_stage(const HapticPlan& plan);

}  // namespace fulcrum
