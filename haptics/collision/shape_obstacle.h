// A sphere, box, capsule or cylinder as a ball meets it.
//
// Thread: haptic loop. Cost: a cast some five closed forms; no allocation.
#pragma once

#include "haptics/collision/obstacle.h"
#include "haptics/collision/shape_gap.h"

#include <algorithm>

namespace fulcrum {

template <class Shape>
class ShapeObstacle final : public Obstacle {
  public:
    /// For a ball of `ball_radius_m`, 0 for a point.
    ShapeObstacle(const Shape& shape, double ball_radius_m)
        : shape_(shape), ball_radius_m_(ball_radius_m) {}

    [[nodiscard]] CastHit cast(const CastQuestion& question) noexcept override {
        return {cast_convex(question, [this](const Vector3& at_B) { return find_gap(0, at_B); }),
                0};
    }
    [[nodiscard]] Gap find_gap(std::int32_t /*feature*/,
                               const Vector3& at_B) const noexcept override {
        Gap gap = fulcrum::find_gap(shape_, at_B);
        gap.gap_m -= ball_radius_m_;
        return gap;
    }
    [[nodiscard]] double find_bend(std::int32_t /*feature*/, const Vector3& at_B,
                                   const Vector3& direction_B) const noexcept override {
        return fulcrum::find_bend(shape_, at_B, direction_B);
    }
    [[nodiscard]] std::int32_t find_nearest(const Vector3& at_B,
                                            double level_m) const noexcept override {
        return find_gap(0, at_B).gap_m < level_m ? 0 : -1;
    }
    [[nodiscard]] Vector3 centre_B() const noexcept override { return Vector3::Zero(); }
    [[nodiscard]] double radius_m() const noexcept override {
        return bounding_radius_m(shape_) + ball_radius_m_;
    }
    [[nodiscard]] double clearance_m() const noexcept override {
        return kExactClearance * std::max(bounding_radius_m(shape_), ball_radius_m_);
    }

  private:
    Shape shape_;
    double ball_radius_m_;
};

}  // namespace fulcrum
