#include "haptics/math/dense.h"
#include "haptics/math/rotation.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/peg_trial.h"
#include "tests/support/penetration_trial.h"
#include "tests/support/tool_scene.h"

#include <cstdio>

namespace fulcrum::bench {
namespace {

// What a step of the implicit tool takes in the haptic loop, by how many clusters hold it, while it slides: the newest contact model taken, the
// planes followed, coupling and contacts with their derivatives, as many linear solves as it makes, what is touched and felt. Contact
// is found anew before each step, which is timed apart.

constexpr double kStep_s = 1.0e-3;
constexpr int kPressed = 600;  // steps until it is down

ImplicitPenaltyTool make_pressed_tool(int most_clusters, int newton_iterations) {
    const Vector3 size(0.06, 0.03, 0.05);
    test::ToolScene scene{.tool = make_box(size).value(),
                          .inertia = make_box_inertia(0.01, size),
                          .method = ToolMethod::implicit_penalty,
                          .voxel_m = 0.003,
                          .n_points = 3000,
                          .most_force_N = 5.0};
    scene.settings.coupling.turn.stiffness_Nm_per_rad = 0.5;
    const auto plan = test::make_tool_of(scene, {make_box({0.4, 0.1, 0.4}).value()});
    ImplicitPenaltyPlan penalty;
    for (const FieldSamplingPlan& object :
         std::get<std::vector<FieldSamplingPlan>>(plan->objects)) {
        penalty.objects.push_back({object.field, object.shell});
    }
    penalty.settings.coupling = plan->settings.coupling;
    penalty.settings.inertia = plan->settings.inertia;
    penalty.settings.contacts = plan->penalty->contacts;
    penalty.settings.clusters = plan->penalty->clusters;
    penalty.settings.clusters.radius_m = 0.006;
    penalty.settings.clusters.most = most_clusters;
    penalty.settings.own_rounds = false;
    penalty.settings.newton_iterations = newton_iterations;
    return ImplicitPenaltyTool::build(penalty).value();
}

// Pressed 3 mm into the block's top, and slid, turned and tilted on it at up to 15 cm/s.
Pose find_place(int step) {
    const double t_s = kStep_s * step;
    const double share = std::min(1.0, step / (0.8 * kPressed));
    return {{0.02 * share * std::sin(5.0 * t_s), 0.08 - 0.018 * share,
             0.015 * share * std::cos(6.3 * t_s)},
            compute_exp(share * Vector3(0.02 * std::sin(7.0 * t_s), 0.3 * std::sin(3.0 * t_s),
                                        0.02 * std::sin(4.1 * t_s)))};
}

// With the speed that a loop finds.
MovingFrame find_hand(int step) {
    const Pose now = find_place(step);
    const Pose last = find_place(step - 1);
    return {now,
            {(now.position - last.position) / kStep_s,
             compute_log(now.orientation * last.orientation.conjugate()) / kStep_s}};
}

struct Found {
    double n_clusters = 0.0;  // the mean
    double n_solves = 0.0;    // the mean
    Cost cost;
    Cost round;
};

Found time_steps(int most_clusters, int newton_iterations, int n_steps) {
    ImplicitPenaltyTool tool = make_pressed_tool(most_clusters, newton_iterations);
    const MovingFrame object;
    tool.place(find_hand(0).pose_W);
    std::vector<double> us;
    std::vector<double> round_us;
    Found found;
    for (int i = 1; i <= kPressed + n_steps; ++i) {
        const double now_s = i * kStep_s;
        const Took round = time_once([&] { tool.contact_loop().step(now_s); });
        const MovingFrame hand = find_hand(i);
        ToolFelt felt;
        const Took took = time_once([&] {
            keep(felt = tool.move(hand, {&object, 1}, now_s, kStep_s));
        });
        if (i > kPressed) {
            us.push_back(took.own_us);
            round_us.push_back(round.own_us);
            found.n_clusters += static_cast<double>(tool.planes().size()) / n_steps;
            found.n_solves += static_cast<double>(felt.effort.n_looks) / n_steps;
        }
    }
    found.cost = summarise(std::move(us));
    found.round = summarise(std::move(round_us));
    return found;
}

// The least that an implicit step in six degrees of freedom can be: its linear system.
Cost time_solve(int n_steps) {
    Matrix6 A = Matrix6::Identity();
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            A(i, j) += 0.1 * std::sin(7.0 * i + j);
        }
    }
    const Vector6 b = Vector6::Ones();
    return measure_cost([&] { keep(solve_lu(A, b)); }, {.samples = n_steps});
}

