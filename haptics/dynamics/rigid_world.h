// A world of rigid bodies that fall, rest on each other, are joined, and push back.
//
//   place     axes, inertia and boxes of all bodies, and which are near each other (near_bodies.h)
//   touch     where they touch, or will within the step (contacts_ahead.h)
//   islands   what hangs together by contacts and joints (scene_islands.h), and whose turn it is: awake or asleep, touched by a hand or
//             not (island_turns.h)
//   solve     each island by itself, some in parts of the step (island_stepper.h, island_solver.h)
//   bound     how much of its way each may go (way_bounds.h); what is lost of a step is counted
//   move      so far
// Each stage has what it computes to itself; what they all work on is rigid_scene.h.
//
// Hands hold bodies by springs and dampers that know the body late. What they will have become at the end of the step makes a body that
// is held heavier against the hand, and only there (hand_rows.h): a starved world is felt as inertia and never shakes; at rest the
// weight is what it is, and what hits the body meets its own mass.
//
// The result is the same to the bit each time, whatever the number of threads. Islands share nothing that a step changes, and no
// sum goes over more than one.
//
// Thread: the world loop. Cost: `fulcrum bench rigid-stacks`; no allocation after it is made.
// Source: A. Barrow, W. Harwin 2006, A dynamic virtual environment for haptic interaction (chains of contact, hard constraints).
#pragma once

#include "haptics/base/bounded_list.h"
#include "haptics/base/error.h"
#include "haptics/base/worker_pool.h"
#include "haptics/dynamics/contacts_ahead.h"
#include "haptics/dynamics/island_stepper.h"
#include "haptics/dynamics/island_turns.h"
#include "haptics/dynamics/near_bodies.h"
#include "haptics/dynamics/rigid_scene.h"
#include "haptics/dynamics/rigid_world_plan.h"
#include "haptics/dynamics/scene_islands.h"
#include "haptics/dynamics/way_bounds.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace fulcrum {

/// What the last step did.
struct RigidWorldReport {
    int n_islands = 0;
    int n_solved = 0;  ///< of them; the others slept or waited for their turn
    int n_asleep = 0;  ///< bodies
    int n_contacts = 0;
    int n_dropped =
        0;  ///< pairs, contacts, holds and bodies for which there was no room, or which held no numbers
    int n_iterations = 0;  ///< of all solves together
    int n_pivoted = 0;     ///< solves that Newton left to pivoting (contact_solver.h)
    int n_held = 0;        ///< islands that lost a part of their step
    int n_in_parts =
        0;  ///< islands that were solved in parts: a joint turned far, or something bounced on the way
    int n_unconverged = 0;  ///< islands whose answer is not within the tolerance
    double deepest_m = 0.0;
    double residual_m_per_s = 0.0;  ///< the greatest of all islands
};

class RigidWorld {
  public:
    /// Refuses what `validate` of the plan does.
    [[nodiscard]] static Expected<std::unique_ptr<RigidWorld>> create(const RigidWorldPlan& plan);

    /// Moves all on by `dt_s`; nothing where it is not above 0 and finite.
    void step(double dt_s) noexcept;
    /// Load path: finds the impulses of the first step of `dt_s`, so that a great heap that rests costs that step no more than those after it.
    /// Nothing moves. After the first step, or of no such time, it does nothing.
    void prepare(double dt_s);

    /// A load of the next step, about the centre of mass: it adds to what was told before, wakes the body and marks its island as
    /// touched. A body that is not there or does not move, and loads that are not finite, are passed over.
    void push(std::int32_t body, const Wrench& wrench_W) noexcept;
    /// The same of a hand (hand_rows.h), whose push is that where the body is now; `along_W` may have any length. Of a body that many hold, more than kMostHeld in all are passed over, and counted.
    void hold(std::int32_t body, const BodyHold& hold) noexcept;
    /// Takes a body out of the world, or back into it where it is, and forgets its loads. Joints of one that is not there hold nothing;
    /// what lay on it or hung from it wakes.
    void set_present(std::int32_t body, bool is_present) noexcept;
    /// Puts a body elsewhere, its shape's frame so and with this velocity, forgets its loads and wakes it. The same is passed over.
    void place(std::int32_t body, const Pose& shape_W, const Twist& velocity_W) noexcept;

    [[nodiscard]] int n_bodies() const noexcept { return static_cast<int>(scene_.bodies.size()); }
    /// Of the centre of mass and the principal axes.
    [[nodiscard]] const RigidState& state(std::int32_t body) const noexcept {
        return scene_.body(body).state;
    }
    /// Of the shape's frame.
    [[nodiscard]] Pose shape_pose_W(std::int32_t body) const noexcept {
        const RigidWorldBody& of = scene_.body(body);
        return of.state.pose_W * of.X_PB;
    }
    [[nodiscard]] const Inertia& inertia(std::int32_t body) const noexcept {
        return scene_.body(body).inertia;
    }
    [[nodiscard]] bool is_asleep(std::int32_t body) const noexcept {
        return scene_.body(body).asleep;
    }
    /// How far a body's state is behind the world's time: 0 but between the steps of what no hand touches.
    [[nodiscard]] double behind_s(std::int32_t body) const noexcept {
        return scene_.body(body).behind_s;
    }
    /// Of the last step: pairs of bodies that are near each other, and where they touch.
    [[nodiscard]] const ContactPairs& contacts() const noexcept { return scene_.pairs; }
    /// Radians or metres from where a hinge or slider was at the start.
    [[nodiscard]] double joint_travel(std::int32_t joint) const noexcept;
    /// Kinetic, and potential above the world's origin, of all that moves; joules.
    [[nodiscard]] double compute_energy_J() const noexcept;
    [[nodiscard]] const RigidWorldReport& report() const noexcept { return report_; }

  private:
    explicit RigidWorld(const RigidWorldPlan& plan);
    void find_contacts(double dt_s) noexcept;
    void find_islands(double dt_s) noexcept;
    void solve_islands() noexcept;
    void bound_ways() noexcept;
    void move_islands() noexcept;
    void tell() noexcept;
    [[nodiscard]] bool may_load(std::int32_t body) const noexcept;
    void wake_neighbours(std::int32_t body) noexcept;

    RigidWorldSettings settings_;
    RigidScene scene_;

    // Stages.
    NearBodies near_;
    ContactsAhead ahead_;
    SceneIslands islands_;
    IslandTurns turns_;
    std::vector<IslandStepper> steppers_;  // one a worker
    WayBounds bounds_;

    WorkerPool pool_;
    BoundedList<SolvedIsland> solved_;  // of those that are due
    bool has_stepped_ = false;
    RigidWorldReport report_{};
};

}  // namespace fulcrum
