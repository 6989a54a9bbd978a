// The thesis' table 2.1 again: how often a second a gear of points is felt against a gear of 80^3 voxels, by the number of points
// and the depth of the tree. Beside the printed figures stand the same method in its own way, a list of voxels in each leaf, and
// ours.
#include "haptics/math/rotation.h"
#include "haptics/tool/voxel_tool.h"
#include "haptics/voxel/voxelise.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/gear.h"
#include "tests/support/listed_tree.h"

namespace fulcrum::bench {
namespace {

constexpr double kDt_s = 0.001;
constexpr double kStiffness_N_per_m = 500.0;
constexpr double kFull = 70.0;      // contacts, as the thesis raised it
constexpr double kApart_m = 0.093;  // of the gears' axes: teeth 7 mm deep in the gaps between teeth

struct Row {
    int n_points;
    std::array<double, 2> printed_kHz;  // depth 1, depth 2, on a Core i7 of 3.4 GHz
};
const std::array<Row, 4> kTable{
    {{614, {8.5, 15.0}}, {1454, {5.1, 8.0}}, {2489, {2.5, 4.4}}, {7782, {1.0, 1.5}}}};

// Centres of voxels, as the thesis has them: the coarsest voxels that give enough, and of those evenly as many as it had.
Pointshell make_shell(const TriangleMesh& gear, std::size_t n_points) {
    int n_cells = 4;
    Pointshell all;
    while (all.size() < n_points) {
        all = make_voxel_pointshell(gear, compute_voxel_m(gear, n_cells++)).value();
    }
    Pointshell shell;
    for (std::size_t i = 0; i < n_points; ++i) {
        const std::size_t k = i * all.size() / n_points;
        shell.add(all.position_T(k), all.normal_T(k));
    }
    return shell;
}

// The handle turns to and fro and presses the flanks of the teeth together.
MovingFrame make_handle(int step) {
    const double phase = 0.02 * step;
    return {Pose{{kApart_m + 0.001 * std::sin(phase), 0.0, 0.0},
                 compute_exp({0.0, 0.0, -0.026 + 0.1 * std::sin(1.3 * phase)})},
            {}};
}

struct Figure {
    double kHz = 0.0;
    double p99_us = 0.0;
};

Figure to_figure(std::vector<double> us) {
    const Cost cost = summarise(std::move(us));
    return {1000.0 / cost.median_us, cost.p99_us};
}

// All settings as in the thesis: semi-implicit Euler, both sides of the plane, no brakes.
VoxelToolSettings make_tool_settings() {
    VoxelToolSettings settings;
    settings.integrator.integrator = Integrator::semi_implicit_euler;
    settings.inertia = make_box_inertia(0.1, {0.1, 0.1, 0.02});
    settings.coupling.shift.stiffness_N_per_m = 500.0;
    settings.silent_in_free_space = false;
    return settings;
}

class Stand {
  public:
    Stand(const std::shared_ptr<const VoxelGrid>& grid, const Pointshell& shell, int depth)
        : listed_(*grid, depth),
          tree_(make_tool(
              nullptr, std::make_shared<const Voxmap>(Voxmap::build(*grid, depth).value()), shell)),
          dense_(make_tool(grid, nullptr, shell)) {
        for (std::size_t i = 0; i < shell.size(); ++i) {
            points_.push_back(shell.position_T(i));
            normals_.push_back(shell.normal_T(i));
        }
        tree_.place(make_handle(0).pose_W);
        dense_.place(make_handle(0).pose_W);
    }
    // In turn, so that all three see the same machine.
    void measure(int n_steps) {
        for (int i = 1; i <= n_steps; ++i) {
            ++step_;
            const MovingFrame handle = make_handle(step_);
            dense_us_.push_back(
                time_by_clock_us([&] { keep(dense_.step(handle, {}, kDt_s * step_, kDt_s)); }));
            tree_us_.push_back(
                time_by_clock_us([&] { keep(tree_.step(handle, {}, kDt_s * step_, kDt_s)); }));
            // The tool's own motion is the tree's: coupling and step of the body cost 0.1 us and are left out.
            const Pose pose = tree_.state().pose_W;
            listed_us_.push_back(time_by_clock_us([&] {
                keep(test::sample_listed(listed_, points_, normals_, pose, kStiffness_N_per_m,
                                         kFull));
            }));
            n_surface_ += tree_.sampling().sample(tree_.state(), {}).n_surface;
        }
    }
    [[nodiscard]] Figure listed() const { return to_figure(listed_us_); }
    [[nodiscard]] Figure tree() const { return to_figure(tree_us_); }
    [[nodiscard]] Figure dense() const { return to_figure(dense_us_); }
    [[nodiscard]] std::int64_t mean_surface() const { return n_surface_ / step_; }

