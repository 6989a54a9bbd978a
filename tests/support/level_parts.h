// Levels and pairs of them in a line each, for what looks for contacts among meshes.
#pragma once

#include "haptics/geometry/shape.h"
#include "haptics/levels/level_pairs.h"
#include "haptics/math/rotation.h"

#include <algorithm>
#include <memory>

namespace fulcrum::test {

using Levels = std::shared_ptr<const ContactLevels>;

/// Slack of pieces, a ten-millionth of the size, of bodies of a decimetre.
inline constexpr double kRounding_m = 2.0e-7;

inline Levels make_levels(const TriangleMesh& mesh, double within_m = 1.0e-3) {
    return ContactLevels::create(mesh, {.within_m = within_m}).value();
}

/// A ball of 5 cm with lumps of a millimetre, and a place where two of them are a little apart.
inline Levels make_lumps(double within_m) {
    return make_levels(make_bumpy_sphere(0.05, 20, 0.02, 100.0).value(), within_m);
}
inline const Pose kLumpsApart{{0.0, 0.102, 0.0}, compute_exp(Vector3(0.2, 0.4, 0.1))};

inline std::unique_ptr<LevelPairs> make_pairs(const Levels& object, const Levels& tool,
                                              const LevelPairSettings& settings = {}) {
    return LevelPairs::create(object, tool, settings).value();
}

/// Where all contacts together push.
inline Vector3 find_push(const LevelPairs& pairs) {
    Vector3 push = Vector3::Zero();
    for (const LevelContact& contact : pairs.contacts()) {
        push += std::max(contact.depth_m, 0.0) * contact.normal_O;
    }
    return push;
}

}  // namespace fulcrum::test
