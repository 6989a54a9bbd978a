// A tool that never enters anything on meshes that are hard: narrow grooves, slivers, one that passes through itself. (god_tool.cpp: what only tools
// meet; god_tool_hand.cpp: hands.)
#include "haptics/math/rotation.h"
#include "tests/stability/cases/god_watch.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/join_meshes.h"
#include "tests/support/wander.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace fulcrum::stability {
namespace {

// A cube between two walls of one metre: pressed down its lower edges hang on both, and it is felt by just its depth; swayed, turned, drawn out.
Finding press_god_into_groove(double opening_deg, int n_strips) {
    const double half = 0.5 * opening_deg * std::numbers::pi / 180.0;
    constexpr double kSide_m = 0.01;
    const Vector3 size = Vector3::Constant(kSide_m);
    test::GodScene scene(make_box(size).value(),
                         {make_trench(0.5 * std::numbers::pi - half, n_strips).value()},
                         test::make_god_settings(make_box_inertia(0.05, size)));
    GodWatch watch(scene, kGodGap_m, kSide_m * kSide_m / 6.0, 2.0 * kGodGap_m / std::sin(half));
    const double rest_m =
        (kGodGap_m + 0.5 * kSide_m * std::cos(half)) / std::sin(half) + 0.5 * kSide_m;
    scene.god.place(Pose::at({0.0, rest_m + 0.01, 0.0}));
    const Pose pressed = Pose::at({0.0, rest_m - 0.005, 0.0});
    for (int i = 0; i < kBlended; ++i) {
        (void)watch.step_without_gain(pressed);
    }
    // A gap that is off by a thousandth of it lifts the cube by that over the slope.
    const double off_m = 1.0e-3 * kGodGap_m / std::sin(half);
    const ToolFelt still = watch.step(pressed);
    watch.demand(std::abs(scene.god.centre_W().y() - rest_m) / off_m);
    watch.demand_felt(still, {0.0, kGodStiffness_N_per_m * 0.005, 0.0},
                      kGodStiffness_N_per_m * off_m);
    for (int i = 0; i < 3000; ++i) {
        const Vector3 sway(0.01 * std::sin(0.011 * i), 0.01 * std::sin(0.003 * i),
                           0.3 * std::sin(0.0017 * i));
        (void)watch.step_without_gain(
            {pressed.position + sway, compute_exp(Vector3(0.0, 0.0, 0.2 * std::sin(0.007 * i)))});
    }
    const Pose out = Pose::at({0.0, 1.2, 0.0});
    for (int i = 0; i < 200; ++i) {
        (void)watch.step_without_gain(Pose::at({0.0, rest_m + (1.2 - rest_m) * i / 200.0, 0.0}));
    }
    watch.demand_free(out);
    return watch.judge();
}

// A floor at y = 0 with a band of slivers, half a metre long, in its middle.
TriangleMesh make_sliver_floor(double width_m) {
    constexpr int kSlivers = 24;
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    const auto add_line = [&](double x) {
        vertices.emplace_back(x, 0.0, -0.25);
        vertices.emplace_back(x, 0.0, 0.25);
    };
    add_line(-0.25);
    for (int i = 0; i <= kSlivers; ++i) {
        add_line(width_m * (i - 0.5 * kSlivers));
    }
    add_line(0.25);
    for (int i = 0; i + 3 < static_cast<int>(vertices.size()); i += 2) {
        triangles.push_back({i, i + 1, i + 3});
        triangles.push_back({i, i + 3, i + 2});
    }
    return TriangleMesh::build(std::move(vertices), std::move(triangles)).value();
}

// Flat, slowly and fast over the slivers: by its depth alone, as on any floor. Slivers narrower than what counts as contact, met fast with an edge along
// theirs, may stop and turn it for a step: then it is felt within `fast_off` of its force until that is blended out.
void drag_god_flat(GodWatch& watch, test::GodScene& scene, double width_m, double yaw,
                   double fast_off) {
    const Quaternion held = compute_exp(Vector3(0.0, yaw, 0.0));
    const double rest_m = 0.5 * kGodCube_m + kGodGap_m;
    const Vector3 wanted_N(0.0, kGodStiffness_N_per_m * 0.004, 0.0);
    scene.god.place({Vector3(0.0, 0.1, 0.0), held});
    for (int i = 0; i < kBlended + 900; ++i) {
        const int k = std::max(0, i - kBlended);
        const double reach_m = k < 400 ? 15.0 * width_m : 0.06;
        const ToolFelt felt =
            watch.step({Vector3(reach_m * std::sin(0.05 * k), rest_m - 0.004, 0.0), held});
        if (i >= kBlended) {
            const double off_N = k < 400 ? kExact_N : fast_off * wanted_N.norm() + kExact_N;
            watch.demand_felt(felt, wanted_N, off_N);
            watch.demand(felt.felt_W.torque.norm() / (kGodCube_m * off_N));
        }
    }
}

Finding drag_god_over_slivers(double width_m, double fast_off) {
    test::GodScene scene(make_god_cube(), {make_sliver_floor(width_m)}, of_god_cube());
    GodWatch watch(scene);
    drag_god_flat(watch, scene, width_m, 0.0, fast_off);
    drag_god_flat(watch, scene, width_m, 0.4, fast_off);
    // Tumbled over them by an edge and a corner.
    for (int i = 0; i < 1500; ++i) {
        (void)watch.step({Vector3(0.05 * std::sin(0.004 * i), 0.02, 0.02 * std::sin(0.003 * i)),
                          compute_exp(Vector3(0.004 * i, 0.002 * i, 0.003 * i))});
    }
    watch.demand_free(Pose::at({0.0, 0.2, 0.0}));
    return watch.judge();
}

// Two bars of one mesh that cross: in the corner between them both are felt by their depth.
Finding press_god_where_bars_cross() {
    const TriangleMesh bars = join_meshes({{make_box({0.6, 0.1, 0.4}).value(), {}},
                                           {make_box({0.1, 0.6, 0.4}).value(), {}}})
                                  .value();
    test::GodScene scene(make_god_cube(), {bars}, of_god_cube());
    GodWatch watch(scene);
    const double rest_m = 0.05 + 0.5 * kGodCube_m + kGodGap_m;
    const Vector3 corner(rest_m, rest_m, 0.0);
    scene.god.place(Pose::at(corner + Vector3(0.01, 0.01, 0.0)));
    for (int i = 0; i < kBlended + 400; ++i) {
        const int k = std::max(0, i - kBlended);
        const Vector3 depth(0.003 + 0.001 * std::sin(0.07 * k), 0.004 + 0.002 * std::cos(0.05 * k),
                            -0.05 * std::sin(0.02 * k));
        const ToolFelt felt = watch.step(Pose::at(corner - depth));
        if (i >= kBlended) {
            watch.demand_felt(felt, kGodStiffness_N_per_m * Vector3(depth.x(), depth.y(), 0.0));
            watch.demand(felt.felt_W.torque.norm() / kExact_N);
        }
    }
    Random random(81);
    Pose handle = Pose::at(corner);
    for (int i = 0; i < 3000; ++i) {
        handle.position += 0.004 * random.in_cube() - 0.05 * (handle.position - corner);
        handle.orientation =
            (compute_exp(0.03 * random.in_cube()) * handle.orientation).normalized();
        (void)watch.step_without_gain(handle);
    }
    for (int i = 0; i < 100; ++i) {
        (void)watch.step(Pose::at(corner + Vector3(0.002, 0.002, 0.0) * i));
    }
    watch.demand_free(Pose::at(corner + Vector3(0.2, 0.2, 0.0)));
    return watch.judge();
}

const HardCase kGroove{{"god-object in a groove of 10 degrees",
                        "pressed, swayed, turned, drawn out", kGodMeasured, "",
                        [] { return press_god_into_groove(10.0, 1); }}};
const HardCase kNarrow{{"god-object in a groove of 2 degrees", "pressed, swayed, turned, drawn out",
                        kGodMeasured, "", [] { return press_god_into_groove(2.0, 7); }}};
const HardCase kSlivers{{"god-object over slivers of 10 um", "half a metre long, at up to 3 m/s",
                         kGodMeasured, "", [] { return drag_god_over_slivers(1.0e-5, 0.0); }}};
const HardCase kThinnest{{"god-object over slivers of 1 um",
                          "the same; fast, the force is within 3 %", kGodMeasured, "",
                          [] { return drag_god_over_slivers(1.0e-6, 0.03); }}};
const HardCase kCrossing{{"god-object on a mesh that passes through itself",
                          "in the corner of two bars that cross", kGodMeasured, "",
                          press_god_where_bars_cross}};
}  // namespace
}  // namespace fulcrum::stability
