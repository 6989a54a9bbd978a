#include "haptics/collision/segment_query.h"
#include "haptics/collision/self_intersection.h"
#include "haptics/geometry/mesh_report.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "haptics/point/make_proxy.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/box_place.h"
#include "tests/support/bumpy_ball.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/join_meshes.h"
#include "tests/support/nearest_point.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace fulcrum::stability {
namespace {

constexpr double kRadius_m = 0.1;
constexpr int kSlides = 50;
constexpr int kSlideSteps = 1000;

// A star-shaped body: from a point inside, the way straight out meets it.
bool is_inside(const CollisionMesh& mesh, const Vector3& p_B) {
    return find_nearest_hit(mesh, p_B, p_B + 4.0 * kRadius_m * p_B.normalized()).found();
}

// Slides that ended inside, of kSlides along the seam, each back and forth across it.
int count_leaks(const CollisionMesh& mesh) {
    const std::shared_ptr<const CollisionMesh> shared(&mesh, [](const auto*) {});
    int n_leaks = 0;
    for (int slide = 0; slide < kSlides; ++slide) {
        GodObject proxy(only_solid(shared));
        Random random(400U + static_cast<unsigned>(slide));
        const double begin = 3.0 * random.uniform();
        const double pressed_m = kRadius_m * (0.93 + 0.03 * random.uniform());
        double height_m = 0.0;
        for (int i = 0; i < kSlideSteps; ++i) {
            const double turn = begin + 0.004 * i;
            height_m = 0.95 * height_m + 5.0e-4 * random.uniform();
            const Vector3 hand_W(pressed_m * std::sin(turn), height_m, pressed_m * std::cos(turn));
            if (i == 0) {
                proxy.reset(1.5 * hand_W);
            }
            proxy.step(hand_W, {});
        }
        n_leaks += is_inside(mesh, proxy.contact().position_W) ? 1 : 0;
    }
    return n_leaks;
}

// Built as any model is, and with its cracks left open beside it.
Finding slide_along_crack(double crack_m) {
    const auto body = make_bumpy_sphere(kRadius_m, 12, 0.03, 5.0);
    const auto open = make_cracked(*body, crack_m, 41, 0.0);
    const auto closed = TriangleMesh::build(open->vertices_B(), open->triangles());
    const MeshReport report = compute_mesh_report(*closed);
    const int n_leaks = count_leaks(*touchable(closed));
    return {
        report.is_closed() && report.closed_cracks == 1 ? static_cast<double>(n_leaks) : HUGE_VAL,
        0.0,
        "of 50; left open " + std::to_string(count_leaks(*touchable(open))) + " leak at " +
            std::to_string(compute_mesh_report(*open).open_edges) + " open edges"};
}

constexpr const char* kWhat = "the hand slides 50 times along a seam that was closed at load";
constexpr const char* kLeaks = "slides after which the proxy was inside";

const HardCase kCrack{{"a crack of 1e-5 m along a seam", kWhat, kLeaks, "",
                       [] { return slide_along_crack(1.0e-5); }}};
const HardCase kWideCrack{{"a crack of 1e-4 m along a seam", kWhat, kLeaks, "",
                           [] { return slide_along_crack(1.0e-4); }}};

// Held 1e-10 of the radius over each face; ten times that leaves room for three of them and for rounding.
constexpr double kLimit = 1.0e-9;
constexpr double kWidth_m = 1.0e-6;  // of a sliver one metre long
constexpr int kSlivers = 20;
constexpr int kSliverSteps = 10000;

// A square of which a corner is rounded off by slivers.
std::vector<Vector2> make_rounded_square() {
    const double radius_m = kWidth_m * kSlivers / (0.5 * std::numbers::pi);
    std::vector<Vector2> corners{{-0.5, 0.5}, {-0.5, -0.5}, {0.5, -0.5}};
    for (int i = 0; i <= kSlivers; ++i) {
        const double turn = 0.5 * std::numbers::pi * i / kSlivers;
        corners.emplace_back(Vector2::Constant(0.5 - radius_m) +
                             radius_m * Vector2(std::cos(turn), std::sin(turn)));
    }
    return corners;
}

// Across and along the band in the middle of one face, in and out.
Finding slide_over_band() {
    GodObject proxy(only_solid(touchable(make_prism(make_slivered_square(0.5), 1.0))));
    const Vector3 start_W(0.8, 0.0, 0.1);
    proxy.reset(start_W);
    BoxPlace place(Vector3::Ones(), start_W);
    double worst_m = 0.0;
    for (int i = 0; i < kSliverSteps; ++i) {
        // From a thousandth of a sliver a tick to hundreds of slivers a tick.
        const double across_m = (i < kSliverSteps / 2 ? 1.5e-5 : 0.2) * std::sin(0.007 * i);
        const Vector3 hand_W(0.48 + 0.05 * std::sin(0.002 * i), across_m, 0.4 * std::sin(0.01 * i));
        const Vector3 place_W = place.step(hand_W);
        worst_m = worse(worst_m, (proxy.step(hand_W, {}).position_W - place_W).norm());
    }
    return {worst_m, kLimit, "slivers of 1 um by 1 m"};
}

// From inside, about the rounded edge: the region is convex, so the place is the nearest point of it.
Finding press_into_fillet() {
    const std::vector<Vector2> outline = make_rounded_square();
    GodObject proxy(only_solid(touchable(make_prism(outline, 1.0))));
    proxy.reset(Vector3::Zero());
    double worst_m = 0.0;
    int n_edge = 0;
    for (int i = 0; i < kSliverSteps; ++i) {
        const double reach_m = i < kSliverSteps / 2 ? 3.0e-5 : 0.2;
        const double way_there = std::min(1.0, i / 200.0);
        const Vector2 press =
            way_there *
            (Vector2::Constant(0.5) + reach_m * Vector2(std::sin(0.013 * i), std::cos(0.0171 * i)));
        const double z = 0.45 * std::sin(0.003 * i);
        const Vector2 nearest = find_nearest_in_polygon(outline, press);
        const ProxyContact& contact = proxy.step({press.x(), press.y(), z}, {});
        worst_m =
            worse(worst_m, (contact.position_W - Vector3(nearest.x(), nearest.y(), z)).norm());
        n_edge += nearest.minCoeff() > 0.5 - 1.0e-4 && nearest != press ? 1 : 0;
    }
    return {worst_m, kLimit, "in the rounding at " + std::to_string(n_edge) + " steps"};
}

// The same hand on a clean mesh and on the same surface in a mess.
Finding compare_messy(double weld_relative) {
    const auto clean = make_bumpy_sphere(1.0, 12, 0.03, 20.0);
    const auto messy = touchable(make_messy(*clean, weld_relative));
    const auto whole = touchable(clean);
    double worst_m = 0.0;
    for (const double side : {1.0, -1.0}) {
        GodObject on_clean(only_solid(whole));
        GodObject on_messy(only_solid(messy));
        Wanderer wanderer(33);
        const Vector3 start_W = wanderer.next() * (1.0 + 0.3 * side);
        on_clean.reset(start_W);
        on_messy.reset(start_W);
        for (int i = 0; i < kSliverSteps; ++i) {
            const Vector3 hand_W = wanderer.next() * (1.0 - 0.06 * side);
            worst_m = worse(worst_m, (on_messy.step(hand_W, {}).position_W -
                                      on_clean.step(hand_W, {}).position_W)
                                         .norm());
        }
    }
    return {worst_m, kLimit,
            std::to_string(messy->n_triangles()) + " triangles, clean " +
                std::to_string(whole->n_triangles())};
}

constexpr const char* kMeasured = "distance from the exact place";
constexpr const char* kSame = "distance from the proxy on the clean mesh";

const HardCase kBand{{"slivers a million times as long as wide",
                      "the hand slides over slivers in the face of a cube, slowly and fast",
                      kMeasured, "m", slide_over_band}};
const HardCase kFillet{{"a concave edge rounded by slivers",
                        "the hand circles behind an edge that 20 slivers round off", kMeasured, "m",
                        press_into_fillet}};
const HardCase kMess{{"coincident vertices and triangles",
                      "every triangle twice, with corners of its own and triangles without area",
                      kSame, "m", [] { return compare_messy(0.0); }}};
const HardCase kWelded{{"coincident vertices and triangles, welded",
                        "the same, built with the weld that models get", kSame, "m",
                        [] { return compare_messy(MeshBuildSettings{}.weld_relative); }}};

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
    const Matrix3 askew = Random(22).turn(2.0).toRotationMatrix();
    const auto split = make_t_junctions(test::move_corners(
        *make_trench(slope, 300), [&](const Vector3& v) { return Vector3(askew * v); }));
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

constexpr double kBall_m = 0.02;
constexpr const char* kOver = "the hand slides 2 % deep at 4 radii a second over a bumpy ball";
constexpr const char* kCounted = "steps that snag or lie inside";
constexpr const char* kAlong = "the hand sways below the bottom, along which edges do not meet";

const HardCase kPointOver{
    {"T-junctions under a point", kOver, kCounted, "", [] { return slide_over(22, 0.0); }}};
const HardCase kBallOver{
    {"T-junctions under a ball", kOver, kCounted, "", [] { return slide_over(22, kBall_m); }}};
const HardCase kPointAlong{{"T-junctions along a groove, a point", kAlong, kMeasured, "m",
                            [] { return slide_along_groove(60.0, 0.0); }}};
const HardCase kBallAlong{{"T-junctions along a groove, a ball", kAlong, kMeasured, "m",
                           [] { return slide_along_groove(60.0, kBall_m); }}};

constexpr double kHalf_m = 0.1;  // of both bars, across

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
// Held 1e-10 of the body's radius off each of two faces; ten times that leaves room for rounding.
constexpr double kLimit_m = 1.0e-9;

const HardCase kCrossedByPoint{{"a mesh that passes through itself, a point", kWork, kMeasured, "m",
                                [] { return press({}, 0.0, kLimit_m); }}};
const HardCase kCrossedByBall{
    {"a mesh that passes through itself, a ball", kWork, kMeasured, "m", [] {
         return press({.kind = ProxyKind::virtual_proxy, .cursor = SphereShape{0.02}}, 0.02,
                      kLimit_m);
     }}};
const HardCase kCrossedByBox{
    {"a mesh that passes through itself, a box", kWork, kMeasured, "m", [] {
         return press({.kind = ProxyKind::virtual_proxy, .cursor = BoxShape{{0.02, 0.02, 0.03}}},
                      0.02, kLimit_m);
     }}};

}  // namespace

}  // namespace fulcrum::stability
