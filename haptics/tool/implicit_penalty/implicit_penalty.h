// A tool as Otaduy and Lin have it: a rigid body between the virtual coupling and viscoelastic contacts, stepped by backward Euler, while contacts are found beside it, as fast as that goes.
//
//   haptic thread    take the newest contact model -> planes (contact_planes.h) -> M a = coupling + contacts, backward Euler -> coupling felt
//   contact thread   take the newest place -> near contacts -> clusters -> contact model                          (contact_loop.h)
// The contact thread is a task of its own (`contact_loop`): a thread runs it beside the steps, or, with `own_rounds`, the tool itself within its
// steps. With a period it is as late as a thread would be: what is found at one round is told at the next. A thread that stalls is gone on
// without for a stated time, then less and less is felt (contact_age.h).
//
// The coupling saturates, so that no hand presses the tool deeper than the force that it can feel does. In free space, where no cluster is, the hand
// feels exactly nothing unless `silent_in_free_space` is off; then it feels the tool's mass, as the source's does. As clusters come and go within d
// that mass comes and goes over 5 ms.
// One linear solve a step, at the old pose, as the source has it. More, up to `newton_iterations`, follow a contact that opens and closes within
// the step: over a bumpy ball in a wandering hand the force then goes by 1.0 N in a millisecond at most instead of 1.9, at 1.9 solves a step.
// What a penalty method cannot promise: a tool that passes through a thin wall between two rounds of the contact thread is behind it.
//
// Thread: the haptic loop. Cost: 1.5 us and 0.1 us a cluster, besides rounds of its own; no allocation.
// Source: M. Otaduy, M. Lin 2005, Stable and responsive six-degree-of-freedom haptic manipulation using implicit integration, World
// Haptics, sections 3 to 6.
#pragma once

#include "haptics/dynamics/integrator.h"
#include "haptics/tool/contact_age.h"
#include "haptics/tool/implicit_penalty/contact_loop.h"
#include "haptics/tool/implicit_penalty/contact_taylor.h"
#include "haptics/tool/implicit_penalty/field_contacts.h"
#include "haptics/tool/implicit_penalty/level_contacts.h"
#include "haptics/tool/tool_solver.h"

#include <memory>
#include <vector>

namespace fulcrum {

/// Fixed at load.
struct ImplicitPenaltySettings {
    ToolCouplingSettings coupling{};
    bool critically_damped = true;  ///< sets the coupling's dampers by mass and moments
    Inertia inertia{};
    Vector3 grip_T{
        Vector3::Zero()};  ///< where the coupling holds it, metres from the centre of mass
    Quaternion handle_turn{
        Quaternion::Identity()};  ///< q_HT, unit: how the tool lies in the handle
    int newton_iterations = 1;    ///< 1 is the source's; 1 to 100
    bool silent_in_free_space = true;
    ContactPlanesSettings contacts{.damping_Ns_per_m = kCriticalDamping};
    ContactClusterSettings clusters{};  ///< found as far out as they push, at least
    int most_near = 2048;               ///< contacts an object at a time
    bool own_rounds = true;             ///< the tool runs the contact rounds within its steps
    double round_s =
        0.0;  ///< of its own: 0, each step, told at once; else 1e-4 to 1, told a round late
    double budget_us = 0.0;    ///< of a round, 0 to 1e6 (contact_loop.h); 0: as long as it takes
    ContactAgeSettings age{};  ///< of what a thread beside told; rounds of its own are never late
};

/// What one object is found by.
struct FieldContactsPlan {
    std::shared_ptr<const DistanceField> field;
    std::shared_ptr<const ShellTree>
        shell;  ///< about the tool's centre of mass, along its principal axes
};

struct ImplicitPenaltyPlan {
    std::vector<FieldContactsPlan> objects;
    ImplicitPenaltySettings settings{};
    std::vector<LevelContactsPlan> meshes{};  ///< objects too, after those in fields
};

/// Refuses settings outside their ranges, NaN included.
[[nodiscard]] Expected<void> validate(const ImplicitPenaltySettings& settings);

class ImplicitPenaltyTool final : public ToolSolver, public BesideSolver {
  public:
    /// Refuses what `validate` and the finders refuse, levels made for less than clusters look for, no object, and more than kMaxSolids.
    [[nodiscard]] static Expected<ImplicitPenaltyTool> build(const ImplicitPenaltyPlan& plan);
    ImplicitPenaltyTool(ImplicitPenaltyTool&&) noexcept = default;
    ImplicitPenaltyTool& operator=(ImplicitPenaltyTool&&) noexcept = default;
    ~ImplicitPenaltyTool() override;

