// What the hand feels of a tool that contacts hold: the force of the constraints, from the last set of them, as often as it is asked for.
//
//   a_u = k_s (x_h - x_s)                       where the handle would have the tool, against where it is: shift and rotation vector
//   a_c = nearest to a_u that the contacts allow                               (least_constraint.h)
//   F   = k_h M (a_c - a_u) + e                 on the hand, about the centre of mass; k_h = K / (k_s m), K the coupling's stiffness
// With friction a_c is that of friction_constraint.h, and a wall holds along itself with up to mu K depth. Without it, against a wall F = K depth, along it 0, and 0 without contacts: a tool that is free is not felt, whatever its mass. A turn
// is answered by K I / m, I the tool's inertia.
// A new set of contacts makes another force of the same handle. Where that is the one before, turned by less than 0.4, as from
// facet to facet, and in size the same to a tenth, it is felt at once, so that what slides over facets is not held back. What changes by more, as a
// contact that was found late or lost, is not felt at once: e takes it, so that F goes on where it was, and fades by exp(-dt / fade). What the handle's own motion changes is never delayed. Of a
// tool that nothing is near e ends evenly within 10 ms, however it came there. Where something is near but no contact holds
// it, as a peg in a hole is free for a step now and then, e goes on fading for 5 ms, and then evenly to 0 in the time `fade` more.
// So with a `fade_s`, and something near, no set changes the force by more than 0.4 of what it was.
//
// Thread: that of its owner. Cost: for 30 contacts 0.6 to 0.9 us, 1.8 to 2.1 us where they are told anew; with friction 12 and 17 us
// (`./fulcrum bench constraint-force`). No allocation after it was built.
// Source: M. Ortega, S. Redon, S. Coquillart 2007, A six degree-of-freedom god-object method for haptic display of rigid bodies with surface
// properties, IEEE TVCG 13(3), sections 4 and 5: F = k_h M (a_c - a_u), on a loop of its own; there new constraints that are violated are moved back so
// that they begin without force, here the force is, so that a contact may take the place of another, and one that is lost ends as gently.
#pragma once

#include "haptics/constraint/friction_constraint.h"
#include "haptics/constraint/least_constraint.h"
#include "haptics/coupling/tool_coupling.h"
#include "haptics/dynamics/rigid_state.h"
#include "haptics/math/rotation.h"

namespace fulcrum {

/// Fixed at load.
struct GodForceSettings {
    Inertia inertia{};
    double stiffness_N_per_m = 500.0;  ///< K
    double step_share = 0.5;           ///< k_s
    double fade_s =
        0.05;  ///< of what a new set of contacts changes: of a tick of 1 ms below 2 %; 0: at once
    double most_N = 0.0, most_Nm = 0.0;  ///< all that the contacts may hold; 0: as it is
    bool has_friction = false;           ///< contacts may hold along themselves too
};

/// The shift and the rotation vector, world frame, that lead from one pose of a body to another.
[[nodiscard]] Vector6 find_way(const Pose& from_W, const Pose& to_W) noexcept;
/// Whether a body may be there: numbers, a unit quaternion, and no coordinate beyond 2e4 m: what rounding makes of a place, 4e-15 of it in two turns
/// and a step, is 8e-11 m there, below the nearest that a sweep lets go, 1.6e-10 m at the least gap (god_motion.h).
[[nodiscard]] bool is_place(const Pose& pose) noexcept;
/// And moves, if at all, by numbers.
[[nodiscard]] bool is_place(const MovingFrame& frame) noexcept;
/// The body after it.
[[nodiscard]] Pose go_along(const Pose& from_W, const Vector6& way) noexcept;

class GodForce {
  public:
    GodForce(const GodForceSettings& settings, std::size_t max_contacts);

    /// The tool is here, and no contact holds it until one is added.
    void begin(const Pose& tool_W) noexcept;
    /// As LeastConstraintSolver::add: the tool may still go `-least_m` against the normal. `friction` is its coefficient, 0 unless there is any.
    bool add(const Vector3& arm_W, const Vector3& normal_W, double least_m,
             double friction = 0.0) noexcept;
    [[nodiscard]] std::size_t size() const noexcept {
        return settings_.has_friction ? dragging_.size() : solver_.size();
    }

    /// On the hand, where it would hold the tool at `wanted_W`; N, and N m about the tool's centre of mass.
    [[nodiscard]] Wrench compute(const Pose& wanted_W) noexcept;
    /// Whether the last `compute` is within the solver's tolerance.
    [[nodiscard]] bool is_exact() const noexcept { return is_exact_; }
    /// Newtons by the k-th contact, in the last `compute`; without e.
    [[nodiscard]] Vector3 force_W(std::size_t k) const noexcept;
    /// Likewise by all contacts.
    [[nodiscard]] Wrench held() const noexcept { return presses_ ? solved_ : Wrench{}; }
    /// Before another set is told: the force from which that goes on, where the hand would hold the tool there now.
    void keep(const Pose& wanted_W) noexcept;
    /// After it was told, or where there is none, for the same place, `dt_s` later; `is_near`: something is near the tool.
    void blend(const Pose& wanted_W, double dt_s, bool is_near) noexcept;
    void forget_blend() noexcept {
        blended_ = {};
        free_s_ = away_s_ = 0.0;
    }
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return normals_W_.capacity() * sizeof(Vector3) + solver_.memory_bytes() +
               dragging_.memory_bytes();
    }

  private:
    [[nodiscard]] Wrench compute_held(const Pose& wanted_W) noexcept;
    [[nodiscard]] Wrench limit(const Wrench& wrench) const noexcept;

    GodForceSettings settings_;
    LeastConstraintSolver solver_;
    FrictionConstraintSolver dragging_;  // in its place, where there is friction
    std::vector<Vector3> normals_W_;     // without friction
    Pose tool_W_{};
    // e, and the contacts' force when it was made.
    struct Blended {
        Vector3 size{Vector3::Zero()};
        Vector3 of{Vector3::Zero()};
    };
    struct BlendedWrench {
        Blended force{};
        Blended torque{};
    };
    [[nodiscard]] static Vector3 find_carried(const Blended& blended, const Vector3& held,
                                              bool presses) noexcept;
    BlendedWrench blended_{};
    Wrench kept_{}, kept_held_{};  // e then, and the contacts' force
    // The last question, and its answer.
    bool is_solved_ = false;
    Vector6 solved_for_{Vector6::Zero()};
    Wrench solved_{};
    static constexpr double kMayTouchAgain_s = 0.005;
    double free_s_ = 0.0;  // without contacts, so long
    double away_s_ = 0.0;  // with nothing near
    double scale_ = 1.0;
    bool presses_ = false;  // some contact does, in the last `compute`
    bool is_exact_ = true;
};

}  // namespace fulcrum
