// An implicit penalty tool (implicit_penalty.h) whose contact is found in distance fields of meshes that are hard: with cracks, T-junctions, flipped
// and doubled faces, slivers, through themselves, and with a groove of 2 degrees.
//
// What is guaranteed then: the force stays within its limits, no energy is given, and free space is free. Sides go by the winding number,
// so cracks narrower than a cell and doubled faces, of which some are flipped, change the force little: each case says how much. A face of
// a single layer that is flipped makes a pocket as deep as it is long, and the tool is held by what lies round it.
#include "tests/stability/cases/penalty_watch.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/join_meshes.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace fulcrum::stability {
namespace {

constexpr double kBall_m = 0.04;
constexpr double kBringsAlong_J = 2.0e-4;  // 50 g at 9 cm/s

TriangleMesh make_bumpy_ball() {
    return make_bumpy_sphere(kBall_m, 8, 0.1, 60.0).value();
}

// Every so many-th triangle is turned over, and nothing lies behind it.
TriangleMesh make_flipped(const TriangleMesh& mesh, std::size_t every) {
    std::vector<TriangleCorners> triangles = mesh.triangles();
    for (std::size_t i = 0; i < triangles.size(); i += every) {
        std::swap(triangles[i][1], triangles[i][2]);
    }
    return TriangleMesh::build(mesh.vertices_B(), std::move(triangles)).value();
}

// A cube comes down on a ball, goes round it, pressed by 5 mm and more, and away.
struct RoundBall {
    std::vector<Vector3> felt_N;
    std::vector<double> away_m;  // of the cube's middle from the ball's
    Finding finding;
};

RoundBall go_round(const TriangleMesh& ball) {
    const Vector3 size(0.03, 0.03, 0.03);
    PenaltyWatch watch({make_box(size).value(), make_box_inertia(0.05, size), 0.002, {ball}});
    constexpr int kSteps = 4000;
    const auto handle = [](int i) {
        const double share = static_cast<double>(i) / kSteps;
        const double down =
            std::clamp(5.0 * share, 0.0, 1.0) - std::clamp(5.0 * share - 4.0, 0.0, 1.0);
        const double round = 2.0 * std::numbers::pi * std::clamp(1.6 * share - 0.32, 0.0, 0.96);
        return hold_over_ball(down, round);
    };
    watch.place(handle(0));
    RoundBall course;
    for (int i = 1; i <= kSteps; ++i) {
        course.felt_N.push_back(watch.step(handle(i)).felt_W.force);
        course.away_m.push_back(watch.tool().centre_W().norm());
    }
    watch.demand(watch.n_touching() > kSteps / 2);
    watch.demand(course.felt_N.back() == Vector3::Zero());
    course.finding = watch.judge(kBringsAlong_J);
    return course;
}

// How far forces are off: the root of the mean square, and the most.
struct Off {
    double mean_N = 0.0;
    double most_N = 0.0;
};

Off compare_forces(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
    Off off;
    for (std::size_t i = 0; i < a.size(); ++i) {
        off.mean_N += (a[i] - b[i]).squaredNorm() / static_cast<double>(a.size());
        off.most_N = worse(off.most_N, (a[i] - b[i]).norm());
    }
    off.mean_N = std::sqrt(off.mean_N);
    return off;
}

// Beside the whole ball: how far the force is off, and how much nearer to the middle the cube comes.
Finding compare_broken(const TriangleMesh& broken, double most_off_N, double most_nearer_m) {
    const RoundBall whole = go_round(make_bumpy_ball());
    const RoundBall other = go_round(broken);
    const Off off = compare_forces(whole.felt_N, other.felt_N);
    double nearer_m = 0.0;
    for (std::size_t i = 0; i < whole.away_m.size(); ++i) {
        nearer_m = worse(nearer_m, whole.away_m[i] - other.away_m[i]);
    }
    double worst = worse(worse(whole.finding.worst, other.finding.worst), off.mean_N / most_off_N);
    worst = worse(worst, nearer_m / most_nearer_m);
    return {worst, 1.0,
            other.finding.note +
                describe("; beside the whole ball off by %.2g N, at most %.2g N, nearer by %.2g mm",
                         off.mean_N, off.most_N, 1.0e3 * nearer_m)};
}

// A bar of 20 mm with a band of slivers, each a micrometre wide, along the middle of each side.
TriangleMesh make_slivered_bar() {
    return make_prism(make_slivered_square(0.01), 0.06).value();
}

// Bar on bar, crosswise, rubbed: the force is the clean bars' own.
Finding rub_slivers() {
    const TriangleMesh clean = make_box({0.02, 0.02, 0.06}).value();
    const TriangleMesh slivered = make_slivered_bar();
    std::vector<std::vector<Vector3>> felt_N;
    Finding all{0.0, 1.0, {}};
    for (const auto* bar : {&clean, &slivered}) {
        PenaltyWatch watch({*bar, make_box_inertia(0.05, {0.02, 0.02, 0.06}), 0.001, {*bar}});
        const Quaternion across = compute_exp(Vector3(0.0, 0.5 * std::numbers::pi, 0.0));
        watch.place({{0.0, 0.03, 0.0}, across});
        felt_N.emplace_back();
        for (int i = 1; i <= 2500; ++i) {
            const double down = std::min(1.0, i / 500.0) - std::clamp(i / 500.0 - 4.0, 0.0, 1.0);
            const Vector3 rub(0.004 * std::sin(0.005 * i), 0.0, 0.01 * std::sin(0.004 * i));
            felt_N.back().push_back(
                watch.step(Pose{rub + Vector3(0.0, 0.03 - 0.018 * down, 0.0), across})
                    .felt_W.force);
        }
        watch.demand(felt_N.back().back() == Vector3::Zero());
        watch.demand(watch.n_touching() > 1000);
        const Finding one = watch.judge(kBringsAlong_J);
        all = {worse(all.worst, one.worst), 1.0, one.note};
    }
    const Off off = compare_forces(felt_N[0], felt_N[1]);
    constexpr double kOff_N = 0.2;  // points lie elsewhere on the slivered one
    return {worse(all.worst, off.mean_N / kOff_N), 1.0,
            all.note + describe("; off the clean bars' by %.2g N, at most %.2g N", off.mean_N,
                                off.most_N)};
}

// Two bars that pass through each other, told as one body; a cube is pressed into the corner between them, and drawn along both.
Finding press_between_crossing_bars() {
    const TriangleMesh cross = join_meshes({{make_box({0.12, 0.03, 0.06}).value(), {}},
                                            {make_box({0.03, 0.12, 0.06}).value(), {}}})
                                   .value();
    const Vector3 size(0.02, 0.02, 0.02);
    PenaltyWatch watch({make_box(size).value(), make_box_inertia(0.05, size), 0.002, {cross}});
    const double corner_m = 0.025;
    watch.place(Pose::at({0.045, 0.045, 0.0}));
    for (int i = 1; i <= 3000; ++i) {
        const double in = std::min(1.0, i / 500.0) - std::clamp(i / 500.0 - 5.0, 0.0, 1.0);
        const Vector3 sway(0.006 * std::sin(0.01 * i), 0.006 * std::sin(0.007 * i), 0.0);
        const Vector3 at = Vector3(0.045, 0.045, 0.0) + in * (Vector3(-0.026, -0.026, 0.0) + sway);
        const ToolFelt felt = watch.step(Pose::at(at));
        // Never deeper in either than what presses it is worth, a layer.
        watch.demand((corner_m - watch.tool().centre_W().head<2>().minCoeff()) / 5.0e-4);
        if (i == 3000) {
            watch.demand(felt.felt_W.force == Vector3::Zero());
        }
    }
    watch.demand(watch.n_touching() > 1500);
    return watch.judge(kBringsAlong_J);
}

// A blade of 2 mm driven into a groove of 2 degrees, which is as wide as it 57 mm above the bottom; and drawn out again.
Finding drive_into_groove() {
    const double half = std::numbers::pi / 180.0;
    std::vector<std::pair<TriangleMesh, Pose>> plates;
    for (const double side : {-1.0, 1.0}) {
        const Quaternion turn = compute_exp({0.0, 0.0, -side * half});
        // The inner face of each runs through the origin.
        plates.emplace_back(make_box({0.01, 0.12, 0.06}).value(),
                            Pose{turn * Vector3(side * 0.005, 0.06, 0.0), turn});
    }
    const Vector3 size(0.002, 0.03, 0.03);
    PenaltyWatch watch({make_box(size).value(),
                        make_box_inertia(0.05, size),
                        0.001,
                        {join_meshes(plates).value()}});
    const auto handle = [](int i) {
        const double in = std::min(1.0, i / 2000.0) - std::clamp(i / 1000.0 - 3.0, 0.0, 1.0);
        return Pose::at({0.0, 0.15 - 0.11 * in, 0.0});
    };
    watch.place(handle(0));
    double deepest_m = 1.0;
    double speed_m_per_s = 0.0;
    Vector3 felt_N;
    for (int i = 1; i <= 5000; ++i) {
        felt_N = watch.step(handle(i)).felt_W.force;
        deepest_m = std::min(deepest_m, watch.tool().centre_W().y());
        speed_m_per_s =
            i > 2700 && i <= 3000 ? worse(speed_m_per_s, watch.speed_m_per_s()) : speed_m_per_s;
    }
    // Wedged it stands, no deeper than both walls, each pushed in by 5 N / (2 tan 1 degree) over many contacts, let it; and it comes out.
    watch.demand(speed_m_per_s / 1.0e-3);
    watch.demand(deepest_m > 0.04);
    watch.demand(felt_N == Vector3::Zero());
    watch.demand(watch.n_touching() > 1500);
    return watch.judge(kBringsAlong_J);
}

// By fields; those of the same names by levels are in penalty_tool.cpp.
const HardCase kCracks{{"penalty cube round cracks of 0.1 mm", "a seam left open, cells of 2 mm",
                        kPenaltyMeasured, "", [] {
                            return compare_broken(
                                make_cracked(make_bumpy_ball(), 1.0e-4, 3, 0.0).value(), 0.2,
                                3.0e-4);
                        }}};
const HardCase kDoubled{
    {"penalty cube round flipped and doubled triangles",
     "and triangles without area, nothing welded", kPenaltyMeasured, "",
     [] { return compare_broken(make_messy(make_bumpy_ball(), 0.0).value(), 0.5, 1.0e-3); }}};
const HardCase kFlippedFaces{
    {"penalty cube round flipped faces", "every twentieth, with nothing behind it",
     kPenaltyMeasured, "",
     [] { return compare_broken(make_flipped(make_bumpy_ball(), 20), 0.5, 1.0e-3); }}};
const HardCase kTJunctions{
    {"penalty cube round T-junctions", "one in every third triangle", kPenaltyMeasured, "",
     [] { return compare_broken(make_t_junctions(make_bumpy_ball()).value(), 0.2, 3.0e-4); }}};
const HardCase kSlivers{{"penalty bar with slivers", "twenty of 1 um in the middle of each side",
                         kPenaltyMeasured, "", rub_slivers}};
const HardCase kThroughItself{{"penalty cube on a mesh through itself", "where two bars cross",
                               kPenaltyMeasured, "", press_between_crossing_bars}};
const HardCase kGroove{{"penalty blade in a groove of 2 degrees", "wedged, and drawn out again",
                        kPenaltyMeasured, "", drive_into_groove}};

}  // namespace
}  // namespace fulcrum::stability
