// The motion of a god-object's tool: a step of its mesh towards where the handle would have it, as far as the contacts allow (god_object_tool.h
// tells how), and the set of contacts that holds it there. In rounds:
//
//   which way the contacts allow                                   god_allowed, by the coefficients of god_slips
//   how far it may go until something touches; what is near there  god_pairs, a god_pair for each object
// and once at the end by what it is pressed where it got           god_presses
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

#include "haptics/tool/beside_task.h"
#include "haptics/tool/god_object/god_allowed.h"
#include "haptics/tool/god_object/god_contact_set.h"
#include "haptics/tool/god_object/god_object_plan.h"
#include "haptics/tool/god_object/god_pairs.h"
#include "haptics/tool/god_object/god_presses.h"
#include "haptics/tool/god_object/god_slips.h"

#include <array>
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
    [[nodiscard]] double reach_m() const noexcept { return pairs_.reach_m(); }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    // A round's way, of `way_m`, and how much of it is free.
    struct Way {
        Vector6 way{Vector6::Zero()};
        double way_m = 0.0;
        double share = 0.0;
    };
    void slide(const Pose& wanted_W, std::span<const MovingFrame> objects) noexcept;
    bool slide_once(const Pose& wanted_W, std::span<const MovingFrame> objects, bool recovers,
                    double& longest_m) noexcept;
    void find_free(Way& way, bool recovers) noexcept;
    void note_been() noexcept;
    [[nodiscard]] double find_none_m(bool recovers, double longest_m) const noexcept;
    [[nodiscard]] bool settle() noexcept;
    [[nodiscard]] bool comes_back(double gone_m) const noexcept;
    static constexpr int kMostHeld = 20;
    [[nodiscard]] bool is_told() const noexcept { return settled_ || unsettled_ >= kMostHeld; }

    GodObjectSettings settings_;
    GodChannels* channels_;
    std::optional<ThriftyWriter<GodContactSet>> told_;  // there, if so
    std::uint32_t n_placements_ = 0;
    GodPairs pairs_;
    GodSlips slips_;
    GodAllowed allowed_;
    GodPresses presses_;
    // Rounds of the last step (GodObjectStep).
    int rounds_ = 0;
    int unsettled_ = 0;
    bool settled_ = true;
    bool wedged_ = false;
    bool is_checked_ = false;  // without what was recalled
    // Where the tool was before the last of them, the newest first.
    std::array<Pose, 6> been_W_{};
    std::size_t n_been_ = 0;
};

}  // namespace fulcrum
