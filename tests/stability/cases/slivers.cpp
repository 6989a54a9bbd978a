// Triangles a million times as long as wide, and meshes in which vertices and triangles are there more than once.
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/box_place.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/join_meshes.h"
#include "tests/support/nearest_point.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum::stability {
namespace {

// Held 1e-10 of the radius over each face; ten times that leaves room for three of them and for rounding.
constexpr double kLimit = 1.0e-9;
constexpr double kWidth_m = 1.0e-6;  // of a sliver one metre long
constexpr int kSlivers = 20;
constexpr int kSteps = 10000;

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
    for (int i = 0; i < kSteps; ++i) {
        // From a thousandth of a sliver a tick to hundreds of slivers a tick.
        const double across_m = (i < kSteps / 2 ? 1.5e-5 : 0.2) * std::sin(0.007 * i);
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
    for (int i = 0; i < kSteps; ++i) {
        const double reach_m = i < kSteps / 2 ? 3.0e-5 : 0.2;
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
        for (int i = 0; i < kSteps; ++i) {
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

constexpr const char* kPlace = "distance from the exact place";
constexpr const char* kSame = "distance from the proxy on the clean mesh";

const HardCase kBand{{"slivers a million times as long as wide",
                      "the hand slides over slivers in the face of a cube, slowly and fast", kPlace,
                      "m", slide_over_band}};
const HardCase kFillet{{"a concave edge rounded by slivers",
                        "the hand circles behind an edge that 20 slivers round off", kPlace, "m",
                        press_into_fillet}};
const HardCase kMess{{"coincident vertices and triangles",
                      "every triangle twice, with corners of its own and triangles without area",
                      kSame, "m", [] { return compare_messy(0.0); }}};
const HardCase kWelded{{"coincident vertices and triangles, welded",
                        "the same, built with the weld that models get", kSame, "m",
                        [] { return compare_messy(MeshBuildSettings{}.weld_relative); }}};

}  // namespace
}  // namespace fulcrum::stability
