// How fast the hand moves against the solids that it touches, at the place of each touch.
//
//   u = v_hand - v_matter,   v_matter: the velocity of c,   c_k = c_(k-1) + what the solid's matter at the proxy moved in this round
// Both by the same rule, so that a hand that goes along with a solid has u = 0, whatever the rule's lag. Each by itself: a hand counted in steps
// stays within the rule's bound for one of them, and a hand less a smooth path does not, so that each step would be felt as a blow. As
// long as a solid stands still u is the hand's own velocity, to the bit.
//
// Thread: haptic loop. Cost: a comparison a touch of what stands still; else that of an estimator, and 20 ns. No allocation.
#pragma once

#include "haptics/coupling/velocity_estimator.h"
#include "haptics/point/proxy.h"

#include <array>
#include <cstdint>
#include <span>

namespace fulcrum {

class TouchVelocity {
  public:
    /// What the hand does in this round.
    struct Hand {
        const VelocityEstimator& velocity;  ///< stepped with its newest place
        double stamp_s = 0.0;
    };

    /// Of each active touch of `contact`, and one at least, u in metres a second. A solid without a pose stands still.
    std::span<const Vector3> step(const ProxyContact& contact, std::span<const Pose> solid_poses_W,
                                  const Hand& hand) noexcept;
    /// Last in each round of solids that may move: where they were, for the first round of the next touch.
    void keep(std::span<const Pose> solid_poses_W, double stamp_s) noexcept;
    /// Nothing is touched in this round.
    void leave() noexcept { n_solids_ = 0; }
    /// The hand has jumped: nothing is known of the round before.
    void forget() noexcept {
        leave();
        n_kept_ = 0;
    }
    /// Solid i of bit i was put elsewhere at once: that is no movement.
    void put(std::uint32_t solids, std::span<const Pose> solid_poses_W) noexcept;

  private:
    struct Touched {
        std::int32_t solid = kNoBody;
        Pose pose_W{};         // in the round before
        double stamp_s = 0.0;  // of it
        bool moves = false;    // it has moved since it is touched
        Vector3 carried_W{Vector3::Zero()};
        VelocityEstimator matter{VelocitySettings{}};
    };
    void forget_left(std::span<const SolidTouch> touches) noexcept;
    void begin(Touched& touched, std::int32_t solid, const Pose& pose_W) const noexcept;
    [[nodiscard]] Vector3 follow(std::int32_t solid, const Pose& pose_W, const Vector3& place_W,
                                 const Hand& hand) noexcept;

    std::array<Touched, kMaxTouches> solids_{};  // the first n_solids_
    std::size_t n_solids_ = 0;
    std::array<Pose, kMaxSolids> kept_W_{};  // the first n_kept_
    std::size_t n_kept_ = 0;
    double kept_s_ = 0.0;
    std::array<Vector3, kMaxTouches> velocities_W_{};
};

}  // namespace fulcrum
