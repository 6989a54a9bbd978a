// The god-object inside and outside a box: against a wall, at edges and in corners, where the true place is known exactly.
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/box_place.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::stability {
namespace {

// Where a proxy stands is the geometry's place, held 1e-10 of the solid's radius above each touched face; ten times that
// leaves room for three faces and for rounding.
constexpr double kLimit = 1.0e-9;
constexpr int kSteps = 20000;
constexpr double kHalf_m = 0.5;
constexpr int kStepsInside = 4000;

// A hand that wanders by `step_m` within 0.2 m of a place at the surface of a cube of one metre, in and out of it.
Finding wander_about(const Vector3& centre_W, double step_m) {
    const Vector3 size_m = Vector3::Ones();
    GodObject proxy(only_solid(touchable(make_box(size_m))));
    Random random(31);
    Vector3 hand_W = 1.5 * centre_W;
    proxy.reset(hand_W);
    BoxPlace place(size_m, hand_W);
    double worst_m = 0.0;
    int n_touching = 0;
    int n_touches = 0;
    for (int i = 0; i < kSteps; ++i) {
        const bool touched = place.is_touching();
        hand_W += step_m * random.vector();
        const double away_m = (hand_W - centre_W).norm();
        hand_W = away_m > 0.2 ? Vector3(centre_W + (hand_W - centre_W) * (0.2 / away_m)) : hand_W;
        const Vector3 place_W = place.step(hand_W);
        worst_m = worse(worst_m, (proxy.step(hand_W, {}).position_W - place_W).norm());
        n_touching += place.is_touching() ? 1 : 0;
        n_touches += place.is_touching() && !touched ? 1 : 0;
    }
    return {worst_m, kLimit,
            std::to_string(n_touches) + " touches, " + std::to_string(100 * n_touching / kSteps) +
                " % of the time"};
}

// A hand that starts in the middle of a box of one metre and circles with its centre at `pressed_W`: the proxy belongs
// where the hand's coordinates are cut off at the walls.
Finding press_from_inside(const Vector3& pressed_W, double circle_m) {
    GodObject proxy(only_solid(touchable(make_box(Vector3::Constant(2.0 * kHalf_m)))));
    proxy.reset(Vector3::Zero());
    double worst_m = 0.0;
    for (int i = 0; i < kStepsInside; ++i) {
        const double turn = 0.01 * i;
        const double way_there = std::min(1.0, i / 200.0);
        const Vector3 hand_W =
            way_there * (pressed_W + circle_m * Vector3(std::sin(turn), std::sin(1.3 * turn),
                                                        std::cos(0.7 * turn)));
        const Vector3 place_W = hand_W.cwiseMax(-kHalf_m).cwiseMin(kHalf_m);
        const Vector3 proxy_W = proxy.step(hand_W, {}).position_W;
        worst_m = worse(worst_m, (proxy_W - place_W).norm());
    }
    return {worst_m, kLimit, "at any of 4000 steps"};
}

constexpr const char* kMeasured = "distance from the exact place";

const HardCase kEdge{
    {"a convex edge", "the hand goes in and out across the edge of a cube", kMeasured, "m", [] {
         return wander_about({0.5, 0.5, 0.1}, 0.02);
     }}};
const HardCase kCorner{
    {"a convex corner", "the hand goes in and out about the corner of a cube", kMeasured, "m", [] {
         return wander_about({0.5, 0.5, 0.5}, 0.02);
     }}};
const HardCase kJumps{{"a convex corner with a hand that jumps",
                       "the hand jumps by some 0.2 m a tick about the corner of a cube", kMeasured,
                       "m", [] {
                           return wander_about({0.5, 0.5, 0.5}, 0.3);
                       }}};
const HardCase kWall{
    {"a wall from inside a box", "the hand circles behind one wall", kMeasured, "m", [] {
         return press_from_inside({0.7, 0.0, 0.0}, 0.15);
     }}};
const HardCase kConcave{{"a concave edge", "the hand circles behind two walls", kMeasured, "m", [] {
                             return press_from_inside({0.7, 0.65, 0.0}, 0.1);
                         }}};
const HardCase kThree{
    {"a corner of three planes", "the hand circles behind three walls", kMeasured, "m", [] {
         return press_from_inside({0.7, 0.65, 0.72}, 0.1);
     }}};
const HardCase kInAndOut{{"in and out of a corner",
                          "the hand goes behind one, two, three walls and back", kMeasured, "m",
                          [] {
                              return press_from_inside({0.5, 0.5, 0.5}, 0.2);
                          }}};

}  // namespace
}  // namespace fulcrum::stability
