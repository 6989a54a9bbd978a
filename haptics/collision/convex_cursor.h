// A cursor of any convex shape, and a convex solid as it meets it; a mesh: convex_mesh_obstacle.h.
//
// Cursor and solid are cores with a radius round them (convex_gap.h). A cursor's corners and edges are rounded by a thousandth of its
// least half size, a hull cursor is as much larger: so that between cores that touch there is always a distance, and a direction. When
// the cursor turns, or the body, the cursor turns in the body's frame (obstacle.h).
//
// Thread: haptic loop. Cost: a distance some hundred nanoseconds, of a cylinder one or two thousand; no allocation.
#pragma once

#include "haptics/collision/collision_mesh.h"
#include "haptics/collision/convex_gap.h"
#include "haptics/collision/obstacle.h"
#include "haptics/collision/solid_shape.h"
#include "haptics/collision/triangle_gap.h"
#include "haptics/geometry/step_box.h"

#include <memory>
#include <optional>
#include <vector>

namespace fulcrum {

/// A convex body with the points that its core is made of, if any.
struct ConvexBody {
    ConvexCore core;
    std::shared_ptr<const std::vector<Vector3>> points{};
};

/// As a solid: exact. Only for shapes that are convex in themselves, hulls among them.
[[nodiscard]] ConvexBody make_convex_solid(const SolidShape& shape);
/// As a cursor: rounded.
[[nodiscard]] ConvexBody make_convex_cursor(const SolidShape& shape);
/// How far a body reaches from its origin in every direction at least; of a hull 0 is told, for it may not hold its origin.
[[nodiscard]] double find_least_reach_m(const ConvexBody& body);

/// What both obstacles below know of the cursor, in the body's frame: as it was when it was last kept, and as it is turned now.
class TurnedCursor {
  public:
    explicit TurnedCursor(ConvexBody body);
    /// As Obstacle::turn and Obstacle::keep_turn.
    bool turn(const Matrix3& turn_CB) noexcept;
    void keep_turn() noexcept;
    [[nodiscard]] bool has_turned() const noexcept { return has_turned_; }
    /// The core's farthest point along `direction_B`, relative to the cursor's place; now, and as it was.
    [[nodiscard]] Vector3 find_support(const Vector3& direction_B) const noexcept {
        return support(now_.turn_CB, direction_B);
    }
    [[nodiscard]] Vector3 find_kept_support(const Vector3& direction_B) const noexcept {
        return support(kept_.turn_CB, direction_B);
    }
    /// How far along the direction all of the cursor is at least, on its way or, where it has turned, at both ends.
    [[nodiscard]] double find_lowest_m(const Vector3& direction_B, const Vector3& from_B,
                                       const Vector3& to_B) const noexcept;
    /// Round all of the cursor on its way, or at both ends.
    [[nodiscard]] Box find_swept_box(const Vector3& from_B, const Vector3& to_B,
                                     double margin_m) const noexcept;
    [[nodiscard]] double radius_m() const noexcept { return body_.core.radius_m; }
    [[nodiscard]] double bounding_radius_m() const noexcept { return bounding_radius_m_; }

  private:
    struct Turn {
        Matrix3 turn_CB{Matrix3::Identity()};
        Box extent_B{};  // of the core
    };
    [[nodiscard]] Vector3 support(const Matrix3& turn_CB,
                                  const Vector3& direction_B) const noexcept {
        return turn_CB.transpose() * body_.core.find_support(turn_CB * direction_B);
    }

    ConvexBody body_;
    double bounding_radius_m_;
    Turn now_{};
    Turn kept_{};
    bool has_turned_ = false;
};

/// A convex solid as a convex cursor meets it.
class ConvexObstacle final : public Obstacle {
  public:
    ConvexObstacle(ConvexBody solid, ConvexBody cursor);

    [[nodiscard]] CastHit cast(const CastQuestion& question) noexcept override;
    [[nodiscard]] Gap find_gap(std::int32_t feature, const Vector3& at_B) const noexcept override;
    [[nodiscard]] double find_bend(std::int32_t /*feature*/, const Vector3& /*at_B*/,
                                   const Vector3& /*direction_B*/) const noexcept override {
        return 0.0;
    }
    [[nodiscard]] std::int32_t find_nearest(const Vector3& at_B,
                                            double level_m) const noexcept override;
    bool turn(const Matrix3& turn_CB) noexcept override { return cursor_.turn(turn_CB); }
    void keep_turn() noexcept override { cursor_.keep_turn(); }
    [[nodiscard]] Vector3 centre_B() const noexcept override { return Vector3::Zero(); }
    [[nodiscard]] double radius_m() const noexcept override;
    [[nodiscard]] double clearance_m() const noexcept override;

  private:
    [[nodiscard]] Gap find_turned_gap(const Vector3& from_B, const Vector3& to_B) const noexcept;

    ConvexBody solid_;
    TurnedCursor cursor_;
    double solid_radius_m_;
};

}  // namespace fulcrum
