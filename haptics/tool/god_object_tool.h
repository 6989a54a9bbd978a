// A tool that never enters anything: the god-object in six degrees of freedom. Its mesh goes where the hand would have it as far as the contacts
// allow, slides on along them, and the hand feels what the contacts take of its way.
//
//   1  wanted     u = k_s (x_h - x_s), a shift and a rotation vector about the centre of mass
//   2  allowed    d = argmin 1/2 (d - u)^T M (d - u)   with   n_k . (d_G + d_theta x r_k) >= delta - g_k + n_k . d_object     (least_constraint.h)
//   3  gone       as far as continuous collision lets go along d: not nearer than a quarter of delta, and of what there was   (mesh_sweep.h)
//   4  again from 2 with what is left of u, until nothing moves, or by less than a fiftieth of what a round of the step has gone; what is
//      left then, or after `most_rounds`, goes on in the next step. It is way that is free to go, so nothing of it is felt
//   5  felt       by the contacts there (god_force.h), in directions that turn evenly where a surface is shaded (god_shading.h), and
//                 the relief of what they lie on (god_texture.h)
// With friction, where an object has it, 2 is friction_constraint.h: contacts hold along themselves by up to mu of what they push, and slip against
// it beyond; by the static coefficient where the tool did not slip in the step before, by a thousandth of the gap at rest, else by the dynamic one.
// g_k is a contact's gap and delta the gap at which tools rest, a micrometre. Contacts within 4 delta are told, farther ones where the tool was
// stopped by what it did not know of: those that are farther than delta away let the tool go as far, those that are nearer push it back, where all can; so it rests at delta itself, however it came there.
// Objects that move go on their way during the same rounds, each pair of meshes on the in-between motion of one as seen from the other,
// and the tool before them. Between objects that close upon it the tool is wedged: then they are held where they touched, which is told, and catch
// up when there is room.
//
// What is felt of a tool that nothing is within 16 delta of is 0, to the bit, in that very step, however it came there and whatever `fade_s` is. Lifted
// it comes off without a step of the force; slipped off an edge with one, which the safety gate's slew limit stretches (loop/safety.h).
//
// What is promised: after each step the tool's surface and each object's (as seen: where it stopped if it was wedged) do not cross, and neither
// did they on the way, if they did not when the tool was placed. That holds for meshes with holes, cracks, flipped or loose triangles too, for
// it is about triangles: no normal of a mesh is used. What lies in an open mesh's inside may have come through its hole. A tool so small that
// it fits through a crack goes through.
//
// Thread: the haptic loop. Cost: by rounds and what lies near, not by how fine the meshes are: 52 us, 99 % 0.24 ms, for two bumpy balls of 27 380
// triangles pressed on each other and dragged (`./fulcrum bench god-object-step`); `force` 0.5 us. No allocation after it was built.
// Source: M. Ortega, S. Redon, S. Coquillart 2007, A six degree-of-freedom god-object method for haptic display of rigid bodies with surface
// properties, IEEE TVCG 13(3), sections 3 and 4; k_s = 0.5 as there. The gap at rest, and bounds by gaps and by the objects' motion, are ours.
#pragma once

#include "haptics/base/error.h"
#include "haptics/constraint/even_pressure.h"
#include "haptics/constraint/friction_constraint.h"
#include "haptics/surface/friction.h"
#include "haptics/tool/god_force.h"
#include "haptics/tool/god_pair.h"
#include "haptics/tool/god_shading.h"
#include "haptics/tool/god_texture.h"
#include "haptics/tool/tool_solver.h"

#include <memory>
#include <span>
#include <vector>

namespace fulcrum {

/// Fixed at load.
struct GodObjectSettings {
    /// K, and the clamps: with stiffnesses the most that is felt. Dampers, and what saturates, are not used.
    ToolCouplingSettings coupling{};
    Inertia inertia{};                ///< M
    Vector3 grip_T{Vector3::Zero()};  ///< where the hand holds it, metres from the centre of mass
    Quaternion handle_turn{
        Quaternion::Identity()};  ///< q_HT, unit: how the tool lies in the handle
    double step_share = 0.5;      ///< k_s of the way to the handle a step; above 0, to 1
    double gap_m = 1.0e-6;        ///< delta, 1e-9 to 1e-3; half of the tightest clearance at most
    double fade_s = 0.05;         ///< of what a new set of contacts changes of the force; 0 to 1
    int most_rounds = 12;         ///< a step, 1 to 1000
    /// Of a step, by the machine's clock: after it no round is begun but the first, and the rest of the way goes on in the next step. 0: as
    /// long as it takes; else 1 to 1e5.
    double budget_us = 0.0;
    int most_contacts = 2048;  ///< of an object, 1 to 65536
};

/// Refuses settings outside their ranges, NaN included.
[[nodiscard]] Expected<void> validate(const GodObjectSettings& settings);

/// How far the force of a wall may be off, N: K delta, for it is met a gap at rest before its surface, and the constraints' answer is exact to 1e-12.
/// Between two walls that meet at an angle that over the sine of its half. Without friction, and besides what is still blended in.
[[nodiscard]] double find_wall_error_N(const GodObjectSettings& settings) noexcept;

/// One object and the tool, both made ready.
struct GodObjectPlan {
    std::shared_ptr<const GodSurface> object;
    std::shared_ptr<const GodSurface> tool;  ///< about its centre of mass, along its principal axes
    FrictionSettings friction{};             ///< between them; without a viscous part
    /// What is felt turns evenly over their edges (god_shading.h); of the same meshes, or none.
    std::shared_ptr<const GodShading> object_shading{};
    std::shared_ptr<const GodShading> tool_shading{};
    std::shared_ptr<const Texture> texture{};  ///< the object's relief, felt alone; or none
};

/// What one step did.
struct GodObjectStep {
    int rounds = 0;
    int contacts = 0;          ///< where it ended
    double least_gap_m = 0.0;  ///< of those; infinite without any
    bool settled = true;       ///< nothing was left to go; else it goes on in the next step
    bool wedged = false;       ///< objects wait for room: they are not where they were said to be
    bool too_many = false;     ///< contacts; those left out are kept off by the sweep alone
};

class GodObjectTool final : public ToolSolver {
  public:
    /// Refuses what `validate` refuses, and a plan without an object or with a mesh that is missing.
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