Report run_penalty_step(Run& run) {
    Sheet sheet{
        "penalty-step",
        "A step of the implicit tool, by how many clusters of contact hold it",
        "A block of 10 g on 500 N/m pressed 3 mm into another, slid, turned and tilted at up to 15 "
        "cm/s. Contact is found anew before each step, as by a contact thread. Processor time of "
        "each step and of each round of contact, with one solve a step and with up to four. The "
        "last row is one solve of six equations alone.",
        "Ten clusters are enough for a tool that lies flat; twenty cost a microsecond more.",
        {"clusters, mean", "solves allowed", "solves a step", "step median us", "step 99 % us",
         "round median us", "round 99 % us"}};
    const int n_steps = static_cast<int>(run.pick(20000.0, 2000.0));
    for (const int most : {1, 3, 5, 10, 20, 32}) {
        for (const int newton : {1, 4}) {
            const Found found = time_steps(most, newton, n_steps);
            sheet.add({rounded(found.n_clusters, 2), newton, rounded(found.n_solves, 2),
                       found.cost.median_us, found.cost.p99_us, found.round.median_us,
                       found.round.p99_us});
        }
        run.progress(most / 32.0, std::to_string(most) + " clusters");
    }
    const Cost solve = time_solve(n_steps);
    sheet.add({"a solve alone", "", "1", solve.median_us, solve.p99_us, "", ""});
    return {sheet};
}

const Registration kPenaltyStep{
    {"penalty-step", "a step of the implicit tool by its clusters", run_penalty_step}};

// L14's table 2: the share of contact frames in which a point got past the layer that pushes, with and without brakes.

struct Variant {
    const char* name;
    PreContactBraking braking;
    bool lead_clamped;
};
const std::array<Variant, 4> kVariants{
    {{"none", PreContactBraking::off, false},
     {"viscous", PreContactBraking::viscous, false},
     {"one cycle", PreContactBraking::one_cycle, false},
     {"one cycle, the hand's motion clamped", PreContactBraking::one_cycle, true}}};

std::string to_ratio(double ratio) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1e", ratio);
    return text.data();
}

Report run_penetration_ratio(Run& run) {
    Sheet sheet{
        "penetration-ratio",
        "How often a fast tool gets past the layer that pushes",
        "A ring of 75 mm and 12 g swept by an arm against a plate and beams at 1 kHz, voxels of 5 "
        "mm, the pushing layer two voxels outside, at most 15 N felt, semi-implicit Euler. Ratio: "
        "frames with a point in an interior voxel over frames in contact. McNeely's own scene, "
        "hand and tool were others.",
        "Clamp the hand's motion with the springs near the object, as is the default: what passes "
        "is pulled through by the dampers. The one-cycle brakes adapt to speed and to the number "
        "of points.",
        {"hand at most m/s", "brakes", "penetrations", "contacts", "ratio", "passed"}};
    sheet.rows = {{"printed 1999", "none", "70", "69000", "1.0e-03", ""},
                  {"printed 1999", "with", "6", "108000", "5.6e-05", ""}};
    double done = 0.0;
    for (const double fastest_m_per_s : {1.0, 1.5, 2.0, 3.0}) {
        for (const Variant& variant : kVariants) {
            run.progress(done, variant.name);
            const test::PenetrationCount count =
                test::run_penetration_trial({variant.braking, variant.lead_clamped,
                                             run.pick(400'000, 40'000), fastest_m_per_s, 1});
            sheet.add({fastest_m_per_s, variant.name, count.n_penetrations, count.n_contacts,
                       to_ratio(count.ratio()), count.n_passed});
            done += 1.0 / 16.0;
        }
    }
    return {sheet};
}

