// A ball as the cursor: scales, and the nearest place within a body. Grooves: grooves.cpp.
#include "haptics/collision/segment_query.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/make_obstacle.h"
#include "haptics/point/plane_constraints.h"
#include "haptics/point/virtual_proxy.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::stability {
namespace {

VirtualProxy make_ball(std::shared_ptr<const CollisionMesh> mesh, double radius_m) {
    return VirtualProxy(make_obstacles(SphereShape{radius_m}, only_solid(std::move(mesh))));
}

// The same hand over bodies of other sizes; places are compared in radii.
Finding scale_scene() {
    const auto body = make_bumpy_sphere(1.0, 20, 0.03, 20.0);
    double worst = 0.0;
    for (const double scale : {1e-4, 1e-3, 0.1, 10.0, 1e3}) {
        std::vector<Vector3> vertices = body->vertices_B();
        for (Vector3& vertex : vertices) {
            vertex *= scale;
        }
        VirtualProxy here = make_ball(touchable(body), 0.02);
        VirtualProxy there =
            make_ball(touchable(TriangleMesh::build(std::move(vertices), body->triangles(),
                                                    {.weld_relative = 0.0})),
                      0.02 * scale);
        Wanderer wanderer(61);
        here.reset(Vector3(1.5, 0.0, 0.0));
        there.reset(scale * Vector3(1.5, 0.0, 0.0));
        for (int i = 0; i < 5000; ++i) {
            const Vector3 hand = wanderer.next() * (0.97 + 0.06 * std::sin(0.01 * i));
            // What the two are away from their hands: where two ways round an edge are equally good, rounding decides.
            const double apart = (here.step(hand, {}).position_W - hand).norm() -
                                 (there.step(scale * hand, {}).position_W / scale - hand).norm();
            worst = worse(worst, std::abs(apart));
        }
    }
    return {worst, 1.0e-6, ""};
}

// The place nearest to the hand in a convex body shrunk by a radius: the most violated of all its faces joins those that act, until
// none is violated.
Vector3 find_nearest_within(const CollisionMesh& mesh, double radius_m, const Vector3& hand_B) {
    std::vector<PlaneConstraint> acting;
    Vector3 place_B = hand_B;
    for (int round = 0; round < 100; ++round) {
        PlaneConstraint worst;
        double least_m = 0.0;
        for (std::int32_t i = 0; i < mesh.n_triangles(); ++i) {
            const PreparedTriangle t = prepare_triangle(mesh, i);
            const Vector3 inwards = -t.doubled_area.normalized();
            const double gap_m = inwards.dot(t.a) + radius_m;
            if (inwards.dot(place_B) - gap_m < least_m - 1.0e-13) {
                least_m = inwards.dot(place_B) - gap_m;
                worst = {inwards, gap_m};
            }
        }
        if (least_m == 0.0) {
            return place_B;
        }
        acting.push_back(worst);
        std::vector<PlaneConstraint> seen = acting;
        for (PlaneConstraint& plane : seen) {
            plane.offset_m -= plane.normal.dot(hand_B);
        }
        const ConstrainedPoint found = compute_constrained_point(Vector3::Zero(), seen, 1.0e-12);
        place_B = hand_B + found.position;
        std::vector<PlaneConstraint> kept;
        for (int i = 0; i < found.n_active; ++i) {
            kept.push_back(
                acting[static_cast<std::size_t>(found.active[static_cast<std::size_t>(i)])]);
        }
        acting = kept;
    }
    return Vector3::Constant(HUGE_VAL);
}

// Along the inside of a convex body there is one nearest place: found by asking every face.
Finding slide_inside(int frequency) {
    constexpr double kRadius = 0.02;
    constexpr double kDepth = 0.02;
    const auto mesh = touchable(make_sphere(1.0, frequency));
    VirtualProxy proxy = make_ball(mesh, kRadius);
    Wanderer wanderer(3);
    proxy.reset(0.7 * wanderer.next());
    double worst = 0.0;
    for (int i = 0; i < 5000; ++i) {
        const Vector3 hand = wanderer.next() * (1.0 - kRadius + kDepth);
        const Vector3& at = proxy.step(hand, {}).position_W;
        if (i % 50 == 49) {
            worst = worse(worst, (at - find_nearest_within(*mesh, kRadius, hand)).norm());
        }
    }
    return {worst, 2.0e-5, std::to_string(mesh->n_triangles()) + " triangles"};
}

const HardCase kScales{{"a ball in scenes scaled by 1e-4 to 1e3", "the hand presses a bumpy body",
                        "distance to the hand, of the size, against scale 1", "", scale_scene}};
const HardCase kCoarse{
    {"a ball inside a body of 1 k triangles", "it slides at 4 radii a second, pressed in 2 %",
     "distance from the nearest place, radii", "", [] { return slide_inside(7); }}};
const HardCase kFiner{
    {"a ball inside a body of 100 k triangles", "it slides at 4 radii a second, pressed in 2 %",
     "distance from the nearest place, radii", "", [] { return slide_inside(71); }}};

}  // namespace
}  // namespace fulcrum::stability
