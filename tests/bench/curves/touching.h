// Contacts of a tool: in one plane, as it lies flat; or from everywhere below, as it is stuck in a hollow.
#pragma once

#include "haptics/math/spatial.h"
#include "haptics/math/split_mix.h"

#include <vector>

namespace fulcrum::bench {

struct Touching {
    Vector3 arm_W, normal_W;
};

[[nodiscard]] inline std::vector<Touching> make_touching(int n, bool flat) {
    SplitMix chance(static_cast<std::uint64_t>(n));
    const auto draw = [&] { return 2.0 * chance.draw_chance() - 1.0; };
    std::vector<Touching> touching;
    for (int k = 0; k < n; ++k) {
        const Vector3 arm(0.05 * draw(), -0.02, 0.05 * draw());
        const Vector3 normal =
            flat ? Vector3::UnitY() : Vector3(0.8 * draw(), 1.0, 0.8 * draw()).normalized();
        touching.push_back({arm, normal});
    }
    return touching;
}

}  // namespace fulcrum::bench
