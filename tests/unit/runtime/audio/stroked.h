// A finger that strokes without a beginning, as the haptic loop tells of it.
#pragma once

#include "runtime/audio/touch_sound.h"

#include <cmath>
#include <numbers>

namespace fulcrum::runtime::test {

/// A stroke of 100 Hz that has no beginning.
inline TouchSample make_stroked(double time_s) {
    TouchSample sample;
    sample.time_s = time_s;
    sample.solid = 0;
    sample.normal_force_N = 2.0F;
    sample.texture_height_m =
        static_cast<float>(2e-5 * std::sin(2.0 * std::numbers::pi * 100.0 * time_s));
    return sample;
}

}  // namespace fulcrum::runtime::test
