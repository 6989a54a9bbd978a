// What a step of the implicit tool takes in the haptic loop, by how many clusters hold it, while it slides: the newest contact model taken, the
// planes followed, coupling and contacts with their derivatives, as many linear solves as it makes, what is touched and felt. Contact
// is found anew before each step, which is timed apart.
#include "haptics/math/dense.h"
#include "haptics/math/rotation.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/tool_scene.h"

namespace fulcrum::bench {
namespace {

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

}  // namespace
}  // namespace fulcrum::bench
