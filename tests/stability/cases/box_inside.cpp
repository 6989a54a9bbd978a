// The god-object inside a box: against a wall, along a concave edge, in a corner, where the true place is known exactly.
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "tests/stability/cases/stability_case.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::stability {
namespace {

constexpr double kHalf_m = 0.5;
constexpr int kSteps = 4000;

// A hand that starts in the middle of a box of one metre and circles with its centre at `pressed_W`: the proxy belongs
// where the hand's coordinates are cut off at the walls.
Finding press_from_inside(const Vector3& pressed_W, double circle_m) {
    const auto mesh = make_box(Vector3::Constant(2.0 * kHalf_m)).and_then([](const auto& box) {
        return CollisionMesh::create(box);
    });
    if (!mesh) {
        return {HUGE_VAL, 0.0, to_sentence(mesh.error())};
    }
    GodObject proxy({SolidPlan{.body = 0, .shape = *mesh, .initial_pose_W = {}}});
    proxy.reset(Vector3::Zero());
    double worst_m = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double turn = 0.01 * i;
        const double way_there = std::min(1.0, i / 200.0);
        const Vector3 hand_W =
            way_there * (pressed_W + circle_m * Vector3(std::sin(turn), std::sin(1.3 * turn),
                                                        std::cos(0.7 * turn)));
        const Vector3 place_W = hand_W.cwiseMax(-kHalf_m).cwiseMin(kHalf_m);
        const Vector3 proxy_W = proxy.step(hand_W, {}).position_W;
        worst_m = worse(worst_m, (proxy_W - place_W).norm());
    }
    return {worst_m, 1.0e-9, "at any of 4000 steps"};
}

Finding press_wall() {
    return press_from_inside({0.7, 0.0, 0.0}, 0.15);
}
Finding press_concave_edge() {
    return press_from_inside({0.7, 0.65, 0.0}, 0.1);
}
Finding press_corner() {
    return press_from_inside({0.7, 0.65, 0.72}, 0.1);
}
Finding press_in_and_out_of_corner() {
    return press_from_inside({0.5, 0.5, 0.5}, 0.2);
}

constexpr const char* kMeasured = "distance from the exact place";

const HardCase kWall{
    {"a wall from inside a box", "the hand circles behind one wall", kMeasured, "m", press_wall}};
const HardCase kEdge{
    {"a concave edge", "the hand circles behind two walls", kMeasured, "m", press_concave_edge}};
const HardCase kCorner{{"a corner of three planes", "the hand circles behind three walls",
                        kMeasured, "m", press_corner}};
const HardCase kInAndOut{{"in and out of a corner",
                          "the hand goes behind one, two, three walls and back", kMeasured, "m",
                          press_in_and_out_of_corner}};

}  // namespace
}  // namespace fulcrum::stability