const Registration kPenetrationRatio{
    {"penetration-ratio",
     "penetrations with and without pre-contact braking, as McNeely counted them",
     run_penetration_ratio}};

// A plate of many points pressed flat on a block, as a plan makes it: what a step of the tool takes without a budget, by how many
// points, and with one, at 1 and 4 kHz; how often it is late, by the clock and by its own work, and what error it accepts.

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
MovingFrame find_timed_hand(double now_s) {
    const double down_m = std::min(0.02 * now_s, 4.0e-3) - 1.0e-3;
    const Vector3 at(0.004 * std::sin(9.0 * now_s), kTop_m + 0.5 * kThick_m - down_m,
                     2.0e-5 * std::sin(63.0 * now_s));
    const double askew = 0.003 * std::sin(5.0 * now_s);
    return {Pose{at, Quaternion(AngleAxis(askew, Vector3::UnitX()))}, {}};
}

struct TimeFound {
    Cost cost;
    double most_us = 0.0;
    double n_late = 0.0, n_late_own = 0.0;
    double most_points = 0.0, most_looks = 0.0, most_error_N = 0.0;
    double n_cut = 0.0;
};

TimeFound play(const Setting& setting, double seconds) {
    const std::unique_ptr<ToolSolver> tool = make_plate(setting);
    const double dt_s = 1.0 / setting.rate_hz;
    const std::vector<MovingFrame> objects(1);
    const double time_us = 1.0e6 * dt_s;
    tool->place(find_timed_hand(0.0).pose_W);
    TimeFound found;
    std::vector<double> us;
    const int n = static_cast<int>(seconds * setting.rate_hz);
    for (int i = 1; i <= n; ++i) {
        ToolFelt felt;
        const Took took = time_once(
            [&] { felt = tool->move(find_timed_hand(i * dt_s), objects, i * dt_s, dt_s); });
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
                const TimeFound found = play({n_points, rate_hz, budget_us}, seconds);
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

// How smooth a peg is felt that goes into a hole a thousandth wider, is turned and comes out: against how fast the hand is.

Report run_peg_in_hole(Run& run) {
    Sheet sheet{
        "peg-in-hole",
        "A peg in a hole, as it is felt",
        "A peg of 288 triangles, 2 cm thick, onto the rim of a hole of 280 triangles, 0.1 % wider, "
        "over it, in, turned by 1.5 rad while the hand trembles, and out; by the simulated hand of "
        "1 kg on 300 N/m in closed loop at 1 kHz. The course takes 3.7 s at speed 1. A step of the "
        "force is that of one tick, of the largest force",
        "2 % of the force a tick up to twice that speed; a faster hand feels what its own way "
        "changes of the coupling.",
        {"speed", "hand, mm/s", "force, N", "step of it, %", "torque, mN m", "step of it, %",
         "steps crossing", "steps that go on, %"}};
    const std::vector<double> speeds =
        run.pick<std::vector<double>>({0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0}, {1.0, 4.0});
    for (const double speed : speeds) {
        run.progress(sheet.rows.size(), speeds.size(), "speed " + to_text(speed));
        test::PegTrial trial;
        const test::PegTrial::Found found = trial.run(speed, true);
        sheet.add({speed, rounded(1.0e3 * found.fastest_m_per_s, 0), rounded(found.most_N, 2),
                   rounded(100.0 * found.share(), 2), rounded(1.0e3 * found.most_Nm, 1),
                   rounded(100.0 * found.most_step_Nm / found.most_Nm, 1), found.n_crossing,
                   rounded(100.0 * found.n_unsettled / found.n_steps, 1)});
    }
    return {sheet};
}

const Registration kPegInHole{
    {"peg-in-hole", "how smooth a peg is felt in a hole a thousandth wider", run_peg_in_hole}};

}  // namespace
}  // namespace fulcrum::bench
