// A ball that slides over all solids: it goes as near to the hand as their surfaces, drawn out by its radius, allow.
//
// Law: where the proxy touches features of solids, each is replaced by its tangent plane there: of all places in front of these
// planes the proxy takes the nearest to the hand (plane_constraints.h), and looks again from there.
//  - All features are convex, so a tangent plane has nothing of its feature in front of it: each step's place is free of what
//    gave its planes, and nearer to the hand than the one before. What is left of a curved feature's error shrinks by depth over
//    radius of curvature a round. A place that stays is one that real contacts hold.
//  - It moves only along ways that no feature comes into (obstacle.h), in the frame of each solid: first contact ends a way, and
//    the feature met joins the planes. Features that do not push are left.
//  - So a gap narrower than the ball is no way through, however its edges lie; with the radius 0 the ball is a point that keeps
//    1e-10 of the solid's size off it.
//  - A solid that moves carries the proxy that touches it, and takes along one that it meets; between two solids that close on it
//    the proxy is pushed out sideways. If there is no way out it lets one solid come nearer and counts that.
// A ball that starts in a surface is pushed out of it. All lengths are relative to the solid's size.
//
// A cursor that is no ball turns with the hand, and its place is found for that turn: `turn` comes before `step`, the hand still at its
// last goal.
//  - It turns by kMostTurn_rad a round at most. Of all places in front of the planes across which its features kept off (obstacle.h) it
//    takes the nearest, and from there goes to the goal as ever: never through a feature. It is pushed by no more than kMostPush times
//    the way of its farthest point: planes at right angles push by sqrt 3 times that at most.
//  - The spring of stiffness k holds  k |proxy - goal|^2 / 2,  of which a turn that pushes out makes more: work of a torque that the
//    hand does not feel, for a cursor gives none. So that is lent (surface/energy_loan.h), up to what one turn upright holds:
//    k ((s + h)^2 - s^2) / 2,  s: the stretch, h: from the cursor's least to its farthest reach. Turned back it is paid back.
//  - Where there is no such place, or more would be lent, it keeps its turn, and tries half of it in the next round, and then a quarter:
//    so a stick that was turned across a corridor too narrow for it stays as it was until there is room.
//
// Thread: haptic loop. Cost: bounded casts a step, and a turn looks besides at what is in its way. On a ball of 20 cm and 11 520 facets a box of
// 10 cm that turns by 3 rad/s takes 20 us, 99 % 60 us, where its step takes 8; by 50 rad/s 43 and 230 us; a cylinder twice that. On a
// ball of 2 cm in radius, where all is near, a cylinder of 6 by 12 cm takes 0.1 ms by 3 rad/s, 0.4 by 50, one round in a hundred 1.5 to 2.3 ms and single
// ones up to 22.
// No allocation, noexcept.
// Source: the turn is ours; D. C. Ruspini, K. Kolarov, O. Khatib 1997, The haptic display of complex graphical environments, SIGGRAPH.
#pragma once

#include "haptics/point/held_planes.h"
#include "haptics/point/moving_obstacle.h"
#include "haptics/point/proxy.h"
#include "haptics/surface/energy_loan.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

/// What must be known of a cursor that turns, and for the turn's energy. One that reaches as far in all directions does not turn.
struct CursorTurning {
    double least_m = 0.0;              ///< that it reaches from its middle in any direction
    double farthest_m = 0.0;           ///< and the most
    double stiffness_N_per_m = 500.0;  ///< of the stiffest spring that holds the proxy to the hand
    double period_s = 0.001;
};

class VirtualProxy final : public SurfaceObject {
  public:
    static constexpr double kMostTurn_rad = 0.1;  ///< in a round: 100 rad/s at 1 kHz
    static constexpr double kMostPush = 2.0;
    /// Farthest coordinate of a hand that is followed, metres; one beyond is ignored like NaN.
    static constexpr double kFarthest_m = 1.0e30;

    /// The solids as the cursor meets them; the proxy starts at the origin, `reset` puts it on the hand.
    explicit VirtualProxy(std::vector<MovingObstacle> solids, const CursorTurning& turning = {});

