// A plate of many points pressed flat on a block, as a plan makes it: what a step of the tool takes without a budget, by how many
// points, and with one, at 1 and 4 kHz; how often it is late, by the clock and by its own work, and what error it accepts.
#include "tests/bench/harness/curve.h"
#include "tests/support/tool_scene.h"

namespace fulcrum::bench {
namespace {

constexpr double kTop_m = 0.02;
constexpr double kPlate_m = 0.08;
constexpr double kThick_m = 0.001;    // half of its points lie below
constexpr double kShareOfStep = 0.5;  // as a live run gives it

struct Setting {
    int n_points;
    double rate_hz;
    double budget_us;
};

std::unique_ptr<ToolSolver> make_plate(const Setting& setting) {
    test::ToolScene scene = test::make_ball_tool(ToolMethod::field_sampling);
    scene.tool = make_box({kPlate_m, kThick_m, kPlate_m}).value();
    scene.inertia.mass_kg = 0.03;
    scene.inertia.moments_kg_m2 = {1.6e-5, 3.2e-5, 1.6e-5};
    scene.voxel_m = 0.001;
    scene.n_points = setting.n_points;
    scene.settings.coupling.shift.stiffness_N_per_m = 500.0;
    scene.settings.coupling.turn.stiffness_Nm_per_rad = 1.0;
    scene.settings.budget_us = setting.budget_us;
    return make_tool(*test::make_tool_of(scene, {make_box({0.1, 2.0 * kTop_m, 0.1}).value()}));
}

// The hand comes down on the block, presses and rubs, with a tremor.
MovingFrame find_hand(double now_s) {
    const double down_m = std::min(0.02 * now_s, 4.0e-3) - 1.0e-3;
    const Vector3 at(0.004 * std::sin(9.0 * now_s), kTop_m + 0.5 * kThick_m - down_m,
                     2.0e-5 * std::sin(63.0 * now_s));
    const double askew = 0.003 * std::sin(5.0 * now_s);
    return {Pose{at, Quaternion(AngleAxis(askew, Vector3::UnitX()))}, {}};
}

struct Found {
    Cost cost;
    double most_us = 0.0;
    double n_late = 0.0, n_late_own = 0.0;
    double most_points = 0.0, most_looks = 0.0, most_error_N = 0.0;
    double n_cut = 0.0;
};

Found play(const Setting& setting, double seconds) {
    const std::unique_ptr<ToolSolver> tool = make_plate(setting);
    const double dt_s = 1.0 / setting.rate_hz;
    const std::vector<MovingFrame> objects(1);
    const double time_us = 1.0e6 * dt_s;
    tool->place(find_hand(0.0).pose_W);
    Found found;
    std::vector<double> us;
    const int n = static_cast<int>(seconds * setting.rate_hz);
    for (int i = 1; i <= n; ++i) {
        ToolFelt felt;
        const Took took =
            time_once([&] { felt = tool->move(find_hand(i * dt_s), objects, i * dt_s, dt_s); });
        us.push_back(took.clock_us);
        found.n_late += took.clock_us > time_us ? 1.0 : 0.0;
        found.n_late_own += took.own_us > time_us ? 1.0 : 0.0;
        found.most_points = std::max(found.most_points, static_cast<double>(felt.effort.n_points));
        found.most_looks = std::max(found.most_looks, static_cast<double>(felt.effort.n_looks));
        found.most_error_N = std::max(found.most_error_N, felt.effort.error_N);
        found.n_cut += felt.effort.in_time ? 0.0 : 1.0;
    }
    found.most_us = *std::max_element(us.begin(), us.end());
    found.cost = summarise(std::move(us));
    return found;
}

Report run_tool_time(Run& run) {
    Sheet sheet{
        "tool-time",
        "A tool that lies flat, and the time that a step has for it",
        "A plate of points pressed flat on a block of 1 mm voxels by 500 N/m and rubbed, half of "
        "its points touching; backward Euler. Late: longer than a step.",
        "A live run has the budget; without one give such a tool no more points than end in time.",
        {"points", "steps a second", "budget us", "median us", "99 % us", "most us", "steps late",
         "late by their own work", "steps", "most looks", "thousand points looked at, most",
         "out of time", "error accepted, most N"}};
    const double seconds = run.pick(1.5, 0.4);
    for (const int n_points : {2000, 8000, 20000, 50000}) {
        for (const double rate_hz : {1000.0, 4000.0}) {
            for (const double budget_us : {0.0, kShareOfStep * 1.0e6 / rate_hz}) {
                const Found found = play({n_points, rate_hz, budget_us}, seconds);
                sheet.add({n_points, rate_hz, budget_us, found.cost.median_us, found.cost.p99_us,
                           found.most_us, found.n_late, found.n_late_own,
                           std::round(seconds * rate_hz), found.most_looks,
                           1.0e-3 * found.most_points, found.n_cut, found.most_error_N});
            }
        }
        run.progress(n_points / 50000.0, std::to_string(n_points) + " points");
    }
    return {sheet};
}

const Registration kToolTime{
    {"tool-time", "a tool of many points lying flat, and the time of a step", run_tool_time}};

}  // namespace
}  // namespace fulcrum::bench