    /// The centre of mass, along the principal axes.
    [[nodiscard]] const Pose& pose_W() const noexcept { return pose_W_; }
    /// Where the step left an object; where it is, unless it waits.
    [[nodiscard]] const Pose& object_W(std::size_t i) const noexcept { return objects_W_[i]; }
    [[nodiscard]] const GodObjectStep& last_step() const noexcept { return step_; }

    [[nodiscard]] Pose grip_W() const noexcept override;
    [[nodiscard]] const Vector3& centre_W() const noexcept override { return pose_W_.position; }
    [[nodiscard]] std::span<const ToolTouch> touches() const noexcept override { return touches_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept override;

  private:
    GodObjectTool(const std::vector<GodObjectPlan>& plans, const GodObjectSettings& settings);
    [[nodiscard]] Pose find_held_W(const Pose& handle_W) const noexcept;
    [[nodiscard]] bool is_apart(std::span<const MovingFrame> objects) const noexcept;
    // Whether tool and objects are apart where the tool was placed.
    [[nodiscard]] bool begin(std::span<const MovingFrame> objects) noexcept;
    void slide(const Pose& wanted_W, std::span<const MovingFrame> objects) noexcept;
    bool slide_once(const Pose& wanted_W, std::span<const MovingFrame> objects, bool recovers,
                    double& longest_m) noexcept;
    // The allowed way nearest to the one that leads to `wanted_W`.
    [[nodiscard]] Vector6 find_allowed(const Pose& wanted_W) noexcept;
    // With contacts that are too near pushing the tool back, or only not letting it nearer.
    [[nodiscard]] const LeastConstraint& solve(const Vector6& wanted, bool pushes) noexcept;
    // How much of the way it, and the objects theirs, may go.
    [[nodiscard]] double find_free_share(const Vector6& way) noexcept;
    void set_goals(std::span<const MovingFrame> objects) noexcept;
    [[nodiscard]] Pose find_object_W(std::size_t i, double share) const noexcept;
    void advance(const Vector6& way, double share) noexcept;
    [[nodiscard]] bool have_arrived() const noexcept;
    void collect() noexcept;
    void collect_within() noexcept;
    void look_farther(double way_m, double share, bool recovers) noexcept;
    [[nodiscard]] bool may_fade(const Wrench& before) noexcept;
    void tell_force() noexcept;
    void tell_touches() noexcept;
    [[nodiscard]] double find_friction(std::size_t i, const GodContact& contact) const noexcept;
    [[nodiscard]] Vector3 find_felt_normal_W(std::size_t i, const GodContact& contact,
                                             const Matrix3& R_WO) const noexcept;
    // An object with a relief.
    struct Rough {
        std::size_t object = 0;
        GodTexture texture;
        std::size_t first = 0;  // of its contacts, among all that press
    };
    void tell_relief(Rough& rough, bool presses, double dt_s) noexcept;
    // By the contacts alone, and with the texture; on the hand, about the grip.
    struct Felt {
        Wrench contacts{}, all{};
    };
    [[nodiscard]] Felt feel(const Pose& handle_W) noexcept;
    void tell_texture(double dt_s) noexcept;
    [[nodiscard]] bool share_pressure() noexcept;
    // As far as what presses now is that of the step.
    [[nodiscard]] Wrench find_texture(double held_N) const noexcept;
    // What the contacts hold, a turn at the tool's reach.
    [[nodiscard]] double find_held_N() const noexcept;
    void note_slips() noexcept;
    void forget_slips() noexcept;
    [[nodiscard]] Wrench about_grip(const Wrench& about_centre,
                                    const Pose& handle_W) const noexcept;

    GodObjectSettings settings_;
    std::vector<GodPair> pairs_;
    std::vector<Pose> objects_W_;
    std::vector<Pose> goals_W_;  // of this round
    std::vector<ToolTouch> touches_;
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
    std::vector<Rough> rough_;       // objects
    EvenPressure pressure_;
    Wrench texture_W_{};       // on the tool, about its centre of mass, in the last step
    double textured_N_ = 0.0;  // that the contacts held then
    LeastConstraintSolver solver_;
    FrictionConstraintSolver dragging_;  // in its place, where there is friction
    GodForce force_;
    Pose pose_W_{};
    double reach_m_ = 0.0;   // of the tool
    double within_m_ = 0.0;  // what is nearer is a contact
    bool is_begun_ = false;
    bool is_cut_ = false;  // the way of this round, not by what touches
    GodObjectStep step_{};
};

}  // namespace fulcrum
