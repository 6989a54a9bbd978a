// How an island of a world (rigid_world.h) is solved and moved: in one step, or in parts of it where its joints turn far or something bounces.
//
// What bounces off what it does not touch yet goes there first: a part ends half of `find_bounce_gap` before they meet. The bounce has a
// part of its own, a gap's way, so that what comes after it is looked along as it goes then. What would take more than kMostBounceParts
// loses the rest. A joint's rows hold where its bodies turn little (joint.h). An island of which one turns by more than 0.2 rad goes in as many
// parts as keep each below, at most 32: solved, moved, placed and touched anew each time; slow steps hold pins and keep energy as short
// ones do. Others see it where it began until all islands are solved; then it stands where its parts led, or where it was held back on the
// straight way there.
//
//   move      x += h v_drift;  q turns freely with its angular momentum (integrator.h: the drift of verlet), and by what pushes it
//
// Thread: that of the island; each thread has its own. Cost: that of island_solver.h, and of finding contacts, a part; no allocation
// after it is made.
#pragma once

#include "haptics/dynamics/contacts_ahead.h"
#include "haptics/dynamics/island_solver.h"
#include "haptics/dynamics/rigid_scene.h"
#include "haptics/dynamics/rigid_world_plan.h"

namespace fulcrum {

struct SolvedIsland {
    IslandReport report{};
    int n_dropped = 0;  ///< bodies that held no numbers
    int n_parts = 1;
    bool is_cut = false;  ///< the rest of its step is lost
};

class IslandStepper {
  public:
    /// `ahead` outlives it.
    IslandStepper(const RigidWorldSettings& settings, const ContactCapacity& capacity,
                  ContactsAhead& ahead)
        : gravity_W_(settings.gravity_W),
          least_bounce_m_per_s_(settings.least_bounce_m_per_s),
          ahead_(&ahead),
          solver_(settings, capacity) {}

    /// What moves its bodies within the step, without moving them.
    [[nodiscard]] SolvedIsland solve(const IslandParts& parts, double dt_s,
                                     RigidScene& scene) noexcept;
    /// So far of that way as it goes, 1 or less. Its bodies forget their loads.
    static void move(const IslandParts& parts, double dt_s, double goes, SolvedIsland& solved,
                     RigidScene& scene) noexcept;

  private:
    [[nodiscard]] double find_bounce_s(const IslandParts& parts, double time_s,
                                       const RigidScene& scene) const noexcept;
    [[nodiscard]] SolvedIsland solve_in_parts(const IslandParts& parts, double dt_s, int n_parts,
                                              RigidScene& scene) noexcept;
    void solve_part(const IslandParts& parts, double part_s, RigidScene& scene,
                    SolvedIsland& solved) noexcept;
    void go(const IslandParts& parts, double part_s, double next_s, RigidScene& scene,
            SolvedIsland& solved) noexcept;

    Vector3 gravity_W_;
    double least_bounce_m_per_s_;
    ContactsAhead* ahead_;
    IslandSolver solver_;
};

}  // namespace fulcrum
