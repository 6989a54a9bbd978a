// What hands and lessons do to the bodies of a world (rigid_world.h) in its next step: pushes, which add up, and hands that hold
// (hand_rows.h), a chain of them a body through one list of all.
//
// What is not finite, or out of its range, is passed over. Whatever is taken wakes its body and marks it as touched.
//
// Thread: that of the step; `carry` and `visit`, of different bodies, during the solving of islands. Cost: some ns a load; no allocation
// after it is made.
#pragma once

#include "haptics/base/bounded_list.h"
#include "haptics/dynamics/rigid_world_body.h"
#include "haptics/handover/rigid_messages.h"

#include <cstdint>
#include <utility>

namespace fulcrum {

/// Hands on bodies in one step, each on each.
inline constexpr int kMostHeld = 64;

class BodyLoads {
  public:
    explicit BodyLoads(int most_held) : hands_(most_held) {}

    /// About the centre of mass.
    static void push(const Wrench& wrench_W, RigidWorldBody& body) noexcept;
    /// Where the body is now; `along_W` may have any length. One for which there is no room is counted.
    void hold(const BodyHold& hold, RigidWorldBody& body) noexcept;
    /// The hands go along with what they hold (carry_hold).
    void carry(const RigidState& before, const RigidWorldBody& body) noexcept;
    /// Of the hands on a body the last first.
    template <class Visit>
    void visit(const RigidWorldBody& body, const Visit& visit) const noexcept {
        for (std::int32_t i = body.held; i >= 0; i = at(i).next) {
            visit(at(i).hold);
        }
    }
    /// The step is done; bodies have forgotten theirs.
    void clear() noexcept { hands_.clear(); }
    /// Hands for which there was no room since it was asked last.
    [[nodiscard]] int take_refused() noexcept { return std::exchange(n_refused_, 0); }

  private:
    struct Hand {
        BodyHold hold{};
        std::int32_t next = -1;  // on the same body
    };
    [[nodiscard]] const Hand& at(std::int32_t i) const noexcept {
        return hands_[static_cast<std::size_t>(i)];
    }

    BoundedList<Hand> hands_;
    int n_refused_ = 0;
};

}  // namespace fulcrum
