// One step of one island: what its bodies' velocities become under loads, contacts and joints, and where overlap goes.
//
//   v_free = v + h (g + F / m),   w_free = I^-1 (L + h torque)
//            where what closes within the step arrives faster than `least_bounce_m_per_s`, v is what impacts make of it (impact.h)
//   v      = the contact problem's answer: contacts that will have closed within the step may close, no more: u_n >= -gap / h; what overlaps
//            may not go deeper: u_n >= 0; joints hold velocities
//   drift  = v, or where anything overlaps or a joint is off its place, the answer of the same problem with targets that end this:
//            u = min(rate * depth, most push), rate at most 1 / h. Bodies move by the drift and keep v: what pushes them apart gives them no speed and no
//            energy, and nothing is pushed faster than stated, however deep it was
// Hands that hold a body are rows of the problem (hand_rows.h). Where a hand's impulse comes out longer than it may be, the bounds of its
// rows are drawn in to what is as long as it may along the answer, and the problem is solved once more.
// A joint's pull f on an arm r turns a light body back with the stiffness K = (r.f) 1 - sym(r f^T), which has nothing about the arm
// itself: where this swings faster than steps can follow, the body's moments I count as more by the positive part of h^2 K - I / 2, as
// an implicit step would have it. An answer that the solver does not find is
// sought in rounds, contact after contact, which are less exact and give no energy.
// Impulses start from those of the last step, contact by contact (contact_pairs.h).
//
// Thread: that of the island; each thread has its own. Cost: that of the contact solver, and some 50 ns a contact; no allocation.
// Source: D. Stewart, J. Trinkle 1996 (contact_problem.h); velocities for the places alone: E. Guendelman, R. Bridson, R. Fedkiw 2003,
// Nonconvex rigid bodies with stacking, SIGGRAPH; the pull: S. Andrews, M. Teichmann, P. Kry 2017, Geometric stiffness for real-time
// constrained multibody dynamics, Comp. Graph. Forum 36(2).
#pragma once

#include "haptics/constraint/contact_solver.h"
#include "haptics/constraint/impact.h"
#include "haptics/dynamics/hand_rows.h"
#include "haptics/dynamics/islands.h"
#include "haptics/dynamics/rigid_scene.h"
#include "haptics/dynamics/rigid_world_plan.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

/// Of one island's step.
struct IslandReport {
    SolveReport solve{};
    double deepest_m = 0.0;  ///< overlap, 0 or more
    int n_contacts = 0;
    int n_dropped = 0;  ///< for which there was no room
};

class IslandSolver {
  public:
    /// Settings are those that `validate` accepted.
    IslandSolver(const RigidWorldSettings& settings, const ContactCapacity& capacity);

    /// Writes velocities and drifts of the island's bodies, and the impulses of its pairs and joints.
    IslandReport solve(const IslandParts& parts, double dt_s, RigidScene& scene) noexcept;

  private:
    /// 1/s; what is pushed for a long step must not come out on the other side.
    [[nodiscard]] double find_push_rate(double dt_s) const noexcept {
        return std::min(settings_.push_rate_per_s, 1.0 / dt_s);
    }
    void build(const IslandParts& parts, double dt_s, RigidScene& scene) noexcept;
    // And builds the problem anew. False when impacts went on after as many rounds as there may be.
    [[nodiscard]] bool bounce(const IslandParts& parts, double dt_s, RigidScene& scene) noexcept;
    void add_bodies(const IslandParts& parts, double dt_s, RigidScene& scene) noexcept;
    void add_pair(const ContactPair& pair, double dt_s, const RigidScene& scene) noexcept;
    void add_joint(const Joint& joint, double dt_s, const RigidScene& scene) noexcept;
    void add_hand(const BodyHold& hold, const RigidWorldBody& body, double dt_s) noexcept;
    void take_velocities(const IslandParts& parts, RigidScene& scene) noexcept;
    void remember(const IslandParts& parts, double dt_s, RigidScene& scene) noexcept;
    [[nodiscard]] bool bend_joint(std::size_t first, const Joint& joint, double dt_s,
                                  const RigidScene& scene) noexcept;
    [[nodiscard]] bool bend_joints(const IslandParts& parts, double dt_s,
                                   const RigidScene& scene) noexcept;
    void remember_joint(std::size_t first, double dt_s, Joint& joint, RigidScene& scene) noexcept;
    [[nodiscard]] bool shorten_hands() noexcept;
    SolveReport solve_problem() noexcept;
    void solve_again() noexcept;
    void push(const IslandParts& parts, RigidScene& scene) noexcept;

    RigidWorldSettings settings_;
    ContactProblem problem_;
    ContactSolver solver_;
    ContactSolver rounds_;  // for what the other does not find
    ImpactSolver impacts_;
    std::vector<Vector6> met_;  // velocities of the problem's bodies, before and after impacts
    BoundedList<double> contact_pushes_;  // m/s, 0 or more: of each contact in the second problem
    BoundedList<double> row_pushes_;
    BoundedList<std::int32_t> contact_places_;  // in the problem, of each point and row in turn;
    BoundedList<std::int32_t> row_places_;      // -1 of what was refused
    BoundedList<HandBall> hand_balls_;          // by the problem's rows
    bool is_off_ = false;                       // anything has to be pushed
    bool bounces_ = false;                      // anything arrives that does
    IslandReport report_{};
};

}  // namespace fulcrum
