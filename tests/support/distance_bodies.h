// Solids given by distance functions, for tests.
#pragma once

#include "haptics/collision/distance_function.h"

#include <cmath>

namespace fulcrum {

/// A ball; `slope` times its distance, told with a bound of `bound` times that: 1 and 1 is exact.
class BallFunction final : public DistanceFunction {
  public:
    explicit BallFunction(double radius_m, double slope = 1.0, double bound = 1.0)
        : radius_(radius_m), slope_(slope), bound_(bound) {}
    [[nodiscard]] Value at(const Vector3& p_B) const noexcept override {
        const double distance = p_B.norm();
        return {slope_ * (distance - radius_),
                distance > 0.0 ? Vector3(slope_ * p_B / distance) : Vector3(Vector3::Zero())};
    }
    [[nodiscard]] double lipschitz() const noexcept override { return slope_ * bound_; }
    [[nodiscard]] Vector3 centre_B() const noexcept override { return Vector3::Zero(); }
    [[nodiscard]] double radius_m() const noexcept override { return radius_; }

  private:
    double radius_;
    double slope_;
    double bound_;
};

/// A ring round the y axis: exact distance to a circle less the tube's radius.
class RingFunction final : public DistanceFunction {
  public:
    RingFunction(double ring_m, double tube_m) : ring_(ring_m), tube_(tube_m) {}
    [[nodiscard]] Value at(const Vector3& p_B) const noexcept override {
        const double from_axis = std::hypot(p_B.x(), p_B.z());
        const Vector3 out = from_axis > 0.0 ? Vector3(p_B.x() / from_axis, 0.0, p_B.z() / from_axis)
                                            : Vector3(Vector3::UnitX());
        const Vector3 apart = (from_axis - ring_) * out + p_B.y() * Vector3::UnitY();
        const double distance = apart.norm();
        return {distance - tube_,
                distance > 0.0 ? Vector3(apart / distance) : Vector3(Vector3::UnitY())};
    }
    [[nodiscard]] double lipschitz() const noexcept override { return 1.0; }
    [[nodiscard]] Vector3 centre_B() const noexcept override { return Vector3::Zero(); }
    [[nodiscard]] double radius_m() const noexcept override { return ring_ + tube_; }

  private:
    double ring_;
    double tube_;
};

/// A plate across y, with rounded borders: exact distance to a flat square less half the thickness.
class PlateFunction final : public DistanceFunction {
  public:
    PlateFunction(double half_width_m, double half_thickness_m)
        : half_width_(half_width_m), half_thickness_(half_thickness_m) {}
    [[nodiscard]] Value at(const Vector3& p_B) const noexcept override {
        const Vector3 half(half_width_, 0.0, half_width_);
        const Vector3 apart = p_B - p_B.cwiseMax(-half).cwiseMin(half);
        const double distance = apart.norm();
        return {distance - half_thickness_,
                distance > 0.0 ? Vector3(apart / distance) : Vector3(Vector3::UnitY())};
    }
    [[nodiscard]] double lipschitz() const noexcept override { return 1.0; }
    [[nodiscard]] Vector3 centre_B() const noexcept override { return Vector3::Zero(); }
    [[nodiscard]] double radius_m() const noexcept override { return 1.5 * half_width_; }

  private:
    double half_width_;
    double half_thickness_;
};

}  // namespace fulcrum
