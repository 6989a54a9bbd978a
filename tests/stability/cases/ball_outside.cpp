// A ball as the cursor pressed onto the outside of balls of triangles: it is at the nearest place.
//
// A hand within a closed mesh at the distance d from it is d + r at least from every place where a ball of radius r is free of it: the
// way there crosses the mesh, and ends r beyond it. Over the mesh's nearest point that is reached. So the excess over d + r, which asking
// every triangle tells, is how much nearer the proxy could be; it is never below 0.
#include "haptics/geometry/shape.h"
#include "haptics/point/make_obstacle.h"
#include "haptics/point/virtual_proxy.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/nearest_point.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace fulcrum::stability {
namespace {

constexpr double kDepth = 0.02;    // of the body's radius, 1
constexpr double kNearest = 2e-5;  // of it: how near the place must be
constexpr int kSteps = 8000;       // at 4 radii a second
constexpr int kStepsACheck = 40;

Finding press(int frequency, double ball_radius_m) {
    const auto mesh = touchable(make_sphere(1.0, frequency));
    VirtualProxy proxy(make_obstacles(SphereShape{ball_radius_m}, only_solid(mesh)));
    Wanderer wanderer(3);
    proxy.reset(1.3 * wanderer.next());
    double most = 0.0;
    double least = 0.0;
    int n_free = 0;
    for (int i = 0; i < kSteps; ++i) {
        const Vector3 hand_W = (1.0 - kDepth) * wanderer.next();
        const ProxyContact& contact = proxy.step(hand_W, {});
        n_free += contact.solid == kNoBody ? 1 : 0;
        if (i % kStepsACheck == kStepsACheck - 1) {
            const double nearest_m =
                (find_nearest_on_mesh(*mesh, hand_W) - hand_W).norm() + ball_radius_m;
            const double excess_m = (contact.position_W - hand_W).norm() - nearest_m;
            most = worse(most, excess_m);
            least = std::min(least, excess_m);
        }
    }
    // Nearer than can be is through the surface; the hair that it is held off hides no more than itself.
    const bool is_whole = n_free == 0 && least > -1.0e-12;
    // A face holds the ball until the hand's foot leaves it, and its neighbour lies at up to this angle to it.
    const double between_faces = 1.3 / frequency;
    return {is_whole ? most : HUGE_VAL,
            std::max(kNearest, kDepth * (1.0 - std::cos(between_faces))),
            std::to_string(mesh->n_triangles()) + " triangles, against the nearest of all"};
}

constexpr const char* kWork = "pressed in 2 % from outside a ball of triangles at 4 radii a second";
constexpr const char* kMeasured = "distance from the hand over the nearest place's";

const HardCase kCoarse{{"the nearest place outside 1 k, a ball of 2 %", kWork, kMeasured, "R",
                        [] { return press(7, 0.02); }}};
const HardCase kFine{{"the nearest place outside 10 k, a ball of 2 %", kWork, kMeasured, "R",
                      [] { return press(22, 0.02); }}};
const HardCase kFinest{{"the nearest place outside 100 k, a ball of 2 %", kWork, kMeasured, "R",
                        [] { return press(71, 0.02); }}};
const HardCase kLarge{{"the nearest place outside 10 k, a ball of 30 %", kWork, kMeasured, "R",
                       [] { return press(22, 0.3); }}};

}  // namespace
}  // namespace fulcrum::stability