  private:
    static VoxelTool make_tool(std::shared_ptr<const VoxelGrid> grid,
                               std::shared_ptr<const Voxmap> map, const Pointshell& shell) {
        VoxelSamplingSettings settings;
        settings.stiffness_N_per_m = kStiffness_N_per_m;
        settings.plane = TangentPlane::both_sides;
        settings.full_contacts = kFull;
        settings.braking = PreContactBraking::off;
        return VoxelTool::build({std::move(grid), std::move(map), shell, settings},
                                make_tool_settings())
            .value();
    }

    test::ListedTree listed_;
    VoxelTool tree_, dense_;
    std::vector<Vector3> points_, normals_;
    std::vector<double> listed_us_, tree_us_, dense_us_;
    int step_ = 0;
    std::int64_t n_surface_ = 0;
};

std::string to_digits(double value) {
    const double step = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
    return to_text(step * std::round(value / step));
}

Report run_thesis_table(Run& run) {
    const TriangleMesh gear = make_gear({}).value();
    // 80 voxels along its longest side with the layers around it.
    const auto grid = std::make_shared<const VoxelGrid>(
        voxelise(gear, {.voxel_m = compute_voxel_m(gear, 76)}).value());
    Sheet sheet{
        "thesis-table",
        "A gear of points in a gear of 80^3 voxels, kHz",
        "Table 2.1 of the thesis (Core i7, 3.4 GHz) and the same on this machine, one thread: "
        "every point looked up each step, tangent planes, average beyond 70 contacts, coupling, "
        "semi-implicit Euler; points are centres of surface voxels. Listed: the thesis' tree with "
        "a list of voxels in each leaf. Tree: the 512-tree of two bits a voxel. Byte: a byte a "
        "voxel, no tree. Medians of steps taken in turn.",
        "With lists a deeper tree is faster, as the thesis found; where a leaf is looked into "
        "directly, depth costs a little and buys memory.",
        {"points", "depth", "in the surface", "printed kHz", "listed kHz", "tree kHz", "byte kHz",
         "tree 99 % µs", "byte / printed"}};
    double done = 0.0;
    for (const Row& row : kTable) {
        const Pointshell shell = make_shell(gear, static_cast<std::size_t>(row.n_points));
        for (int depth = 1; depth <= 2; ++depth) {
            run.progress(done, std::to_string(row.n_points) + " points");
            Stand stand(grid, shell, depth);
            stand.measure(run.pick(3000, 200));
            const double printed = row.printed_kHz[static_cast<std::size_t>(depth - 1)];
            sheet.add({row.n_points, depth, stand.mean_surface(), printed,
                       to_digits(stand.listed().kHz), to_digits(stand.tree().kHz),
                       to_digits(stand.dense().kHz), to_digits(stand.tree().p99_us),
                       to_digits(stand.dense().kHz / printed)});
            done += 1.0 / 8.0;
        }
    }
    return {sheet};
}

const Registration kThesisTable{
    {"thesis-table", "614 to 7782 points against a gear of 80^3 voxels, beside the thesis",
     run_thesis_table}};

}  // namespace
}  // namespace fulcrum::bench
