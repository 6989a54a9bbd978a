// A tool that never enters anything: the god-object in six degrees of freedom. Its mesh goes where the hand would have it as far as the contacts
// allow, slides on along them, and the hand feels what the contacts take of its way.
//
//   1  wanted     u = k_s (x_h - x_s), a shift and a rotation vector about the centre of mass
//   2  allowed    d = argmin 1/2 (d - u)^T M (d - u)   with   n_k . (d_G + d_theta x r_k) >= delta - g_k + n_k . d_object     (least_constraint.h)
//   3  gone       as far as continuous collision lets go along d: not nearer than a quarter of delta, and of what there was   (mesh_sweep.h)
//   4  again from 2 with what is left of u, until nothing moves, or by less than a fiftieth of what a round of the step has gone and all that
//      holds it presses, or it only comes back to where it was; what is left then is way that is free to go, so nothing of it is felt.
//      Stopped by what it did not know of it goes on along both, for what held it before is recalled
//      After `most_rounds` it is not settled, which is told: it goes on in the next step, and the last contacts that were settled are felt
//   5  felt       by the contacts there (god_force.h), in directions that turn evenly where a surface is shaded (god_shading.h), and
//                 the relief of what they lie on (god_texture.h)
// With friction, where an object has it, 2 is friction_constraint.h: contacts hold along themselves by up to mu of what they push, and slip against
// it beyond; by the static coefficient where the tool did not slip in the step before, by a thousandth of the gap at rest, else by the dynamic one.
// g_k is a contact's gap and delta the gap at which tools rest, a micrometre. Contacts within 4 delta are told, farther ones where the tool was
// stopped by what it did not know of: those that are farther than delta away let the tool go as far, those that are nearer push it back, where all can; so it rests at delta itself, however it came there.
// Objects that move go on their way during the same rounds, each pair of meshes on the in-between motion of one as seen from the other,
// and the tool before them; where a round so gets less than a tenth of its way, for that is bent, the tool is carried by the nearest of them, at rest on it.
// Between objects that close upon it the tool is wedged: then they are held where they touched, which is told, and catch up when there is room.
//
// What is felt of a tool that nothing is within 16 delta of is 0, to the bit, 10 ms later, however it came there and whatever `fade_s` is; beside a thread counted from the set that tells so. Lifted it
// comes off without a step of the force; slipped off an edge the force ends within that time.
//
// Motion (1 to 4, god_motion.h) and force (5) are apart, as in the source: a step takes the newest set of contacts that the motion told, and makes the
// force from it and from where the handle is now. With `own_motion` each step is one of the motion first; else that is for a thread beside, as fast as it
// comes to (god_contact_set.h): then the tool lies where it got, the handle is felt in time against walls as they were there, and new contacts
// blend in. Sets that are too old fade, and at last the tool is lost (contact_age.h).
//
// What is promised of the motion stands with god_motion.h: nothing enters anything.
//
// Thread: the haptic loop. Cost: with its own motion by rounds and what lies near, not by how fine the meshes are: 52 us, 99 % 0.24 ms, for two bumpy balls
// of 27 380 triangles pressed on each other and dragged (`./fulcrum bench god-object-step`); the force 0.5 us, `force` likewise. No allocation after it was
// built.
// Source: M. Ortega, S. Redon, S. Coquillart 2007, A six degree-of-freedom god-object method for haptic display of rigid bodies with surface
// properties, IEEE TVCG 13(3), sections 3 and 4; k_s = 0.5 as there. The gap at rest, and bounds by gaps and by the objects' motion, are ours.
#pragma once

#include "haptics/constraint/even_pressure.h"
#include "haptics/tool/beside_task.h"
#include "haptics/tool/god_object/god_contact_set.h"
#include "haptics/tool/god_object/god_force.h"
#include "haptics/tool/god_object/god_motion.h"
#include "haptics/tool/god_object/god_object_plan.h"
#include "haptics/tool/god_object/god_texture.h"
#include "haptics/tool/tool_solver.h"

#include <memory>
#include <span>
#include <vector>

namespace fulcrum {

class GodObjectTool final : public ToolSolver, public BesideSolver {
  public:
    /// Refuses what `validate` refuses, a plan without an object or with a mesh that is missing, and more than kMaxSolids.
    [[nodiscard]] static Expected<GodObjectTool> build(const std::vector<GodObjectPlan>& plans,
                                                       const GodObjectSettings& settings);
    GodObjectTool(GodObjectTool&&) noexcept = default;
    GodObjectTool& operator=(GodObjectTool&&) noexcept = default;
    ~GodObjectTool() override;

