// A smooth ball of a million triangles: the force turns evenly while the hand slides.
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum::stability {
namespace {

constexpr int kFrequency = 224;  // 1 003 520 triangles
constexpr int kSteps = 20000;
constexpr double kDepth = 0.02;  // of the radius

double to_degrees(double angle_rad) {
    return angle_rad * 180.0 / std::numbers::pi;
}

// Between unit vectors, exact for small angles too.
double angle_between(const Vector3& a, const Vector3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// How far a facet's normal is from the ball's over its corners, at most: the steps in which the surface turns.
double find_facet_angle(const CollisionMesh& mesh) {
    double widest = 0.0;
    for (std::int32_t i = 0; i < mesh.n_triangles(); ++i) {
        const PreparedTriangle t = prepare_triangle(mesh, i);
        for (const Vector3& corner : {t.a, t.b, t.c}) {
            widest =
                std::max(widest, angle_between(t.doubled_area.normalized(), corner.normalized()));
        }
    }
    return widest;
}

Finding slide(double side) {
    const auto mesh = touchable(make_sphere(1.0, kFrequency));
    GodObject proxy(only_solid(mesh));
    Wanderer wanderer(71);
    proxy.reset(wanderer.next() * (1.0 + 0.1 * side));
    double worst_rad = 0.0;
    double sum_rad = 0.0;
    Vector3 before = Vector3::Zero();
    for (int i = 0; i < kSteps; ++i) {
        const ProxyContact& contact = proxy.step(wanderer.next() * (1.0 - kDepth * side), {});
        if (i > 0) {
            const double turned =
                contact.solid == 0 ? angle_between(contact.normal_W, before) : std::numbers::pi;
            worst_rad = worse(worst_rad, turned);
            sum_rad += turned;
        }
        before = contact.normal_W;
    }
    // The hand itself goes round by kStep a tick. Before and after, the force is normal to a facet, which is off the ball's normal by
    // no more than the facet's own angle, from outside up to 1/(1 - depth) of it: there it holds the proxy a little longer.
    const double limit_rad = Wanderer::kStep + 2.0 * find_facet_angle(*mesh) / (1.0 - kDepth);
    return {to_degrees(worst_rad), to_degrees(limit_rad),
            describe("the hand's own turn is %.3f degrees, the mean of all %.3f",
                     to_degrees(Wanderer::kStep), to_degrees(sum_rad / (kSteps - 1)))};
}

constexpr const char* kMeasured = "most that the force turned in a tick";

const HardCase kOutside{{"a smooth ball of a million triangles, outside",
                         "the hand slides over it at 4 radii a second, pressed in 2 %", kMeasured,
                         "degrees", [] { return slide(1.0); }}};
const HardCase kInside{{"a smooth ball of a million triangles, inside",
                        "the hand slides along its inside at 4 radii a second, pressed in 2 %",
                        kMeasured, "degrees", [] { return slide(-1.0); }}};

}  // namespace
}  // namespace fulcrum::stability
