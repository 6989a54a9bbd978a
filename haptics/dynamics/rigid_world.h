// A world of rigid bodies that fall, rest on each other, are joined, and push back.
//
//   place     axes, inertia and boxes of all bodies
//   touch     pairs whose boxes overlap (broad_phase.h), and where they touch (find_contacts.h; with a mesh sampled_contacts.h)
//   islands   what hangs together by contacts and joints (islands.h): awake or asleep, touched by a hand or not
//   solve     each island by itself (island_solver.h)
//   move      x += h v_drift;  q turns freely with its angular momentum (integrator.h: the drift of verlet), and by what pushes it
// Contacts are looked for as far ahead as bodies can come in the step, so what is fast meets what is thin: where and when their ways meet
// (contact_sweep.h, of meshes sampled_sweep.h), not where they pass. Of what a body meets only the first bounces, and where it is met: its
// island goes as far as that, to within 2e-3 of the smaller one's size, bounces there, and goes on by what is left of the step. What the step itself gives a way that nobody
// looked along is looked along before it is gone: an island whose bodies would meet something there goes that far, all of it together,
// and loses the rest of the step; that is counted. An island that has been slower
// than the settings say for a while sleeps: it costs its boxes alone until something awake touches it or a load is put on it.
// Not so what touches nothing and is not joined, or what a motor moves.
// An island whose joints turn by more than 0.2 rad goes in up to 32 parts of the step, with contacts found anew in each: slow steps hold
// pins and keep energy as short ones do.
// Islands that no hand has touched are stepped every `slow_period_s`, by all the time that has passed since; until then they stand
// that far behind the world.
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

#include "haptics/base/error.h"
#include "haptics/base/worker_pool.h"
#include "haptics/collision/broad_phase.h"
#include "haptics/dynamics/island_solver.h"
#include "haptics/dynamics/islands.h"
#include "haptics/dynamics/rigid_scene.h"
#include "haptics/dynamics/rigid_world_plan.h"

#include <cstdint>
#include <memory>
#include <span>
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
    void prepare(double dt_s) noexcept;

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
        return scene_.bodies[static_cast<std::size_t>(body)].state;
    }
    /// Of the shape's frame.
    [[nodiscard]] Pose shape_pose_W(std::int32_t body) const noexcept {
        const RigidWorldBody& of = scene_.bodies[static_cast<std::size_t>(body)];
        return of.state.pose_W * of.X_PB;
    }
    [[nodiscard]] const Inertia& inertia(std::int32_t body) const noexcept {
        return scene_.bodies[static_cast<std::size_t>(body)].inertia;
    }
    [[nodiscard]] bool is_asleep(std::int32_t body) const noexcept {
        return scene_.bodies[static_cast<std::size_t>(body)].asleep;
    }
    /// How far a body's state is behind the world's time: 0 but between the steps of what no hand touches.
    [[nodiscard]] double behind_s(std::int32_t body) const noexcept {
        return scene_.bodies[static_cast<std::size_t>(body)].behind_s;
    }
    /// Of the last step: pairs of bodies that are near each other, and where they touch.
    [[nodiscard]] const ContactPairs& contacts() const noexcept { return scene_.pairs; }
    /// Radians or metres from where a hinge or slider was at the start.
    [[nodiscard]] double joint_travel(std::int32_t joint) const noexcept;
    /// Kinetic, and potential above the world's origin, of all that moves; joules.
    [[nodiscard]] double compute_energy_J() const noexcept;
    [[nodiscard]] const RigidWorldReport& report() const noexcept { return report_; }

  private:
    struct DueIsland {
        std::int32_t island = 0;
        double dt_s = 0.0;
    };
    struct SolvedIsland {
        IslandReport report{};
        int n_dropped = 0;
        int n_parts = 1;
        bool is_cut = false;  // the rest of its step is lost
    };
    explicit RigidWorld(const RigidWorldPlan& plan);
    void solve_all(double dt_s) noexcept;
    void place_bodies(double reach_s) noexcept;
    void find_touching(double reach_s) noexcept;
    [[nodiscard]] bool meets_in_patches(const BodyPair& pair) const noexcept;
    void add_near(BodyPair pair) noexcept;
    void find_contacts_of(int i, double reach_s) noexcept;
    void look_ahead(ContactPair& pair, double reach_s) noexcept;
    void look_ahead_in_patches(int i, double reach_s) noexcept;
    [[nodiscard]] int count_patches(int i) const noexcept;
    [[nodiscard]] bool is_apart(int i) const noexcept;
    void find_first_met() noexcept;
    void find_first_met(const IslandParts& parts) noexcept;
    [[nodiscard]] bool bounces_at_all() const noexcept;
    void find_ways() noexcept;
    void hold_back() noexcept;
    void hold_pair(const BodyPair& bodies) noexcept;
    void hold_far() noexcept;
    void find_islands() noexcept;
    void find_due(double dt_s) noexcept;
    [[nodiscard]] SolvedIsland solve_island(const DueIsland& due, IslandSolver& solver) noexcept;
    [[nodiscard]] SolvedIsland solve_in_parts(const DueIsland& due, int n_parts,
                                              IslandSolver& solver) noexcept;
    [[nodiscard]] IslandParts parts_of(std::int32_t island) const noexcept;
    [[nodiscard]] int count_parts(const DueIsland& due) const noexcept;
    [[nodiscard]] double find_bounce_s(const IslandParts& parts, double time_s) const noexcept;
    void solve_part(const IslandParts& parts, double part_s, IslandSolver& solver,
                    SolvedIsland& solved) noexcept;
    [[nodiscard]] int move_part(const IslandParts& parts, double part_s, double next_s) noexcept;
    void end_parts(const IslandParts& parts, double dt_s) noexcept;
    [[nodiscard]] int move_island(const DueIsland& due, const SolvedIsland& solved) noexcept;
    void rest_bodies(const IslandParts& parts, double dt_s) noexcept;
    [[nodiscard]] bool may_rest(const IslandParts& parts) const noexcept;
    void wake_neighbours(std::int32_t body) noexcept;
    [[nodiscard]] bool may_load(std::int32_t body) const noexcept;
    [[nodiscard]] bool wake_island(std::span<const std::int32_t> bodies) noexcept;
    [[nodiscard]] bool is_joined(const BodyPair& pair) const noexcept;

    RigidWorldSettings settings_;
    RigidScene scene_;
    BroadPhase broad_phase_;
    BoundedList<Box> boxes_;
    BoundedList<double> reaches_m_;
    BoundedList<std::uint8_t> moves_;
    BoundedList<BodyPair> near_;    // but for what joints keep from touching
    std::vector<BodyPair> joined_;  // ascending
    Islands islands_;
    BoundedList<std::int32_t> island_of_pair_;
    BoundedList<std::int32_t> island_of_joint_;
    Groups pairs_;
    Groups joints_;
    BoundedList<DueIsland> due_;
    BoundedList<double> parts_;  // of each island's way: how much it goes
    BoundedList<SolvedIsland> solved_;
    WorkerPool pool_;
    std::vector<IslandSolver> solvers_;  // one a worker
    std::uint64_t n_steps_ = 0;
    RigidWorldReport report_{};
};

}  // namespace fulcrum
