// A mesh that passes through itself: two bars that cross, told to the loader as one body. Where they meet outside, the proxy is
// held by both, as if they were one; the walls that lie within the other bar are never felt.
#include "haptics/collision/self_intersection.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/make_proxy.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/join_meshes.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <cmath>
#include <string>
#include <vector>

namespace fulcrum::stability {
namespace {

constexpr double kHalf_m = 0.1;  // of both bars, across
constexpr int kSteps = 20000;

// A bar along x and one along y, welded into one mesh of two parts that cross about the origin.
Expected<TriangleMesh> make_cross() {
    return join_meshes({{make_box({1.0, 2.0 * kHalf_m, 1.0}).value(), {}},
                        {make_box({2.0 * kHalf_m, 1.0, 1.0}).value(), {}}});
}

// The hand wanders in and out about the inner corner between the two bars. Free is what lies beyond both: of that, which is
// convex, the proxy takes the nearest. `reach_m`: how far the cursor reaches from its middle along x and y.
Finding press(const ProxySettings& settings, double reach_m, double limit_m) {
    const auto mesh = make_cross();
    if (compute_full_mesh_report(*mesh).self_intersections == 0) {
        return {HUGE_VAL, 0.0, "the mesh does not pass through itself"};
    }
    const auto proxy = make_proxy(settings, only_solid(touchable(mesh)), {});
    const double corner_m = kHalf_m + reach_m;
    const Vector3 centre_W(corner_m, corner_m, 0.0);
    Random random(81);
    Vector3 hand_W = centre_W + Vector3(0.05, 0.05, 0.0);
    proxy->reset(hand_W);
    double worst_m = 0.0;
    int n_corner = 0;
    for (int i = 0; i < kSteps; ++i) {
        hand_W += 0.01 * random.vector();
        const double away_m = (hand_W - centre_W).norm();
        hand_W = away_m > 0.15 ? Vector3(centre_W + (hand_W - centre_W) * (0.15 / away_m)) : hand_W;
        const Vector3 place_W(std::max(hand_W.x(), corner_m), std::max(hand_W.y(), corner_m),
                              hand_W.z());
        worst_m = worse(worst_m, (proxy->step(hand_W, {}).position_W - place_W).norm());
        n_corner += hand_W.x() < corner_m && hand_W.y() < corner_m ? 1 : 0;
    }
    const bool meant = n_corner > kSteps / 20;
    return {meant ? worst_m : HUGE_VAL, limit_m,
            std::to_string(100 * n_corner / kSteps) + " % of the time in the corner"};
}

constexpr const char* kWork = "the hand goes in and out where two bars of one mesh cross";
constexpr const char* kMeasured = "distance from the exact place";
// Held 1e-10 of the body's radius off each of two faces; ten times that leaves room for rounding.
constexpr double kLimit_m = 1.0e-9;

const HardCase kPoint{{"a mesh that passes through itself, a point", kWork, kMeasured, "m",
                       [] { return press({}, 0.0, kLimit_m); }}};
const HardCase kBall{{"a mesh that passes through itself, a ball", kWork, kMeasured, "m", [] {
                          return press(
                              {.kind = ProxyKind::virtual_proxy, .cursor = SphereShape{0.02}}, 0.02,
                              kLimit_m);
                      }}};
const HardCase kBox{
    {"a mesh that passes through itself, a box", kWork, kMeasured, "m", [] {
         return press({.kind = ProxyKind::virtual_proxy, .cursor = BoxShape{{0.02, 0.02, 0.03}}},
                      0.02, kLimit_m);
     }}};

}  // namespace
}  // namespace fulcrum::stability
