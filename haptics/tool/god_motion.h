// The motion of a god-object's tool: a step of its mesh towards where the handle would have it, as far as the contacts allow (god_object_tool.h
// tells how), and the set of contacts that holds it there.
//
// What is promised: after each step the tool's surface and each object's (as seen: where it stopped if it was wedged) do not cross, and neither
// did they on the way, if they did not when the tool was placed. That holds for meshes with holes, cracks, flipped or loose triangles too, for
// it is about triangles: no normal of a mesh is used. What lies in an open mesh's inside may have come through its hole. A tool so small that
// it fits through a crack goes through. Places beyond 2e4 m are none: no double tells there how near is near (god_force.h).
//
// Thread: that of the haptic steps, or one beside them that calls `run_once` (loop/beside_thread.h); `is_free` any, at any time. Cost: by rounds and what
// lies near, not by how fine the meshes are; no allocation after it was built.
// Source: M. Ortega, S. Redon, S. Coquillart 2007, A six degree-of-freedom god-object method for haptic display of rigid bodies with surface
// properties, IEEE TVCG 13(3), section 3; k_s = 0.5 as there. The gap at rest, and bounds by gaps and by the objects' motion, are ours.
#pragma once

#include "haptics/constraint/friction_constraint.h"
#include "haptics/constraint/least_constraint.h"
#include "haptics/tool/beside_task.h"
#include "haptics/tool/god_contact_set.h"
#include "haptics/tool/god_object_plan.h"
#include "haptics/tool/god_pair.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace fulcrum {

class GodMotion final : public BesideTask {
  public:
    /// Takes plans and settings that GodObjectTool::build accepted; `channels`, which outlive it, where it is to run beside, else null.
    GodMotion(const std::vector<GodObjectPlan>& plans, const GodObjectSettings& settings,
              GodChannels* channels);
    GodMotion(const GodMotion&) = delete;
    GodMotion& operator=(const GodMotion&) = delete;
    ~GodMotion() override;

    /// At rest, and nothing is known of what is near.
    void place(const Pose& tool_W) noexcept;
    /// A step. False, and the tool stands still, where it overlaps an object in the first one after it was placed. `asks_near`: whether something is near
    /// must be told even where no contact presses.
    bool move(const Pose& held_W, std::span<const MovingFrame> objects, bool asks_near) noexcept;
    /// Where it got, and what may press there; the stamp and the placements are the caller's. False, and what presses is left as it was told, where the
    /// step was not settled: on its way the tool may touch nothing. After kMostHeld such steps what there is is told.
    bool tell(GodContactSet& set) const noexcept;
    /// The newest goal's step; false where there is no new one.
    bool run_once() noexcept override;

    /// Whether a tool there touches nothing: farther apart than the gap at rest at least, twice that at most, and not inside what a closed mesh
    /// encloses.
    [[nodiscard]] bool is_free(const Pose& tool_W,
                               std::span<const MovingFrame> objects) const noexcept;
    [[nodiscard]] double reach_m() const noexcept { return reach_m_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    [[nodiscard]] bool is_apart(const Pose& tool_W,
                                std::span<const MovingFrame> objects) const noexcept;
    // Whether tool and objects are apart where the tool was placed.
    [[nodiscard]] bool begin(std::span<const MovingFrame> objects) noexcept;
    void slide(const Pose& wanted_W, std::span<const MovingFrame> objects) noexcept;
    bool slide_once(const Pose& wanted_W, std::span<const MovingFrame> objects, bool recovers,
                    double& longest_m) noexcept;
    // The allowed way nearest to the one that leads to `wanted_W`.
    [[nodiscard]] Vector6 find_allowed(const Pose& wanted_W) noexcept;
    // With contacts that are too near pushing the tool back, or only not letting it nearer.
    [[nodiscard]] const LeastConstraint& solve(const Vector6& wanted, bool pushes) noexcept;
    void add(std::size_t i, const GodContact& contact, bool pushes) noexcept;
    [[nodiscard]] bool acts(std::size_t k) const noexcept;
    void recall() noexcept;
    void forget_idle() noexcept;
    // How much of the way it, and the objects theirs, may go.
    [[nodiscard]] double find_free_share(const Vector6& way) noexcept;
    [[nodiscard]] Vector6 find_carried() const noexcept;
    void set_goals(std::span<const MovingFrame> objects) noexcept;
    [[nodiscard]] Pose find_object_W(std::size_t i, double share) const noexcept;
    void advance(const Vector6& way, double share) noexcept;
    [[nodiscard]] bool have_arrived() const noexcept;
    [[nodiscard]] bool is_held() const noexcept;
    void look_nearer() noexcept;
    void note_been() noexcept;
    [[nodiscard]] double find_none_m(bool recovers, double longest_m) const noexcept;
    bool settle() noexcept;
    [[nodiscard]] bool comes_back(double gone_m) noexcept;
    void collect() noexcept;
    void collect_within() noexcept;
    void look_farther(double way_m, double share, bool recovers) noexcept;
    // Told of a set (god_motion_told.cpp).
    static constexpr int kMostHeld = 20;
    [[nodiscard]] bool is_told() const noexcept {
        return step_.settled || step_.unsettled >= kMostHeld;
    }
    [[nodiscard]] bool may_press(const GodContact& contact) const noexcept;
    void tell_presses(GodContactSet& set) const noexcept;
    [[nodiscard]] bool find_near(bool asks_near) noexcept;
    [[nodiscard]] double find_friction(std::size_t i, const GodContact& contact) const noexcept;
    [[nodiscard]] Vector3 find_felt_normal_W(std::size_t i, const GodContact& contact,
                                             const Matrix3& R_WO) const noexcept;
    [[nodiscard]] double find_press_share(const GodContact& contact) const noexcept;
    void note_slips() noexcept;
    void forget_slips() noexcept;

    GodObjectSettings settings_;
    GodChannels* channels_;
    std::optional<ThriftyWriter<GodContactSet>> told_;  // there, if so
    std::vector<GodPair> pairs_;
    std::vector<Pose> objects_W_;
    std::vector<Pose> goals_W_;  // of this round
    // Where the tool was over an object before the last step and after it.
    struct Slip {
        Pose from_OT{}, to_OT{};
    };
    bool has_friction_;
    bool is_followed_;                         // slips are known
    std::vector<FrictionSettings> frictions_;  // of objects
    std::vector<Slip> slips_;
    struct Shading {
        std::shared_ptr<const GodShading> object, tool;
    };
    std::vector<Shading> shadings_;  // empty where nothing is shaded
    LeastConstraintSolver solver_;
    FrictionConstraintSolver dragging_;  // in its place, where there is friction
    Pose pose_W_{};
    double reach_m_ = 0.0;   // of the tool
    double within_m_ = 0.0;  // what is nearer is a contact
    std::uint32_t n_placements_ = 0;
    bool is_begun_ = false;
    bool is_near_ = false;
    bool is_cut_ = false;  // the way of this round, not by what touches
    GodObjectStep step_{};
    // What held the tool when something else stopped it: with both it goes along the groove between them. Of this step.
    struct Recalled {
        std::size_t object = 0;
        GodContact contact{};
        Vector3 on_tool_T{Vector3::Zero()};
    };
    static constexpr std::size_t kMostRecalled = 8;
    std::array<Recalled, kMostRecalled> recalled_{};
    std::size_t n_recalled_ = 0;
    bool is_checked_ = false;
    // Where the tool was before the last rounds of this step, the newest first.
    std::array<Pose, 6> been_W_{};
    std::size_t n_been_ = 0;
};

}  // namespace fulcrum
