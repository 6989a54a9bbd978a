// A tool of a million points against a distance field of 512 voxels a side: what a step costs by the tree, with memory of what is
// free, and by brute force, for contacts here and there, jumps, and a tool that fills a socket; what a budget of time costs in force.

#include "haptics/geometry/shape.h"
#include "tests/bench/curves/accuracy_scenes.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/wander.h"

namespace fulcrum::bench {
namespace {

constexpr std::array<double, 4> kSpeeds{0.05, 0.5, 1.0, 4.0};  // radii a second
constexpr double kTick_s = 1.0e-3;
constexpr double kClearance_voxels = 1.0;  // of the tool in its socket, all round
constexpr double kInSocket = 0.011;        // of its points touch

struct Scene {
    FieldSampler::Field field;
    FieldSampler::Shell shell;
    double build_s = 0.0;
};

Scene make_scene(const TriangleMesh& object, const TriangleMesh& tool, int n_along, int n_points) {
    Scene scene;
    const Took took = time_once([&] {
        scene.field = make_distance_field(object, n_along);
        scene.shell = std::make_shared<const ShellTree>(
            ShellTree::build(make_surface_pointshell(tool, n_points).value()).value());
    });
    scene.build_s = 1.0e-6 * took.clock_us;
    return scene;
}

// A ball with a hollow of radius 1 in it.
TriangleMesh make_socket(int frequency) {
    return make_hollow(*make_sphere(1.15, frequency),
                       *make_bumpy_sphere(1.0, frequency, 0.02, 15.0))
        .value();
}

// Poses at 1 kHz; the depth is so steered that about `n_wanted` points touch.
std::vector<Pose> make_local_way(const Scene& scene, double speed, int n, double n_wanted) {
    FieldSampler sampler =
        FieldSampler::build(scene.field, scene.shell, {.mode = SamplingMode::tree}).value();
    // The ways of centres are two radii from the middle.
    Wanderer wanderer(3, 0.5 * speed * kTick_s);
    Random random(4);
    const double step_m = 0.02 * scene.field->frame().voxel_m;
    double height_m = 2.0;
    std::vector<Pose> way;
    Quaternion turn = Quaternion::Identity();
    for (int i = -300; i < n; ++i) {
        turn = (random.turn(0.2 * speed * kTick_s) * turn).normalized();
        const Pose X_OT{height_m * wanderer.next(), turn};
        const auto n_touching = static_cast<double>(sampler.step({}, X_OT).n_touching);
        height_m += n_touching > n_wanted ? step_m : -step_m;
        if (i >= 0) {
            way.push_back(X_OT);
        } else if (n_touching == 0.0) {
            height_m -= 20.0 * step_m;
        }
    }
    return way;
}

std::vector<Pose> make_jumps(const std::vector<Pose>& way) {
    // Every other pose from the far side.
    std::vector<Pose> jumps;
    for (std::size_t i = 0; i < way.size(); ++i) {
        jumps.push_back(way[(i * 7919) % way.size()]);
    }
    return jumps;
}

// In the socket, all points within a few voxels of it, so pressed to a side that about `n_wanted` touch; no point faster than `speed`.
std::vector<Pose> make_socket_way(const Scene& scene, double speed, int n, double n_wanted) {
    constexpr double kTurning = 0.2;  // of the speed
    constexpr int kSettle = 300;
    const double voxel_m = scene.field->frame().voxel_m;
    const double step_m = (1.0 - kTurning) * speed * kTick_s;
    FieldSampler sampler = FieldSampler::build(scene.field, scene.shell).value();
    // It slides round the socket, a clearance off its middle.
    const double off_m = kClearance_voxels * voxel_m;
    Wanderer wanderer(5, std::min(0.2, step_m / off_m));
    const double turn_rad = 0.3 * voxel_m;
    double pressed_m = off_m;
    std::vector<Pose> way;
    for (int i = -kSettle; i < n; ++i) {
        const double angle = turn_rad * std::sin(kTurning * speed * kTick_s * i / turn_rad);
        const Pose X_OT{pressed_m * wanderer.next(),
                        Quaternion(AngleAxis(angle, Vector3::UnitY()))};
        const double excess =
            static_cast<double>(sampler.step({}, X_OT).n_touching) / n_wanted - 1.0;
        const double most_m = i < 0 ? 0.02 * voxel_m : std::min(0.02 * voxel_m, 0.3 * step_m);
        pressed_m -= most_m * std::clamp(3.0 * excess, -1.0, 1.0);
        if (i >= 0) {
            way.push_back(X_OT);
        }
    }
    return way;
}

struct Measured {
    Cost cost;
    double most_us = 0.0;
    std::vector<Took> took;
    double n_touching = 0.0;
    std::vector<FieldTouch> touches;
};

Measured measure(const Scene& scene, const FieldSamplingSettings& settings,
                 const std::vector<Pose>& way) {
    FieldSampler sampler = FieldSampler::build(scene.field, scene.shell, settings).value();
    Measured measured;
    std::vector<double> us;
    constexpr std::size_t kWarmUp = 50;
    for (std::size_t i = 0; i < way.size(); ++i) {
        FieldTouch touch;
        const Took took = time_once([&] { touch = sampler.step({}, way[i]); });
        if (i >= kWarmUp) {
            us.push_back(took.clock_us);
            measured.took.push_back(took);
            measured.touches.push_back(touch);
            measured.n_touching += static_cast<double>(touch.n_touching);
        }
    }
    measured.n_touching /= static_cast<double>(us.size());
    measured.most_us = *std::max_element(us.begin(), us.end());
    measured.cost = summarise(std::move(us));
    return measured;
}

// Steps whose contacts or forces are not brute force's; each fortieth pose is compared.
int count_other(const Scene& scene, SamplingMode mode, const std::vector<Pose>& way) {
    FieldSampler brute =
        FieldSampler::build(scene.field, scene.shell, {.mode = SamplingMode::brute_force}).value();
    FieldSampler sampler = FieldSampler::build(scene.field, scene.shell, {.mode = mode}).value();
    int n_other = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
        const FieldTouch touch = sampler.step({}, way[i]);
        if (i % 40 == 0) {
            const FieldTouch exact = brute.step({}, way[i]);
            n_other +=
                touch.n_touching != exact.n_touching || touch.wrench_W.force != exact.wrench_W.force
                    ? 1
                    : 0;
        }
    }
    return n_other;
}

void add_rows(const std::string& what, double speed, const Scene& scene,
              const std::vector<Pose>& way, Sheet& sheet) {
    const std::vector<Pose> few(way.begin(), way.begin() + 60);
    const Measured brute = measure(scene, {.mode = SamplingMode::brute_force}, few);
    for (const SamplingMode mode : {SamplingMode::tree, SamplingMode::coherent}) {
        const Measured m = measure(scene, {.mode = mode}, way);
        sheet.add({what, mode == SamplingMode::tree ? "tree" : "coherent", speed,
                   std::round(m.n_touching), m.cost.median_us, m.cost.p99_us, m.most_us,
                   brute.cost.median_us, brute.cost.median_us / m.cost.median_us,
                   count_other(scene, mode, way)});
    }
}

constexpr const char* kWork =
    "A bumpy ball of points on a bumpy ball of 100 820 triangles, 512 voxels along its diameter, "
    "so steered that some 1000 points touch, and one in a socket of its own shape, a voxel of "
    "clearance all round, so pressed to a side that some 11 000 touch; 1 kHz, no point faster than "
    "said. Contacts and forces are compared with brute force in every fortieth step.";

// What a budget left undone, over steps where at least 150 samples touch.
struct BudgetErrors {
    std::vector<double> force_percent, torque_percent, said_percent;
    double weight = 0.0;
    int n_steps = 0;
    int n_beyond = 0;  // steps whose error is more than was said
};

BudgetErrors compare(const Measured& some, const std::vector<FieldTouch>& exact, double reach_m) {
    BudgetErrors errors;
    for (std::size_t i = 0; i < some.touches.size(); ++i) {
        const FieldTouch& touch = some.touches[i];
        const double force_N = exact[i].wrench_W.force.norm();
        const double off_N = (touch.wrench_W.force - exact[i].wrench_W.force).norm();
        const double off_Nm = (touch.wrench_W.torque - exact[i].wrench_W.torque).norm();
        constexpr double kRounding = 1.0e-6;
        errors.n_beyond += off_N > touch.error_N + kRounding * force_N ||
                                   off_Nm > touch.error_Nm + kRounding * reach_m * force_N
                               ? 1
                               : 0;
        if (touch.n_touching < 150 * touch.weight || force_N == 0.0) {
            continue;
        }
        ++errors.n_steps;
        errors.force_percent.push_back(100.0 * off_N / force_N);
        // A torque may be near 0: it is told by what the force makes at the tool's radius.
        errors.torque_percent.push_back(100.0 * off_Nm / (reach_m * force_N));
        errors.said_percent.push_back(100.0 * touch.error_N / force_N);
        errors.weight = std::max(errors.weight, static_cast<double>(touch.weight));
    }
    return errors;
}

double count_late(const Measured& measured, double budget_us, double Took::*which) {
    return static_cast<double>(std::ranges::count_if(
        measured.took, [&](const Took& took) { return took.*which > budget_us; }));
}

void add_budget_row(const std::string& what, double speed, const Scene& scene,
                    const std::vector<Pose>& way, const Measured& exact,
                    const FieldSamplingSettings& settings, Sheet& sheet) {
    const Measured m = measure(scene, settings, way);
    const BudgetErrors errors = compare(m, exact.touches, scene.shell->reach_m());
    if (errors.n_steps == 0) {
        return;
    }
    const Cost force = summarise(errors.force_percent);
    sheet.add({what, speed, settings.budget_us,
               settings.clock == BudgetClock::measured ? "measured" : "counted", m.cost.median_us,
               m.cost.p99_us, count_late(m, settings.budget_us, &Took::clock_us),
               count_late(m, settings.budget_us, &Took::own_us), errors.weight, force.median_us,
               force.p99_us, summarise(errors.torque_percent).p99_us,
               summarise(errors.said_percent).median_us, errors.n_steps, errors.n_beyond});
}

void add_budget_rows(const std::string& what, double speed, const Scene& scene,
                     std::vector<Pose> way, int n, Sheet& sheet) {
    way.resize(static_cast<std::size_t>(n));
    const Measured exact = measure(scene, {}, way);
    for (const double budget_us : {30.0, 60.0, 100.0, 200.0}) {
        add_budget_row(what, speed, scene, way, exact,
                       {.budget_us = budget_us, .clock = BudgetClock::measured}, sheet);
    }
    add_budget_row(what, speed, scene, way, exact,
                   {.budget_us = 100.0, .clock = BudgetClock::counted}, sheet);
}

Report run_field_sampling(Run& run) {
    const int n_points = run.pick(1'000'000, 100'000);
    const int n_along = run.pick(512, 256);
    const int n = run.pick(1200, 200);
    const TriangleMesh object = *make_bumpy_sphere(1.0, 71, 0.03, 20.0);
    const TriangleMesh tool = *make_bumpy_sphere(1.0, 71, 0.02, 15.0);
    const Scene scene = make_scene(object, tool, n_along, n_points);
    run.progress(0.2, "the field is built");

    Sheet sheet{
        "field-sampling",
        "A million points against a distance field",
        kWork,
        "Keep the coherent mode: it is the tree where everything moves far, and a part of it where "
        "little does.",
        {"contact", "mode", "radii a second", "points touching", "median us", "99 % us", "most us",
         "brute force us", "times faster", "steps that differ"}};
    for (const double speed : kSpeeds) {
        add_rows("local", speed, scene, make_local_way(scene, speed, n, 1000.0), sheet);
    }
    add_rows("jumps", 0.0, scene, make_jumps(make_local_way(scene, 4.0, n, 1000.0)), sheet);
    run.progress(0.6, "local contacts are measured");
    const VoxelFrame socket_frame = make_field_frame(make_socket(71), n_along).value();
    const TriangleMesh plug =
        *make_bumpy_sphere(1.0 - kClearance_voxels * socket_frame.voxel_m, 71, 0.02, 15.0);
    const Scene socket = make_scene(make_socket(71), plug, n_along, n_points);
    Sheet budgets{
        "field-sampling-budget",
        "A budget of time: error of the net force",
        kWork,
        "Give what the tick can spare; what it says of its error is on the safe side.",
        {"contact", "radii a second", "budget us", "clock", "median us", "99 % us", "steps late",
         "late by their own work", "most points for one", "force error, median %",
         "force error, 99 %, %", "torque error over force and radius, 99 %, %",
         "error it says, median %", "steps of 150 samples", "steps off by more than said"}};
    const int n_budget = run.pick(600, 100);
    for (const double speed : {0.05, 0.2, 1.0}) {
        const auto way = make_socket_way(socket, speed, n / 2, kInSocket * n_points);
        add_rows("socket", speed, socket, way, sheet);
        add_budget_rows("socket", speed, socket, way, n_budget, budgets);
        run.progress(speed < 0.1 ? 0.75 : 0.9, "a socket at " + to_text(speed) + " radii a second");
    }
    for (const double speed : {0.5, 4.0}) {
        add_budget_rows("local", speed, scene, make_local_way(scene, speed, n, 1000.0), n_budget,
                        budgets);
    }
    Sheet build{"field-sampling-build",
                "What is built and kept",
                kWork,
                "Half as many cells along a side build four times as fast and take a quarter of "
                "the memory.",
                {"build s", "field MB", "shell MB", "bricks", "slope bound", "kernel"}};
    build.add({scene.build_s, 1.0e-6 * static_cast<double>(scene.field->memory_bytes()),
               1.0e-6 * static_cast<double>(scene.shell->memory_bytes()),
               scene.field->counts().n_bricks, scene.field->slope_bound(),
               best_field_kernels().name});
    return {sheet, budgets, build};
}

const Registration kFieldSampling{{"field-sampling",
                                   "a million points against a distance field, and budgets of time",
                                   run_field_sampling}};

}  // namespace
}  // namespace fulcrum::bench
