// Meshes with T-junctions: edges that have a vertex where their neighbour has none, off its line by rounding. A point and a ball slide
// over them, and along a groove whose bottom is made of nothing else; they neither pass through nor stick.
#include "haptics/collision/segment_query.h"
#include "haptics/geometry/mesh_report.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/make_proxy.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/bumpy_ball.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

namespace fulcrum::stability {
namespace {

constexpr double kDepth = 0.02;
constexpr double kFar = 3.0;  // times the depth: further is a snag
constexpr int kSteps = 20000;

// A point where the radius is 0.
std::unique_ptr<Proxy> make(const std::shared_ptr<const CollisionMesh>& mesh, double radius) {
    ProxySettings settings;
    if (radius > 0.0) {
        settings = {.kind = ProxyKind::virtual_proxy, .cursor = SphereShape{radius}};
    }
    return make_proxy(settings, only_solid(mesh), {});
}

Finding slide_over(int frequency, double radius) {
    const auto split = make_t_junctions(*make_bumpy_sphere(1.0, frequency, kBumpHeight, kBumps));
    const auto mesh = touchable(split);
    const auto proxy = make(mesh, radius);
    Wanderer wanderer(21);
    proxy->reset(1.2 * wanderer.next());
    int n_snagged = 0;
    int n_inside = 0;
    for (int i = 0; i < kSteps; ++i) {
        const Vector3& u = wanderer.next();
        const Vector3 hand_W = u * (bumpy_radius(u) + radius - kDepth);
        const Vector3& at_W = proxy->step(hand_W, {}).position_W;
        n_snagged += (at_W - hand_W).norm() > kFar * kDepth ? 1 : 0;
        // A star-shaped body: from a place inside, the way straight out meets it.
        n_inside += find_nearest_hit(*mesh, at_W, 2.0 * at_W.normalized()).found() ? 1 : 0;
    }
    return {static_cast<double>(n_snagged + n_inside), 0.0,
            std::to_string(compute_mesh_report(*split).open_edges) + " open edges, inside in " +
                std::to_string(n_inside)};
}

// A groove that lies askew, so that no vertex on its bottom is where exact numbers would have it.
Finding slide_along_groove(double opening_deg, double radius) {
    const double half_opening = 0.5 * opening_deg * std::numbers::pi / 180.0;
    const double slope = 0.5 * std::numbers::pi - half_opening;
    const auto straight = make_trench(slope, 300);
    const Matrix3 askew = Random(22).turn(2.0).toRotationMatrix();
    std::vector<Vector3> vertices = straight->vertices_B();
    for (Vector3& vertex : vertices) {
        vertex = askew * vertex;
    }
    const auto split =
        make_t_junctions(*TriangleMesh::build(std::move(vertices), straight->triangles()));
    const auto mesh = touchable(split);
    const auto proxy = make(mesh, radius);
    const double bottom = radius / std::sin(half_opening);
    proxy->reset(askew * Vector3(0.0, bottom + 0.2, -0.3));
    double worst = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        // Below the bottom, and from side to side so little that it stays the nearest.
        const double below = 0.1 + 0.05 * std::sin(0.013 * i);
        const double beside = 0.5 * std::tan(half_opening) * below * std::sin(0.031 * i);
        const Vector3 hand(beside, bottom - below, 0.8 * std::sin(0.0017 * i));
        const Vector3 at = askew.transpose() * proxy->step(askew * hand, {}).position_W;
        worst = worse(worst, (at - Vector3(0.0, bottom, hand.z())).norm());
    }
    // It is held 1e-10 of the mesh's radius over both walls, and a fifth more for rounding.
    return {worst, 1.2e-10 * mesh->radius_m() / std::sin(half_opening),
            std::to_string(compute_mesh_report(*split).open_edges) + " open edges"};
}

constexpr double kBall = 0.02;
constexpr const char* kOver = "the hand slides 2 % deep at 4 radii a second over a bumpy ball";
constexpr const char* kCounted = "steps that snag or lie inside";
constexpr const char* kAlong = "the hand sways below the bottom, along which edges do not meet";
constexpr const char* kMeasured = "distance from the exact place";

const HardCase kPointOver{
    {"T-junctions under a point", kOver, kCounted, "", [] { return slide_over(22, 0.0); }}};
const HardCase kBallOver{
    {"T-junctions under a ball", kOver, kCounted, "", [] { return slide_over(22, kBall); }}};
const HardCase kPointAlong{{"T-junctions along a groove, a point", kAlong, kMeasured, "m",
                            [] { return slide_along_groove(60.0, 0.0); }}};
const HardCase kBallAlong{{"T-junctions along a groove, a ball", kAlong, kMeasured, "m",
                           [] { return slide_along_groove(60.0, kBall); }}};

}  // namespace
}  // namespace fulcrum::stability