    void reset(const Vector3& hand_W) noexcept override;
    void put_solid(std::size_t solid, const Pose& pose_W) noexcept override;
    Quaternion turn(const Quaternion& hand_turn_W) noexcept override;
    void carry(std::span<const Pose> solid_poses_W) noexcept override;
    /// A goal that is not finite leaves all as it was.
    const ProxyContact& follow(const Vector3& goal_W) noexcept override;
    [[nodiscard]] const ProxyContact& contact() const noexcept override { return contact_; }

    /// How often a solid had to be let come nearer, squeezed between two.
    [[nodiscard]] std::uint64_t n_squeezed() const noexcept { return n_squeezed_; }
    /// Casts of the last step: what it cost.
    [[nodiscard]] int n_casts() const noexcept { return n_casts_; }
    /// What turning has given beyond what it took, and its most now.
    [[nodiscard]] const LoanAccount& loan() const noexcept { return loan_; }

  private:
    using Planes = HeldPlanes<ObstaclePlane>;
    struct Blocker {
        std::int32_t solid = kNoBody;
        CastHit hit;
    };

    static constexpr int kMostCasts = 64;      ///< in a step; a smooth surface takes about 3
    static constexpr int kMostTurnCasts = 16;  ///< and in a turn before it

    // Turning (virtual_proxy_solids.cpp).
    [[nodiscard]] bool try_turn(const Quaternion& turn_W, double angle_rad) noexcept;
    void follow_turn(const Quaternion& hand_turn_W) noexcept;
    void put_turn(const Quaternion& turn_W) noexcept;
    [[nodiscard]] bool make_room(double most_m) noexcept;
    [[nodiscard]] double held_J() const noexcept;

    // Motion of the solids (virtual_proxy_solids.cpp).
    void follow_touched() noexcept;
    [[nodiscard]] bool place_between(const Vector3& wish_W, const Blocker& first) noexcept;
    [[nodiscard]] Blocker find_blocker(const Vector3& to_W) noexcept;
    void accept(const Vector3& proxy_W) noexcept;
    void leave_surfaces() noexcept;

    // Motion to the goal.
    void find_near_solids(const Vector3& goal_W) noexcept;
    void follow_goal(const Vector3& goal_W, int most_casts) noexcept;
    [[nodiscard]] bool go_on(const Vector3& goal_W, double& least_m2) noexcept;
    [[nodiscard]] static Vector3 constrain(const Vector3& wish, Planes& planes) noexcept;
    [[nodiscard]] Vector3 lengthen(const Vector3& way) const noexcept;
    [[nodiscard]] Blocker cast_all(const Vector3& to_W) noexcept;
    void move_to(const Vector3& proxy_W) noexcept;
    [[nodiscard]] bool go_round(const Blocker& blocker, const Vector3& target_W,
                                const Vector3& goal_W) noexcept;
    [[nodiscard]] bool holds(const Blocker& blocker) const noexcept;
    [[nodiscard]] bool stop_at(const Blocker& blocker, const Vector3& target_W) noexcept;
    void look_again() noexcept;
    void publish(const Vector3& goal_W) noexcept;

    std::vector<MovingObstacle> solids_;
    // Solids that the hand's motion can reach in this step: the first n_near_ entries.
    std::vector<std::int32_t> near_;
    std::size_t n_near_ = 0;
    Vector3 proxy_W_{Vector3::Zero()};
    Vector3 goal_W_{Vector3::Zero()};
    double reach_m_ = 0.0;  // how far the goal came in this step: about as far as the proxy will go
    CursorTurning turning_;
    Quaternion turn_W_{Quaternion::Identity()};
    double turn_share_ = 1.0;  // of a turn, after rounds in which there was no room for it
    bool is_fresh_ = true;     // not turned since the last reset
    LoanAccount loan_{};
    Planes planes_;
    int n_casts_ = 0;
    std::uint64_t n_squeezed_ = 0;
    ProxyContact contact_;
};

}  // namespace fulcrum
