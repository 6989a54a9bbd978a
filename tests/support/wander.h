// Hands and bodies that move by chance, the same at each run.
#pragma once

#include "haptics/math/spatial.h"

#include <cstdint>
#include <random>

namespace fulcrum {

/// Numbers, vectors and turns from a seed.
class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}
    /// -1 to 1.
    double uniform() { return uniform_(engine_); }
    /// Normally distributed in each component.
    Vector3 vector() { return {normal_(engine_), normal_(engine_), normal_(engine_)}; }
    /// Unit vector, no direction likelier than another.
    Vector3 direction() { return vector().normalized(); }
    /// Each component from -1 to 1.
    Vector3 in_cube() { return {uniform(), uniform(), uniform()}; }
    /// Each number of it from -1 to 1.
    template <class M>
    M matrix() {
        M m;
        for (Index i = 0; i < m.size(); ++i) {
            m.data()[i] = uniform();
        }
        return m;
    }
    /// About any axis, by up to `angle` radians.
    Quaternion turn(double angle) {
        return Quaternion(AngleAxis(angle * uniform(), vector().normalized()));
    }
    std::uint64_t integer() { return engine_(); }

  private:
    std::mt19937_64 engine_;
    std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
    std::normal_distribution<double> normal_;
};

/// A direction that wanders over the unit sphere by a fixed angle a step; its course bends by chance.
class Wanderer {
  public:
    static constexpr double kStep = 0.004;  ///< radians: at 1 kHz 4 radii a second

    explicit Wanderer(unsigned seed, double step_rad = kStep) : random_(seed), step_(step_rad) {}
    const Vector3& next() {
        axis_ += 0.02 * Vector3(normal_(random_), normal_(random_), normal_(random_));
        axis_ = (axis_ - axis_.dot(at_) * at_).normalized();
        at_ = (AngleAxis(step_, axis_) * at_).normalized();
        return at_;
    }

  private:
    std::mt19937_64 random_;
    std::normal_distribution<double> normal_;
    double step_;
    Vector3 at_{Vector3::UnitX()};
    Vector3 axis_{Vector3::UnitY()};
};

}  // namespace fulcrum
