// A tool that never enters anything (god_object_tool.h) where that is hardest: wedged by a torque, on a thousand contacts at once, between sheets, spun
// in a cage, on meshes that are broken, met at 5 m/s, far from the origin, of any size, and left without a step for 200 ms.
#include "haptics/math/rotation.h"
#include "tests/stability/cases/god_watch.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/wander.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fulcrum::stability {
namespace {

Finding spin_god_in_cage() {
    // A cube in a box of 56 mm: its diagonal is 69.
    constexpr double kCage_m = 0.056;
    test::GodScene scene(make_god_cube(),
                         {make_inverted(make_box(Vector3::Constant(kCage_m)).value()).value()},
                         of_god_cube());
    GodWatch watch(scene);
    scene.god.place(Pose{});
    Pose handle{};
    for (int i = 0; i < 1500; ++i) {
        const Vector3 axis = Vector3(std::sin(0.002 * i), std::cos(0.003 * i), 0.4).normalized();
        handle.orientation =
            (compute_exp(20.0 * test::kGodDt_s * axis) * handle.orientation).normalized();
        handle.position = 0.01 * Vector3(std::sin(0.05 * i), std::sin(0.031 * i), 0.0);
        (void)watch.step(handle);
        watch.demand(scene.god.centre_W().cwiseAbs().maxCoeff() / (0.5 * kCage_m));
    }
    watch.demand(watch.most_N() > 0.1);
    watch.demand(watch.most_N() / (kGodStiffness_N_per_m * 0.05));
    return watch.judge();
}

Finding slide_god_between_sheets() {
    constexpr double kRoom_m = 2.0e-5;
    const TriangleMesh sheet = make_plate(0.1, 0.1, 6).value();
    test::GodScene scene(make_plate(0.04, 0.04, 5).value(), {sheet, sheet}, of_god_cube());
    GodWatch watch(scene);
    scene.frames[0].pose_W = Pose::at({0.0, -0.5 * kRoom_m, 0.0});
    scene.frames[1].pose_W = Pose::at({0.0, 0.5 * kRoom_m, 0.0});
    scene.god.place(Pose::at({0.1, 0.0, 0.0}));
    for (int i = 0; i < 800; ++i) {
        const double in = std::min(0.003 * i, 1.0);
        const Pose pressed{Vector3(0.1 * (1.0 - in), 0.002 * std::sin(0.05 * i), 0.0),
                           compute_exp(Vector3(0.1 * in * std::sin(0.03 * i), 0.3 * in, 0.0))};
        (void)watch.step(i < 300 ? Pose::at({0.1 * (1.0 - in), 0.0, 0.0}) : pressed);
        watch.demand(std::abs(scene.god.centre_W().y()) / (0.5 * kRoom_m));
    }
    // It has arrived, and lies along them.
    watch.demand(std::abs(scene.god.centre_W().x()) / 1.0e-4);
    watch.demand(std::abs(find_way(Pose{}, scene.god.pose_W())[3]) / 1.1e-3);
    return watch.judge();
}

Finding rest_god_on_a_thousand() {
    // The corners of loose triangles over a floor.
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    constexpr int kN = 19;
    for (int i = 0; i < kN * kN; ++i) {
        const Vector3 at(0.002 * (i % kN) - 0.019, 0.0,
                         0.002 * static_cast<double>(i / kN) - 0.019);
        const auto first = static_cast<std::int32_t>(vertices.size());
        vertices.insert(vertices.end(),
                        {at, at + Vector3(0.001, 0.0, 0.0), at + Vector3(0.0, 0.0, 0.001)});
        triangles.push_back({first, first + 2, first + 1});
    }
    test::GodScene scene(TriangleMesh::build(vertices, triangles).value(),
                         {make_plate(0.3, 0.3, 3).value()}, of_god_cube());
    GodWatch watch(scene);
    scene.god.place(Pose::at({0.0, 0.001, 0.0}));
    for (int i = 0; i < 60; ++i) {
        const ToolFelt felt = watch.step(Pose::at({0.0001 * i, -0.002, 0.0}));
        if (i > 30) {
            const Vector3 wanted_N(0.0, kGodStiffness_N_per_m * (0.002 + kGodGap_m), 0.0);
            watch.demand(scene.god.last_step().contacts >= 3 * kN * kN);
            // By the contacts alone: what is felt of them comes little by little.
            const Wrench& pushed_W = scene.god.touches()[0].wrench_W;
            watch.demand((pushed_W.force - wanted_N).norm() / kExact_N);
            watch.demand(pushed_W.torque.norm() / kExact_N);
            watch.demand(felt.felt_W.force.norm() <= wanted_N.norm() + kExact_N);
        }
    }
    return watch.judge();
}

// Round and round over all of it, from above, pressed 1 cm deep.
Finding feel_broken_mesh(const TriangleMesh& broken) {
    test::GodScene scene(make_god_cube(), {broken}, of_god_cube());
    GodWatch watch(scene);
    scene.god.place(Pose::at({0.0, 0.08, 0.0}));
    Random random(2);
    Vector3 about(0.0, 0.05, 0.0);
    for (int i = 0; i < 400; ++i) {
        about = 0.03 * (about + 0.004 * random.in_cube()).normalized();
        (void)watch.step({i < 30 ? Vector3(0.0, 0.08 - 0.0015 * i, 0.0) : about,
                          compute_exp(Vector3(0.002 * i, 0.001 * i, 0.0))});
        watch.demand(scene.god.centre_W().norm() > 0.04);
    }
    watch.demand(watch.n_touching() > 300);
    return watch.judge();
}

TriangleMesh make_ball_to_break() {
    return make_bumpy_sphere(0.04, 5, 0.15, 80.0).value();
}

Finding wedge_god_by_torque() {
    const Vector3 size(0.028, 0.028, 0.1);
    test::GodScene scene(make_box(size).value(),
                         {test::make_block_with_hole(8, 0.0205, 0.06, 0.04)},
                         test::make_god_settings(make_box_inertia(0.1, size)));
    GodWatch watch(scene);
    scene.god.place(Pose{});
    const Quaternion askew = compute_exp(Vector3(0.6, 0.2, 0.0));
    const auto held = [&](int i) {
        return Pose{Vector3(0.0, 0.0, 0.004 * std::sin(0.1 * i)), askew};
    };
    ToolFelt felt;
    for (int i = 0; i < 300; ++i) {
        felt = watch.step(held(i));
    }
    watch.demand(felt.felt_W.torque.norm() > 0.02);
    // Held as it stands, the same again and again.
    const Pose wedged = scene.god.pose_W();
    for (int i = 0; i < 100; ++i) {
        felt = watch.step(held(299));
    }
    watch.demand(find_way(wedged, scene.god.pose_W()).norm() / 2.0e-3);
    // The torque lets go: it slides out.
    for (int i = 0; i < 100; ++i) {
        felt = watch.step(Pose::at({0.0, 0.0, 0.002 * i}));
    }
    watch.demand(scene.god.centre_W().z() > 0.19);
    watch.demand(felt.felt_W.force.norm() / 1.0e-9);
    return watch.judge();
}

// A sheet without thickness flies at 5 m/s into a tool that stands, and takes it along; turned against the sheet, as it strikes first with a corner.
Finding strike_god_by_sheet() {
    const TriangleMesh sheet = make_plate(0.2, 0.2, 4).value();
    test::GodScene scene(make_god_cube(), {sheet}, of_god_cube());
    GodWatch watch(scene);
    Random random(5);
    for (int k = 0; k < 20; ++k) {
        const Pose handle{Vector3::Zero(), random.turn(3.0)};
        scene.frames[0].pose_W = {Vector3(0.0, -0.05 - 0.0002 * k, 0.0),
                                  compute_exp(Vector3(0.1 * random.uniform(), 0.0, 0.0))};
        scene.god.place(handle);
        for (int i = 0; i < 40; ++i) {
            scene.frames[0].pose_W.position.y() += 5.0 * test::kGodDt_s;
            (void)watch.step(handle);
        }
        // It is on the same side as before.
        const Pose& sheet_W = scene.frames[0].pose_W;
        watch.demand((sheet_W.inverse() * scene.god.pose_W()).position.y() > 0.0);
        watch.demand(!scene.god.last_step().wedged);
    }
    watch.demand(watch.n_touching() > 20 * 20);
    return watch.judge();
}

// The force on a floor, exactly, with all lengths times `size`, and the whole scene at `origin`.
Finding press_god_at(double size, const Vector3& origin) {
    GodObjectSettings settings =
        test::make_god_settings(make_box_inertia(0.05, Vector3::Constant(kGodCube_m * size)));
    settings.gap_m = std::clamp(kGodGap_m * size, 1.0e-8, 1.0e-3);
    test::GodScene scene(make_box(Vector3::Constant(kGodCube_m * size)).value(),
                         {make_box(Vector3(0.5, 0.1, 0.5) * size).value()}, settings);
    GodWatch watch(scene, settings.gap_m);
    const double rests_m = (0.05 + 0.5 * kGodCube_m) * size + settings.gap_m;
    const auto at = [&](double x, double above) {
        return Pose::at(origin + Vector3(x * size, rests_m + above * size, 0.0));
    };
    scene.frames[0].pose_W = Pose::at(origin);
    scene.god.place(at(0.0, 0.01));
    for (int i = 0; i < kBlended + 100; ++i) {
        const double deep = 0.005 * std::min(1.0, 0.02 * i);
        const ToolFelt felt = watch.step(at(0.0001 * i, 0.005 - 2.0 * deep));
        if (i >= kBlended) {
            const double wanted_N = kGodStiffness_N_per_m * 0.005 * size;
            watch.demand_felt(felt, {0.0, wanted_N, 0.0}, 1.0e-6 * wanted_N);
        }
    }
    return watch.judge();
}

Finding press_god_at_all_sizes() {
    Finding all{0.0, 1.0, {}};
    for (const double size : {1.0e-2, 1.0e-1, 1.0, 1.0e1, 1.0e2, 1.0e3}) {
        const Finding one = press_god_at(size, Vector3::Zero());
        all.worst = worse(all.worst, one.worst);
        all.note = one.note;
    }
    return all;
}

// No step for 200 ms while the hand slides over a block and off its edge: the force goes on by the last step's contacts.
Finding stall_god() {
    test::GodScene scene(make_god_cube(), {make_box({0.1, 0.04, 0.1}).value()}, of_god_cube());
    GodWatch watch(scene);
    const double on_m = 0.02 + 0.5 * kGodCube_m + kGodGap_m;
    scene.god.place(Pose::at({-0.03, on_m + 0.005, 0.0}));
    Vector3 last_N = Vector3::Zero();
    for (int i = 1; i <= 1400; ++i) {
        const double t_s = i * test::kGodDt_s;
        const double down = std::min(1.0, t_s / 0.3) - std::clamp((t_s - 0.9) / 0.3, 0.0, 1.0);
        const Pose handle = Pose::at({-0.03 + 0.12 * std::clamp((t_s - 0.3) / 0.5, 0.0, 1.0),
                                      on_m + 0.005 - 0.01 * down, 0.0});
        const bool stalls = t_s >= 0.5 && t_s <= 0.7;
        const Vector3 now_N =
            stalls ? scene.god.force(handle).force : watch.step(handle).felt_W.force;
        // While it stalls the tool goes on as its contacts allow, so only what presses on them is felt.
        if (stalls) {
            watch.demand((now_N - last_N).norm() / 0.1);
            watch.demand(std::abs(now_N.y() - kGodStiffness_N_per_m * 0.005 * (2.0 * down - 1.0)) /
                         0.1);
        }
        last_N = now_N;
    }
    watch.demand(last_N.norm() / 1.0e-9);
    return watch.judge();
}

const HardCase kCage{{"god-object spun in a cage", "20 rad/s in a box narrower than its diagonal",
                      kGodMeasured, "", spin_god_in_cage}};
const HardCase kSheets{{"god-object sheet between two sheets", "no thickness, 20 um of room",
                        kGodMeasured, "", slide_god_between_sheets}};
const HardCase kThousand{{"god-object on a thousand contacts",
                          "the force of three, to a millionth of a newton", kGodMeasured, "",
                          rest_god_on_a_thousand}};
const HardCase kFlipped{{"god-object on flipped and doubled triangles",
                         "and triangles without area, nothing welded", kGodMeasured, "", [] {
                             return feel_broken_mesh(make_messy(make_ball_to_break(), 0.0).value());
                         }}};
const HardCase kCracks{
    {"god-object over cracks of 0.1 mm", "a seam left open", kGodMeasured, "",
     [] { return feel_broken_mesh(make_cracked(make_ball_to_break(), 1.0e-4, 3, 0.0).value()); }}};
const HardCase kTs{
    {"god-object over T-junctions", "one in every third triangle", kGodMeasured, "",
     [] { return feel_broken_mesh(make_t_junctions(make_ball_to_break()).value()); }}};
const HardCase kWedged{{"god-object peg wedged by a torque", "holds, lets go, slides out",
                        kGodMeasured, "", wedge_god_by_torque}};
const HardCase kStruck{{"god-object struck by a sheet at 5 m/s",
                        "without thickness, 20 times from any side", kGodMeasured, "",
                        strike_god_by_sheet}};
const HardCase kFar{{"god-object 10 km from the origin", "pressed and dragged, force to 1e-6",
                     kGodMeasured, "", [] {
                         return press_god_at(1.0, {1.0e4, -3.0e3, 2.0e3});
                     }}};
const HardCase kSizes{{"god-object in scenes scaled by 1e-2 to 1e3",
                       "pressed and dragged, force to 1e-6", kGodMeasured, "",
                       press_god_at_all_sizes}};
const HardCase kStalled{{"god-object while its steps stall",
                         "200 ms of the force alone, over an edge", kGodMeasured, "", stall_god}};

}  // namespace
}  // namespace fulcrum::stability
