// A god-object's tool and all the objects that it meets: where they are, what of them is in contact, and how far they get on a way before something
// touches. For god_motion.h.
//
// Time goes by in rounds. In each the tool has a way and every object a goal, towards where it is said to be, by a turn so short that what it pushes
// goes straight; `find_free_share` tells how much of both may be gone, `advance` goes it. Nothing comes nearer than a quarter of the gap there is, or of
// the gap at rest where that is less. In contact is what lies within four gaps at rest, or farther where the tool was stopped by what it did not know of.
//
// Thread: that of the motion; `is_free` any, at any time. Cost: by what lies near, not by how fine the meshes are; no allocation after it was built.
// Source: M. Ortega, S. Redon, S. Coquillart 2007, IEEE TVCG 13(3), section 3 (god_motion.h); bounds by gaps and by the objects' motion are ours.
#pragma once

#include "haptics/handover/messages.h"
#include "haptics/tool/god_object/god_object_plan.h"
#include "haptics/tool/god_object/god_pair.h"

#include <span>
#include <vector>

namespace fulcrum {

/// What is in contact, of all objects together.
struct GodFound {
    int contacts = 0;
    double least_gap_m = 0.0;  ///< infinite where nothing is near
    bool too_many = false;     ///< more than there is room for
};

class GodPairs {
  public:
    GodPairs(const std::vector<GodObjectPlan>& plans, const GodObjectSettings& settings);

    /// The tool is put here, and nothing is known of what is near.
    void place(const Pose& tool_W) noexcept;
    /// The objects are there, the first time after that. False, and nothing begins, where one is no place or overlaps the tool.
    bool begin(std::span<const MovingFrame> objects) noexcept;
    [[nodiscard]] bool is_begun() const noexcept { return is_begun_; }
    /// As GodMotion::is_free.
    [[nodiscard]] bool is_free(const Pose& tool_W,
                               std::span<const MovingFrame> objects) const noexcept;

    /// Where the objects may be at most at the end of this round.
    void set_goals(std::span<const MovingFrame> objects) noexcept;
    /// They stay where they are in this round.
    void wait() noexcept;
    [[nodiscard]] bool have_arrived() const noexcept;
    /// Whether they are where they are said to be.
    [[nodiscard]] bool are_at(std::span<const MovingFrame> objects) const noexcept;
    /// How much of the way it, and the objects theirs, may go: 0 to 1.
    [[nodiscard]] double find_free_share(const Vector6& way) noexcept;
    /// The last of those was cut short, not by what touches.
    [[nodiscard]] bool is_cut() const noexcept { return is_cut_; }
    /// The tool's way with the object that is nearest of those that move: seen from that one it stands still, and touches nothing on the way.
    [[nodiscard]] Vector6 find_carried() const noexcept;
    /// They go so much of their ways; what is in contact there is told after `look_on` alone.
    void advance(const Vector6& way, double share) noexcept;
    /// What is in contact after a round that got so much of a way of `way_m`; `recovers`: it was one that only makes room.
    void look_on(double way_m, double share, bool recovers) noexcept;
    /// No farther than at first: what was looked for far away may be what holds it.
    void look_nearer() noexcept;

    [[nodiscard]] const GodFound& found() const noexcept { return found_; }
    [[nodiscard]] std::span<const GodPair> all() const noexcept { return pairs_; }
    [[nodiscard]] std::size_t size() const noexcept { return pairs_.size(); }
    /// Whether some part of an object is within that of the tool.
    [[nodiscard]] bool has_within(double within_m) noexcept;
    [[nodiscard]] const Pose& tool_W() const noexcept { return tool_W_; }
    [[nodiscard]] const Pose& object_W(std::size_t i) const noexcept { return objects_W_[i]; }
    [[nodiscard]] const Pose& goal_W(std::size_t i) const noexcept { return goals_W_[i]; }
    [[nodiscard]] bool moves(std::size_t i) const noexcept {
        return !is_same(objects_W_[i], goals_W_[i]);
    }
    /// The tool over an object.
    [[nodiscard]] Pose seen_OT(std::size_t i) const noexcept {
        return objects_W_[i].inverse() * tool_W_;
    }
    /// From the tool's centre of mass.
    [[nodiscard]] double reach_m() const noexcept { return reach_m_; }
    /// With the meshes, beside itself.
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    [[nodiscard]] bool is_apart(const Pose& tool_W,
                                std::span<const MovingFrame> objects) const noexcept;
    [[nodiscard]] Pose find_object_W(std::size_t i, double share) const noexcept;
    void look_farther(double way_m, double share, bool recovers) noexcept;
    void collect() noexcept;
    void collect_within() noexcept;

    double gap_m_;
    double reach_m_;
    std::vector<GodPair> pairs_;
    Pose tool_W_{};
    std::vector<Pose> objects_W_;
    std::vector<Pose> goals_W_;  // of this round
    bool is_begun_ = false;
    bool is_cut_ = false;
    double within_m_ = 0.0;  // what is nearer is a contact
    GodFound found_{};
};

}  // namespace fulcrum
