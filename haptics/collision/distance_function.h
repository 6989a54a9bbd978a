// A solid given by a function: negative inside, zero on the surface, positive outside.
//
// The function must have a gradient other than zero near its surface, and a bound L on how fast it changes, |f(p) - f(q)| <= L |p - q|:
// then f(p) / L is never more than the distance, and a sweep by such steps passes through nothing. For a ball the
// surface f = L radius is touched: that is the solid drawn out by the radius where f is a distance and L is 1.
//
// Thread: load; then `at` is called from the haptic loop.
#pragma once

#include "haptics/math/spatial.h"

namespace fulcrum {

class DistanceFunction {
  public:
    struct Value {
        double value = 0.0;
        Vector3 gradient_B{Vector3::UnitY()};
    };

    DistanceFunction() = default;
    DistanceFunction(const DistanceFunction&) = delete;
    DistanceFunction& operator=(const DistanceFunction&) = delete;
    virtual ~DistanceFunction() = default;

    /// At any finite place; must not allocate, lock or wait, and gives the same answer each time.
    [[nodiscard]] virtual Value at(const Vector3& p_B) const noexcept = 0;
    /// L, above 0.
    [[nodiscard]] virtual double lipschitz() const noexcept = 0;
    /// A sphere that holds the solid: all places where the function is not positive. Finite, the radius above 0.
    [[nodiscard]] virtual Vector3 centre_B() const noexcept = 0;
    [[nodiscard]] virtual double radius_m() const noexcept = 0;
};

}  // namespace fulcrum
