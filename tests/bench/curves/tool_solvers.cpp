// One scene by every way in which a tool can be kept outside: a block on a table, by the one word that a lesson changes. What the hand should feel is
// known in closed form: the coupling's spring, from where the hand is to where the block would lie on the table exactly.
#include "haptics/math/rotation.h"
#include "tests/bench/harness/csv.h"
#include "tests/bench/harness/measure.h"
#include "tests/bench/harness/registry.h"
#include "tests/support/tool_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace fulcrum::bench {
namespace {

constexpr double kDt_s = 0.001;
constexpr double kStiffness_N_per_m = 500.0;
constexpr double kPressed_m = 0.006;
constexpr double kMass_kg = 0.02;
const Vector3 kEdges_m(0.04, 0.02, 0.03);
const double kOnEdge_rad =
    std::atan2(kEdges_m.x(), kEdges_m.y());                 // an edge right below the middle
const MovingFrame kTable{Pose::at({0.0, -0.02, 0.0}), {}};  // its top is y = 0

struct Solver {
    const char* name;
    ToolMethod method;
    ToolMass mass = ToolMass::massive;
    double round_s = 0.0;  // of the contact thread
    ContactFinding contact = ContactFinding::fields;
};
const std::vector<Solver> kSolvers{
    {"field_sampling", ToolMethod::field_sampling},
    {"field_sampling, massless", ToolMethod::field_sampling, ToolMass::massless},
    {"voxel_sampling", ToolMethod::voxel_sampling},
    {"voxel_sampling, massless", ToolMethod::voxel_sampling, ToolMass::massless},
    {"implicit_penalty", ToolMethod::implicit_penalty},
    {"implicit_penalty, contact found 100 times a second", ToolMethod::implicit_penalty,
     ToolMass::massive, 0.01},
    {"implicit_penalty, contact by levels", ToolMethod::implicit_penalty, ToolMass::massive, 0.0,
     ContactFinding::levels},
    {"god_object", ToolMethod::god_object}};

struct Setting {
    double stiffness_N_per_m = kStiffness_N_per_m;
    double mass_kg = kMass_kg;
    bool silent = true;
};

// Of the lecture's four: are constraints soft, so that the tool may go in, or hard; has the tool a mass? A body of the world that a hand grips is
// the fourth, hard and massive (dynamics/hand_rows.h).
std::string find_quadrant(const Solver& solver) {
    if (solver.method == ToolMethod::god_object) {
        return "hard, massless";
    }
    return solver.mass == ToolMass::massless ? "soft, massless" : "soft, massive";
}

std::unique_ptr<ToolSolver> make_block(const Solver& solver, const Setting& setting) {
    test::ToolScene scene = test::make_ball_tool(solver.method);
    scene.tool = make_box(kEdges_m).value();
    scene.inertia = make_box_inertia(setting.mass_kg, kEdges_m);
    scene.voxel_m = 0.002;
    scene.in_rows = true;
    scene.contact = solver.contact;
    scene.settings.mass = solver.mass;
    scene.settings.silent_in_free_space = setting.silent;
    scene.settings.coupling.shift.stiffness_N_per_m = setting.stiffness_N_per_m;
    scene.settings.coupling.turn.stiffness_Nm_per_rad = 1.0e-3 * setting.stiffness_N_per_m;
    ToolPlan plan = *test::make_tool_of(scene, {make_box({0.2, 0.04, 0.2}).value()});
    if (plan.penalty) {
        plan.penalty->round_s = solver.round_s;
    }
    return make_tool(plan);
}

double find_depth_m(const ToolSolver& tool) {
    double lowest_m = 0.0;
    for (int i = 0; i < 8; ++i) {
        const Vector3 corner(i % 2 == 0 ? 0.5 : -0.5, i / 2 % 2 == 0 ? 0.5 : -0.5,
                             i / 4 == 0 ? 0.5 : -0.5);
        lowest_m = std::min(lowest_m, (tool.grip_W() * corner.cwiseProduct(kEdges_m)).y());
    }
    return -lowest_m;
}

struct Pressed {
    double error = 0.0;  // of the felt force's size, when at rest
    double ripple =
        0.0;  // between the least and the greatest force of the last tenth of a second, over their mean
    double depth_m = 0.0;
    bool moved = true;
};

// The hand comes down in 0.3 s, turned about z by that, to `pressed_m` deeper than the table lets the block, and rests.
Pressed press(ToolSolver& tool, double turn_rad, const Setting& setting, double pressed_m) {
    const double half_m =
        0.5 * (kEdges_m.y() * std::cos(turn_rad) + kEdges_m.x() * std::sin(turn_rad));
    const Quaternion turn = compute_exp(Vector3(0.0, 0.0, turn_rad));
    Pressed pressed;
    double least_N = 1.0e9;
    double most_N = 0.0;
    tool.place({Vector3(0.0, half_m + 0.02, 0.0), turn});
    for (int i = 1; i <= 1000; ++i) {
        const double down = std::min(1.0, i / 300.0);
        const Vector3 at(0.0, half_m + 0.02 - (0.02 + pressed_m) * down, 0.0);
        const ToolFelt felt = tool.move({{at, turn}, {}}, {&kTable, 1}, i * kDt_s, kDt_s);
        pressed.moved = pressed.moved && felt.moved && felt.felt_W.force.allFinite();
        pressed.depth_m = std::max(pressed.depth_m, find_depth_m(tool));
        if (i > 900) {
            least_N = std::min(least_N, felt.felt_W.force.norm());
            most_N = std::max(most_N, felt.felt_W.force.norm());
        }
    }
    const double ideal_N = setting.stiffness_N_per_m * pressed_m;
    const double mean_N = 0.5 * (least_N + most_N);
    pressed.error = std::abs(mean_N - ideal_N) / ideal_N;
    pressed.ripple = mean_N > 0.0 ? (most_N - least_N) / mean_N : HUGE_VAL;
    return pressed;
}

// Pressed flat and drawn along at 5 cm/s: the share of the force that holds it back, where nothing should.
struct Drawn {
    double drag = 0.0;
    Cost cost;
};
Drawn draw(const Solver& solver, double seconds) {
    const std::unique_ptr<ToolSolver> tool = make_block(solver, {});
    tool->place(Pose::at({-0.04, 0.02, 0.0}));
    Drawn drawn;
    std::vector<double> us;
    double along_N = 0.0;
    double down_N = 0.0;
    const int n = static_cast<int>(seconds * 1000.0);
    for (int i = 1; i <= n; ++i) {
        const double down_m = std::min(1.0, i / 300.0) * (0.01 + kPressed_m);
        // To and fro.
        const double phase = 2.0 * std::numbers::pi * 0.2 * std::max(0, i - 300) * kDt_s;
        const Vector3 at(-0.04 * std::cos(phase), 0.02 - down_m, 0.0);
        const Vector3 v(0.04 * 2.0 * std::numbers::pi * 0.2 * std::sin(phase), 0.0, 0.0);
        ToolFelt felt;
        const Took took = time_once([&] {
            felt = tool->move({Pose::at(at), {v, {}}}, {&kTable, 1}, i * kDt_s, kDt_s);
        });
        us.push_back(took.clock_us);
        if (i > 400 && std::abs(v.x()) > 0.02) {
            along_N += std::abs(felt.felt_W.force.x());
            down_N += std::abs(felt.felt_W.force.y());
        }
    }
    drawn.drag = along_N / down_N;
    drawn.cost = summarise(std::move(us));
    return drawn;
}

// What is felt of it in free air at 10 m/s^2, if nothing hides it; kilograms.
double find_felt_mass_kg(const Solver& solver) {
    constexpr double kPace_m_per_s2 = 10.0;
    const std::unique_ptr<ToolSolver> tool = make_block(solver, {.silent = false});
    tool->place(Pose::at({0.0, 1.0, 0.0}));
    ToolFelt felt;
    for (int i = 1; i <= 300; ++i) {
        const double t_s = i * kDt_s;
        felt = tool->move({Pose::at({0.5 * kPace_m_per_s2 * t_s * t_s, 1.0, 0.0}),
                           {{kPace_m_per_s2 * t_s, 0.0, 0.0}, {}}},
                          {&kTable, 1}, t_s, kDt_s);
    }
    return felt.felt_W.force.norm() / kPace_m_per_s2;
}

// The stiffest coupling of those tried, each twice the last, up to which a tool of 10 g rests on the table without a ripple of a hundredth.
double find_stiffest_N_per_m(const Solver& solver) {
    double stiffest = kNone;
    for (double k = 125.0; k <= 64000.0; k *= 2.0) {
        const Setting setting{.stiffness_N_per_m = k, .mass_kg = 0.01};
        const std::unique_ptr<ToolSolver> tool = make_block(solver, setting);
        const Pressed pressed = press(*tool, 0.0, setting, 3.0 / k);
        if (!pressed.moved || !(pressed.ripple < 0.01)) {
            break;
        }
        stiffest = k;
    }
    return stiffest;
}

std::string percent(double share) {
    return to_text(std::round(1.0e4 * share) / 100.0);
}

Report run_tool_solvers(Run& run) {
    Sheet sheet;
    sheet.name = "tool-solvers";
    sheet.title = "One block on one table, by every solver";
    sheet.work =
        "A block of 4 x 2 x 3 cm, 20 g and 2000 points (among voxels one a voxel) on a coupling of "
        "500 N/m, voxels of 2 mm, "
        "pressed 6 mm too deep, flat and on its edge, and drawn along flat; the stiffest coupling "
        "is that of a tool of 10 g";
    sheet.advice =
        "field_sampling unless something speaks against it; implicit_penalty where contact is "
        "found late or the coupling is stiff; voxel_sampling for models that no field can be made "
        "of; massless where no inertia may be felt and jumps may.";
    sheet.columns = {
        "solver",      "quadrant",   "force off, flat, %",       "force off, on an edge, %",
        "deepest, mm", "drag, %",    "felt mass in free air, g", "step, median us",
        "99 %, us",    "memory, MB", "stiffest coupling, N/m"};
    for (const Solver& solver : kSolvers) {
        run.progress(static_cast<double>(sheet.rows.size()) / static_cast<double>(kSolvers.size()),
                     solver.name);
        const std::unique_ptr<ToolSolver> block = make_block(solver, {});
        const Pressed flat = press(*block, 0.0, {}, kPressed_m);
        const Pressed edge = press(*block, kOnEdge_rad, {}, kPressed_m);
        const Drawn drawn = draw(solver, run.pick(10.0, 2.0));
        const double stiffest = find_stiffest_N_per_m(solver);
        sheet.rows.push_back(
            {solver.name, find_quadrant(solver), percent(flat.error), percent(edge.error),
             to_text(std::round(1.0e5 * std::max(flat.depth_m, edge.depth_m)) / 100.0),
             percent(drawn.drag), to_text(std::round(1.0e4 * find_felt_mass_kg(solver)) / 10.0),
             to_text(drawn.cost.median_us), to_text(drawn.cost.p99_us),
             to_text(std::round(1.0e-4 * static_cast<double>(block->memory_bytes())) / 100.0),
             std::isfinite(stiffest) ? to_text(stiffest) : "none of those tried"});
    }
    return {sheet};
}

const Registration kToolSolvers{
    {"tool-solvers", "one scene by every way of keeping a tool outside: error, depth, mass, time",
     run_tool_solvers}};

}  // namespace
}  // namespace fulcrum::bench
