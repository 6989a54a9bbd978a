// A point and a ball in grooves from 90 down to 2 degrees: the hand goes below the bottom, up along both walls, and jumps.
#include "haptics/point/make_proxy.h"
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

using Hand = Vector3 (*)(int i, double slope, Random& random);

Vector3 sway(int i, double /*slope*/, Random& /*random*/) {
    return {0.3 * std::sin(0.011 * i), 0.2 + 0.6 * std::sin(0.003 * i), 0.9 * std::sin(0.0017 * i)};
}
Vector3 sway_between_walls(int i, double slope, Random& /*random*/) {
    return {0.2 * std::sin(0.011 * i) * std::cos(slope), 0.25 + 0.6 * std::sin(0.003 * i),
            0.9 * std::sin(0.0017 * i)};
}
Vector3 jump(int /*i*/, double /*slope*/, Random& random) {
    return Vector3(0.0, 0.2, 0.0) + Vector3(0.3, 0.6, 0.9).cwiseProduct(random.in_cube());
}

// A ball's middle is where both walls are a radius away, or a radius over the hand's foot on one; a point is a ball of radius 0.
Finding press_into(double opening_deg, int n_strips, Hand hand, double radius_m) {
    const double half_opening = 0.5 * opening_deg * std::numbers::pi / 180.0;
    const double slope = 0.5 * std::numbers::pi - half_opening;
    const Vector3 bottom(0.0, radius_m / std::sin(half_opening), 0.0);
    const auto mesh = touchable(make_trench(slope, n_strips));
    ProxySettings settings;
    if (radius_m > 0.0) {
        settings = {.kind = ProxyKind::virtual_proxy, .cursor = SphereShape{radius_m}};
    }
    const auto proxy = make_proxy(settings, only_solid(mesh), {});
    proxy->reset(Vector3(0.0, radius_m > 0.0 ? 0.9 : 0.7, -0.3));
    Random random(32);
    double worst_m = 0.0;
    int n_bottom = 0;
    for (int i = 0; i < kSteps; ++i) {
        const Vector3 hand_W = hand(i, slope, random);
        const Vector3 place_W = bottom + find_place(slope, hand_W - bottom);
        const ProxyContact& contact = proxy->step(hand_W, {});
        worst_m = worse(worst_m, (contact.position_W - place_W).norm());
        n_bottom += contact.n_constraints == 2 ? 1 : 0;
    }
    // It is held 1e-10 of the mesh's radius over both walls: that is this much over the line where they meet, and a tenth more for rounding; of a
    // ball as much again.
    const double held = radius_m > 0.0 ? 2.0e-10 : 1.1e-10;
    return {worst_m, held * mesh->radius_m() / std::sin(half_opening),
            describe("on both walls at %d of %d steps", n_bottom, kSteps)};
}

constexpr double kBall_m = 0.01;
constexpr const char* kMeasured = "distance from the exact place";
constexpr const char* kSways = "the hand sways below the bottom and up the walls";

const HardCase kRight{{"a groove of 90 degrees", kSways, kMeasured, "m",
                       [] { return press_into(90.0, 7, sway, 0.0); }}};
const HardCase kNarrow{{"a groove of 10 degrees", kSways, kMeasured, "m",
                        [] { return press_into(10.0, 7, sway, 0.0); }}};
const HardCase kNarrowest{{"a groove of 2 degrees", kSways, kMeasured, "m",
                           [] { return press_into(2.0, 7, sway, 0.0); }}};
const HardCase kFine{{"a groove of 2 degrees in 2000 strips", kSways, kMeasured, "m",
                      [] { return press_into(2.0, 2000, sway, 0.0); }}};
const HardCase kJumps{{"a groove of 2 degrees with a hand that jumps",
                       "the hand jumps by up to a metre a tick", kMeasured, "m",
                       [] { return press_into(2.0, 200, jump, 0.0); }}};
const HardCase kBallRight{{"a ball in a groove of 90 degrees", kSways, kMeasured, "m",
                           [] { return press_into(90.0, 7, sway_between_walls, kBall_m); }}};
const HardCase kBallNarrow{{"a ball in a groove of 10 degrees", kSways, kMeasured, "m",
                            [] { return press_into(10.0, 200, sway_between_walls, kBall_m); }}};
const HardCase kBallNarrowest{{"a ball in a groove of 2 degrees", kSways, kMeasured, "m",
                               [] { return press_into(2.0, 7, sway_between_walls, kBall_m); }}};

}  // namespace
}  // namespace fulcrum::stability
