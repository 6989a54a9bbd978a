// The god-object in grooves from 90 down to 2 degrees: the hand goes below the bottom, up along both walls, and jumps.
#include "haptics/point/god_object.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <cmath>
#include <numbers>

namespace fulcrum::stability {
namespace {

constexpr int kSteps = 10000;

// The point between the walls nearest to the hand: itself, its foot on a wall, or its foot on the bottom line.
Vector3 find_place(double slope, const Vector3& hand_W) {
    const double side = hand_W.x() < 0.0 ? -1.0 : 1.0;
    const Vector3 up_the_wall(side * std::cos(slope), std::sin(slope), 0.0);
    const Vector3 normal(-side * std::sin(slope), std::cos(slope), 0.0);
    if (normal.dot(hand_W) >= 0.0) {
        return hand_W;
    }
    return up_the_wall.dot(hand_W) > 0.0 ? Vector3(hand_W - normal.dot(hand_W) * normal)
                                         : Vector3(0.0, 0.0, hand_W.z());
}

Finding press_into(double opening_deg, int n_strips, bool jumps) {
    const double half_opening = 0.5 * opening_deg * std::numbers::pi / 180.0;
    const double slope = 0.5 * std::numbers::pi - half_opening;
    const auto mesh = touchable(make_trench(slope, n_strips));
    GodObject proxy(only_solid(mesh));
    proxy.reset(Vector3(0.0, 0.7, -0.3));
    Random random(32);
    double worst_m = 0.0;
    int n_bottom = 0;
    for (int i = 0; i < kSteps; ++i) {
        const Vector3 sway(0.3 * std::sin(0.011 * i), 0.2 + 0.6 * std::sin(0.003 * i),
                           0.9 * std::sin(0.0017 * i));
        const Vector3 any =
            Vector3(0.0, 0.2, 0.0) + Vector3(0.3, 0.6, 0.9).cwiseProduct(random.in_cube());
        const Vector3& hand_W = jumps ? any : sway;
        const Vector3 place_W = find_place(slope, hand_W);
        const ProxyContact& contact = proxy.step(hand_W, {});
        worst_m = worse(worst_m, (contact.position_W - place_W).norm());
        n_bottom += contact.n_constraints == 2 ? 1 : 0;
    }
    // It is held 1e-10 of the mesh's radius over both walls: that is this much over the line where they meet, and a tenth
    // more for rounding.
    const double limit_m = 1.1e-10 * mesh->radius_m() / std::sin(half_opening);
    return {worst_m, limit_m,
            "on both walls at " + std::to_string(n_bottom) + " of " + std::to_string(kSteps) +
                " steps"};
}

constexpr const char* kMeasured = "distance from the exact place";

const HardCase kRight{{"a groove of 90 degrees", "the hand sways below the bottom and up the walls",
                       kMeasured, "m", [] { return press_into(90.0, 7, false); }}};
const HardCase kNarrow{{"a groove of 10 degrees",
                        "the hand sways below the bottom and up the walls", kMeasured, "m",
                        [] { return press_into(10.0, 7, false); }}};
const HardCase kNarrowest{{"a groove of 2 degrees",
                           "the hand sways below the bottom and up the walls", kMeasured, "m",
                           [] { return press_into(2.0, 7, false); }}};
const HardCase kFine{{"a groove of 2 degrees in 2000 strips",
                      "the hand sways below the bottom and up the walls", kMeasured, "m",
                      [] { return press_into(2.0, 2000, false); }}};
const HardCase kJumps{{"a groove of 2 degrees with a hand that jumps",
                       "the hand jumps by up to a metre a tick", kMeasured, "m",
                       [] { return press_into(2.0, 200, true); }}};

}  // namespace
}  // namespace fulcrum::stability
