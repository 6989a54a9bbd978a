// What the world loop simulates: bodies that fall and a tool that catches.
#pragma once

#include "haptics/math/spatial.h"

#include <cstdint>
#include <vector>

namespace fulcrum {

/// What falls is at least as heavy as this.
inline constexpr double kLeastFalling_kg = 1.0e-6;

struct WorldBodyPlan {
    double mass_kg = 1.0;  ///< the true mass, at least kLeastFalling_kg
    double felt_mass_kg =
        1.0;  ///< mass whose weight is felt in the tool, scaled to fit the force limit
    double radius_m = 0.05;     ///< of the sphere that catches and lands
    double drag_area_m2 = 0.0;  ///< drag coefficient times cross-section, for falling in air
};

/// A bucket on the tool: a disc-shaped opening facing +Y, and room below it.
struct CatcherPlan {
    bool present = false;
    double opening_radius_m = 0.1;
    double depth_m = 0.12;  ///< from the rim down to the floor of the bucket
    int capacity = 1;       ///< how many bodies it holds; a full one catches and holds nothing more
    Vector3 rim_centre_T{Vector3::Zero()};  ///< in the tool's frame
};

struct WorldPlan {
    double rate_hz = 500.0;              ///< 100 to 1000
    Vector3 gravity_W{0.0, -9.81, 0.0};  ///< metres per second squared
    double ground_height_m = 0.0;        ///< bodies land here
    std::vector<WorldBodyPlan> bodies;   ///< in the order of the scene, at most kMaxBodies
    CatcherPlan catcher{};
};

}  // namespace fulcrum
