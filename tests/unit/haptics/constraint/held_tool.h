// A tool of 50 g held by contacts at its arms: what tests of the least constraint and of friction share.
#pragma once

#include "haptics/math/spatial.h"
#include "haptics/math/split_mix.h"

#include <cstdint>

namespace fulcrum::held_tool {

constexpr double kMass_kg = 0.05;

inline Vector6 six(const Vector3& linear, const Vector3& angular = Vector3::Zero()) {
    Vector6 v;
    v << linear, angular;
    return v;
}
/// What a push along the normal at this arm does, and how the contact's speed follows from the tool's.
inline Vector6 along(const Vector3& arm_W, const Vector3& normal_W) {
    return six(normal_W, arm_W.cross(normal_W));
}

class Chance {
  public:
    explicit Chance(std::uint64_t seed) : chance_(seed) {}
    double draw(double low, double high) { return low + (high - low) * chance_.draw_chance(); }
    Vector3 draw_vector(double size) {
        return {draw(-size, size), draw(-size, size), draw(-size, size)};
    }
    Vector3 draw_direction() { return draw_vector(1.0).normalized(); }

  private:
    SplitMix chance_;
};

}  // namespace fulcrum::held_tool
