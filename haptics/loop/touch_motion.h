// Where on each touched body the contact is, how it strokes there, and whether a tap has just begun: what texture, transient
// and sound need to know, found once for all of them.
//
//   place_B   the contact point in the body's frame: the proxy, less a round cursor's radius
//   stroke_B  its way in a round, s <- s + (place - place before - s) / 4: encoder steps are evened out over four rounds. A touch
//             begins with the hand's velocity along the surface
//   tap       the first round of a touch:  speed = -(v_hand - v_body) . normal, where that is above kSlowestTap; v_body of the
//             point of the body, over the last four rounds. Going from one triangle to the next of a body is no tap, nor is
//             a new plane of a body that is touched already.
// Thread: haptic loop. Cost: about 10 ns a solid that asks, 30 a touch. No allocation in `step`.
#pragma once

#include "haptics/loop/contact_stage.h"
#include "haptics/loop/haptic_plan.h"
#include "haptics/math/spatial.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

inline constexpr double kSlowestTap_m_per_s = 0.005;  ///< slower, a hand is laid on

/// How one solid is touched in this round.
struct TouchedPlace {
    bool touched = false;
    Vector3 place_B{Vector3::Zero()};
    Vector3 stroke_B{Vector3::Zero()};  ///< metres a round
    double slip_m_per_s = 0.0;          ///< along the surface, 0 or more
    std::size_t view =
        0;  ///< the body's axis that the surface faces most: its texture's view (triplanar.h)
};

/// A touch that has begun in this round; kNoBody when none has.
struct Tap {
    std::int32_t solid = kNoBody;
    double speed_m_per_s = 0.0;
};

/// What the hand did in this round.
struct HandMotion {
    Vector3 proxy_W{Vector3::Zero()};
    Vector3 velocity_W{Vector3::Zero()};  ///< of the hand
    double dt_s = 0.0;
};

class TouchMotion {
  public:
    /// Whether any solid of the plan has a texture or a transient or is audible.
    [[nodiscard]] static bool is_needed(const HapticPlan& plan) noexcept;
    /// Takes a plan that `validate` accepted.
    explicit TouchMotion(const HapticPlan& plan);

    void step(std::span<const TouchForce> touches, std::span<const Pose> solid_poses_W,
              const HandMotion& hand) noexcept;
    /// The hand has jumped: nothing was touched.
    void forget() noexcept;

    /// Of a solid of the plan that asks; of others nothing is told.
    [[nodiscard]] const TouchedPlace& place(std::int32_t solid) const noexcept {
        return solids_[static_cast<std::size_t>(solid)].now;
    }
    [[nodiscard]] const Tap& tap() const noexcept { return tap_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return sizeof(TouchMotion) + solids_.capacity() * sizeof(Solid);
    }

  private:
    static constexpr std::size_t kRounds = 4;  // that a body's velocity is taken over
    struct Solid {
        bool asks = false;
        TouchedPlace now{};
        std::array<Pose, kRounds>
            poses_W{};  // of the last rounds, the next to be replaced at next_
        std::size_t n_poses = 0;
    };
    void touch(Solid& solid, const TouchForce& touch, const Pose& pose_W,
               const HandMotion& hand) noexcept;
    [[nodiscard]] Vector3 velocity_of(const Solid& solid, const Pose& pose_W,
                                      const Vector3& place_B, double dt_s) const noexcept;

    double cursor_radius_m_ = 0.0;
    std::vector<Solid> solids_;
    std::size_t next_ = 0;
    Tap tap_{};
};

}  // namespace fulcrum
