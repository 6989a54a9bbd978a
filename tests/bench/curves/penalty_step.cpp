// What a step of the implicit tool takes by how many clusters hold it: the planes followed, two looks at coupling and contacts with their
// derivatives, one linear solve. Contact is found before, by rounds that are not timed.
#include "tests/bench/harness/measure.h"
#include "tests/bench/harness/registry.h"
#include "tests/support/tool_scene.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::bench {
namespace {

constexpr double kStep_s = 1.0e-3;
constexpr int kRounds = 1000;  // steps in which contact is found; later it stands

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

// Pressed 3 mm into the block's top and rubbed.
MovingFrame find_hand(int step) {
    const double y = 0.08 - 0.018 * std::min(1.0, step / 500.0);
    return {Pose::at({0.0005 * std::sin(0.01 * step), y, 0.0005 * std::cos(0.013 * step)}), {}};
}

struct Found {
    std::size_t n_clusters = 0;
    Cost cost;
};

Found time_steps(int most_clusters, int newton_iterations, int n_steps) {
    ImplicitPenaltyTool tool = make_pressed_tool(most_clusters, newton_iterations);
    const MovingFrame object;
    tool.place(find_hand(0).pose_W);
    std::vector<double> us;
    for (int i = 1; i <= kRounds + n_steps; ++i) {
        const double now_s = i * kStep_s;
        if (i < kRounds) {
            tool.contact_loop().step(now_s);
        }
        const MovingFrame hand = find_hand(i);
        const Took took = time_once([&] { keep(tool.move(hand, {&object, 1}, now_s, kStep_s)); });
        if (i > kRounds) {
            us.push_back(took.own_us);
        }
    }
    return {tool.planes().size(), summarise(std::move(us))};
}

// The least that an implicit step in six degrees of freedom can be: its linear system.
Cost time_solve(int n_steps) {
    Matrix6 A = Matrix6::Identity();
    A += 0.1 * Matrix6::NullaryExpr([](Eigen::Index i, Eigen::Index j) {
             return std::sin(static_cast<double>(7 * i + j));
         });
    const Vector6 b = Vector6::Ones();
    std::vector<double> us;
    time_batches([&] { keep(Vector6(A.partialPivLu().solve(b))); }, {.samples = n_steps}, us);
    return summarise(std::move(us));
}

Report run_penalty_step(Run& run) {
    Sheet sheet{
        "penalty-step",
        "A step of the implicit tool, by how many clusters of contact hold it",
        "A block of 10 g on 500 N/m pressed 3 mm into another and rubbed; contact is found "
        "by other steps. Processor time of each step, with a live run's Newton iteration "
        "and with four. The last row is one solve of six equations alone.",
        "Ten clusters are enough for a tool that lies flat; twenty cost half a microsecond more.",
        {},
        {}};
    sheet.columns = {"clusters", "Newton iterations", "median us", "99 % us"};
    const int n_steps = static_cast<int>(run.pick(20000.0, 2000.0));
    for (const int most : {1, 3, 5, 10, 20, 32}) {
        for (const int newton : {1, 4}) {
            const Found found = time_steps(most, newton, n_steps);
            sheet.rows.push_back({to_text(static_cast<double>(found.n_clusters)), to_text(newton),
                                  to_text(found.cost.median_us), to_text(found.cost.p99_us)});
        }
        run.progress(most / 32.0, std::to_string(most) + " clusters");
    }
    const Cost solve = time_solve(n_steps);
    sheet.rows.push_back({"a solve alone", "", to_text(solve.median_us), to_text(solve.p99_us)});
    return {sheet};
}

const Registration kPenaltyStep{
    {"penalty-step", "a step of the implicit tool by its clusters", run_penalty_step}};

}  // namespace
}  // namespace fulcrum::bench
