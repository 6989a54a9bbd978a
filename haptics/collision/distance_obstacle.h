// A solid given by a distance function as a ball meets it.
//
// With psi = f / L, which falls by at most a metre a metre, psi(x) - radius may be gone in any direction. Along a surface, at a gap of next
// to nothing, such steps lead nowhere; so a way along it is gone in three: up off the surface, across, and down again. Each
// is swept, and all three together are a way as good as the straight one.
//
// Thread: haptic loop. Cost: some ten to a hundred values of the function a cast; no allocation.
// Source: J. C. Hart 1996, Sphere tracing: a geometric method for the antialiased ray tracing of implicit surfaces, The Visual
// Computer 12(10).
#pragma once

#include "haptics/collision/distance_function.h"
#include "haptics/collision/obstacle.h"

#include <memory>

namespace fulcrum {

class DistanceObstacle final : public Obstacle {
  public:
    /// For a ball of `ball_radius_m`, 0 for a point.
    DistanceObstacle(std::shared_ptr<const DistanceFunction> function, double ball_radius_m);

    [[nodiscard]] CastHit cast(const CastQuestion& question) noexcept override;
    [[nodiscard]] Gap find_gap(std::int32_t feature, const Vector3& at_B) const noexcept override;
    /// Nothing is known of how it bends.
    [[nodiscard]] double find_bend(std::int32_t /*feature*/, const Vector3& /*at_B*/,
                                   const Vector3& /*direction_B*/) const noexcept override {
        return 0.0;
    }
    [[nodiscard]] std::int32_t find_nearest(const Vector3& at_B,
                                            double level_m) const noexcept override;
    [[nodiscard]] Vector3 centre_B() const noexcept override { return function_->centre_B(); }
    [[nodiscard]] double radius_m() const noexcept override {
        return function_->radius_m() + ball_radius_m_;
    }
    [[nodiscard]] double clearance_m() const noexcept override;

  private:
    struct Seen {
        double free_m;  // may be gone in any direction
        double gap_m;   // psi - radius over the gradient's length: the distance, to first order
        Vector3 normal_B;
    };

    [[nodiscard]] Seen look(const Vector3& at_B) const noexcept;
    [[nodiscard]] double trace(const Vector3& from_B, const Vector3& to_B, double level_m,
                               int most_steps) const noexcept;
    [[nodiscard]] CastHit cast_out(const CastQuestion& question, double gap_m) const noexcept;
    [[nodiscard]] double find_stop(const CastQuestion& question, const Vector3& lift_B,
                                   double level_m, double t_most) const noexcept;

    std::shared_ptr<const DistanceFunction> function_;
    double ball_radius_m_;
    double per_value_m_;  // 1 / L
};

}  // namespace fulcrum