    void place(const Pose& handle_W) noexcept override;
    /// Farther apart than twice the gap at rest, or the gap at least; not inside what a closed mesh encloses.
    [[nodiscard]] bool is_free(std::span<const MovingFrame> objects) const noexcept override;
    /// What is no place (god_force.h), and objects that overlap the tool in the first step after it was placed, leave it standing; nothing is felt.
    [[nodiscard]] ToolFelt move(const MovingFrame& handle, std::span<const MovingFrame> objects,
                                double now_s, double dt_s) noexcept override;
    /// As often as asked between two steps, on their thread: what is felt of the last one's contacts if the handle is here. On the hand, about the grip.
    [[nodiscard]] Wrench force(const Pose& handle_W) noexcept;

    [[nodiscard]] BesideTask* beside() noexcept override {
        return settings_.own_motion ? nullptr : motion_.get();
    }
    [[nodiscard]] const ContactAge& contact_age() const noexcept override { return age_; }
    void listen_to_rounds(RoundListener* listener) noexcept override {
        listener_ = settings_.own_motion ? listener : nullptr;
    }

    /// The centre of mass, along the principal axes.
    [[nodiscard]] const Pose& pose_W() const noexcept { return pose_W_; }
    /// Where the step left an object; where it is, unless it waits.
    [[nodiscard]] const Pose& object_W(std::size_t i) const noexcept {
        return set().objects[i].object_W;
    }
    [[nodiscard]] GodObjectStep last_step() const noexcept {
        return is_known_ ? set().step : GodObjectStep{};
    }

    [[nodiscard]] Pose grip_W() const noexcept override;
    [[nodiscard]] const Vector3& centre_W() const noexcept override { return pose_W_.position; }
    [[nodiscard]] std::span<const ToolTouch> touches() const noexcept override { return touches_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept override;

  private:
    GodObjectTool(const std::vector<GodObjectPlan>& plans, const GodObjectSettings& settings);
    [[nodiscard]] Pose find_held_W(const Pose& handle_W) const noexcept;
    // How the newest set of contacts came by.
    enum class News { none, overlaps, learnt };
    [[nodiscard]] News go(const Pose& held_W, std::span<const MovingFrame> objects,
                          bool was_felt) noexcept;
    void tell_goal(const Pose& held_W, std::span<const MovingFrame> objects, double now_s) noexcept;
    [[nodiscard]] News take_set() noexcept;
    // Taken last; counts where it is known.
    [[nodiscard]] const GodContactSet& set() const noexcept {
        return channels_ ? channels_->set.value() : *own_set_;
    }
    [[nodiscard]] std::span<const GodPress> presses() const noexcept {
        return is_known_ ? set().all() : std::span<const GodPress>{};
    }
    void tell_force() noexcept;
    void tell_touches() noexcept;
    // An object with a relief.
    struct Rough {
        std::size_t object = 0;
        GodTexture texture;
    };
    void tell_relief(Rough& rough, bool is_pressed, double dt_s) noexcept;
    // By the contacts alone, and with the texture; on the hand, about the grip.
    struct Felt {
        Wrench contacts{}, all{};
    };
    [[nodiscard]] Felt feel(const Pose& handle_W) noexcept;
    void tell_even(const Pose& handle_W, ToolFelt& felt) const noexcept;
    [[nodiscard]] ToolFelt tell_felt(const Pose& handle_W, bool is_new) noexcept;
    void tell_texture(double dt_s) noexcept;
    [[nodiscard]] bool share_pressure() noexcept;
    // As far as what presses now is that of the step.
    [[nodiscard]] Wrench find_texture(double held_N) const noexcept;
    // What the contacts hold, a turn at the tool's reach.
    [[nodiscard]] double find_held_N() const noexcept;
    [[nodiscard]] Wrench about_grip(const Wrench& about_centre,
                                    const Pose& handle_W) const noexcept;

    GodObjectSettings settings_;
    std::unique_ptr<GodChannels> channels_;   // null with its own motion
    std::unique_ptr<GodContactSet> own_set_;  // then this
    std::unique_ptr<GodMotion> motion_;       // the other thread's, but for is_free, without
    RoundListener* listener_ = nullptr;
    std::vector<ToolTouch> touches_;
    std::vector<Pose> seen_OT_;    // where the tool was over each object by the last set
    std::vector<double> bumps_m_;  // of objects and tool; empty where nothing is shaded
    std::vector<Rough> rough_;     // objects
    EvenPressure pressure_;
    Wrench texture_W_{};       // on the tool, about its centre of mass, by the last set
    double textured_N_ = 0.0;  // that the contacts held then
    GodForce force_;
    GodGoal goal_{};
    ContactAge age_;
    Pose pose_W_{};
    bool is_known_ = false;  // a set of contacts of where the tool is
    double since_s_ = 0.0;   // from the last set on
};

}  // namespace fulcrum