    /// For the thread that runs it, where the tool does not; lives as long as the tool.
    [[nodiscard]] ContactLoop& contact_loop() const noexcept { return *loop_; }
    [[nodiscard]] const RigidState& state() const noexcept { return state_; }
    [[nodiscard]] const ImplicitPenaltySettings& settings() const noexcept { return settings_; }
    /// Taken last.
    [[nodiscard]] const ContactModel& model() const noexcept { return channels_->model.value(); }
    /// Of the last step, with `planes`.
    [[nodiscard]] std::span<const PlaneContact> planes() const noexcept { return planes_.planes(); }

    void place(const Pose& handle_W) noexcept override;
    [[nodiscard]] bool is_free(std::span<const MovingFrame> objects) const noexcept override;
    [[nodiscard]] ToolFelt move(const MovingFrame& handle, std::span<const MovingFrame> objects,
                                double now_s, double dt_s) noexcept override;
    [[nodiscard]] BesideTask* beside() noexcept override {
        return settings_.own_rounds ? nullptr : loop_.get();
    }
    [[nodiscard]] const ContactAge& contact_age() const noexcept override { return age_; }
    void listen_to_rounds(RoundListener* listener) noexcept override {
        loop_->listen(settings_.own_rounds ? listener : nullptr);
    }
    [[nodiscard]] Pose grip_W() const noexcept override;
    [[nodiscard]] const Vector3& centre_W() const noexcept override {
        return state_.pose_W.position;
    }
    [[nodiscard]] std::span<const ToolTouch> touches() const noexcept override { return touches_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept override;

  private:
    ImplicitPenaltyTool(const ImplicitPenaltySettings& settings,
                        std::unique_ptr<ContactChannels> channels,
                        std::unique_ptr<ContactLoop> loop,
                        std::unique_ptr<ContactChannels> no_channels,
                        std::unique_ptr<ContactLoop> asked);
    [[nodiscard]] Pose held_W() const noexcept;
    void tell_place(std::span<const MovingFrame> objects, double began_s, double dt_s) noexcept;
    void take_model(double began_s) noexcept;
    void note_age(double began_s, double dt_s) noexcept;
    [[nodiscard]] bool is_near() const noexcept;
    void note_near(double dt_s) noexcept;
    void tell_touches(std::span<const MovingFrame> objects) noexcept;
    [[nodiscard]] ToolFelt feel(const ToolCouplingLoad& coupling, const MovingFrame& handle,
                                double now_s) const noexcept;

    ImplicitPenaltySettings settings_;
    std::unique_ptr<ContactChannels> channels_;
    std::unique_ptr<ContactLoop> loop_;
    std::unique_ptr<ContactChannels> no_channels_;
    std::unique_ptr<ContactLoop>
        asked_;  // for is_free where the loop is its thread's; else null: the loop itself is asked
    std::vector<ToolTouch> touches_;
    ContactPlanes planes_;
    ContactTaylor taylor_;
    RigidState state_{};
    ToolPlace place_{};
    ContactAge age_;
    double round_due_s_ = 0.0;
    double near_share_ = 0.0;   // of the coupling, that is felt: 1 with clusters near
    double most_felt_N_ = 0.0;  // 0: as much as there is
    double most_felt_Nm_ = 0.0;
};

}  // namespace fulcrum
