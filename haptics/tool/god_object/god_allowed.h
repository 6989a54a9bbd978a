// Which way the contacts of a god-object's tool allow of one that is wanted: those that are near, and those that held it when something else stopped
// it. For god_motion.h.
//
//   d = argmin 1/2 (d - u)^T M (d - u)   with   n_k . (d_G + d_theta x r_k) >= delta - g_k + n_k . d_object        (least_constraint.h)
// g_k a contact's gap, delta the gap at rest: what is farther lets the tool go as far, what is nearer pushes it back where all can, else it only lets it no
// nearer. With friction, where an object has it, the same by friction_constraint.h. With both what stopped the tool and what held it before it goes
// along the groove between them, so the latter is recalled until it acts no more or the step ends.
//
// Thread: that of the motion. Cost: that of the solver; no allocation after it was built.
// Source: M. Ortega, S. Redon, S. Coquillart 2007, IEEE TVCG 13(3), sections 3 and 4.2 (god_motion.h); delta and what is recalled are ours.
#pragma once

#include "haptics/constraint/friction_constraint.h"
#include "haptics/constraint/least_constraint.h"
#include "haptics/tool/god_object/god_pairs.h"
#include "haptics/tool/god_object/god_slips.h"

#include <array>
#include <vector>

namespace fulcrum {

class GodAllowed {
  public:
    GodAllowed(const std::vector<GodObjectPlan>& plans, const GodObjectSettings& settings);

    /// The allowed way nearest to the one that leads to `wanted_W`: shift and rotation vector.
    [[nodiscard]] Vector6 find(const GodPairs& pairs, const GodSlips& slips,
                               const Pose& wanted_W) noexcept;
    /// Whether all that acted in the last `find` presses; for the same contacts, as all below. What is still away from the tool goes on.
    [[nodiscard]] bool is_held(const GodPairs& pairs) const noexcept;
    /// What acted is recalled from now on.
    void recall(const GodPairs& pairs) noexcept;
    /// What is recalled and did not act is no more.
    void forget_idle(const GodPairs& pairs) noexcept;
    [[nodiscard]] bool recalls() const noexcept { return n_recalled_ > 0; }
    /// Nothing is recalled any more.
    void forget() noexcept { n_recalled_ = 0; }
    /// Beside itself.
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return solver_.memory_bytes() + dragging_.memory_bytes();
    }

  private:
    // With contacts that are too near pushing the tool back, or only not letting it nearer.
    [[nodiscard]] const LeastConstraint& solve(const GodPairs& pairs, const GodSlips& slips,
                                               const Vector6& wanted, bool pushes) noexcept;
    void add(const GodPairs& pairs, const GodSlips& slips, std::size_t i, const GodContact& contact,
             bool pushes) noexcept;
    [[nodiscard]] bool acts(std::size_t k) const noexcept;

    Inertia inertia_;
    double gap_m_;
    bool has_friction_;
    LeastConstraintSolver solver_;
    FrictionConstraintSolver dragging_;  // in its place, where there is friction
    struct Recalled {
        std::size_t object = 0;
        GodContact contact{};
        Vector3 on_tool_T{Vector3::Zero()};
    };
    static constexpr std::size_t kMostRecalled = 8;
    std::array<Recalled, kMostRecalled> recalled_{};
    std::size_t n_recalled_ = 0;
};

}  // namespace fulcrum
