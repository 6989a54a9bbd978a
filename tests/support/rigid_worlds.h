// Worlds of rigid bodies for hard cases, benchmarks and tests: one that cannot be made ends them with its sentence.
#pragma once

#include "haptics/dynamics/rigid_world.h"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

namespace fulcrum {

inline std::unique_ptr<RigidWorld> make_rigid_world(const RigidWorldPlan& plan) {
    auto world = RigidWorld::create(plan);
    if (!world) {
        throw std::runtime_error(to_sentence(world.error()));
    }
    return std::move(*world);
}

/// In steps of a millisecond.
inline void run(RigidWorld& world, double time_s) {
    constexpr double kStep_s = 1.0e-3;
    for (int i = 0; i < static_cast<int>(std::lround(time_s / kStep_s)); ++i) {
        world.step(kStep_s);
    }
}

}  // namespace fulcrum
