// Voxel sampling against what the machine can do at all: carrying the points into the map and reading a byte for each.
#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "haptics/tool/voxel_sampling/voxel_sampling.h"
#include "haptics/voxel/voxelise.h"
#include "tests/bench/harness/curve.h"

namespace fulcrum::bench {
namespace {

constexpr double kRadius_m = 0.05;
constexpr int kPoses = 256;  // a tool that rocks and slides, 1 kHz, 0.1 m/s
constexpr int kPoints = 7782;
constexpr std::size_t kBatch = 64;

// How deep the tool lies in the object, and what that is called.
struct Scene {
    const char* name;
    double apart_m;  // between the middles
};
const std::array<Scene, 3> kScenes{
    {{"apart", 2.1 * kRadius_m}, {"touching", 1.96 * kRadius_m}, {"overlapping", 1.0 * kRadius_m}}};

std::vector<RigidState> make_poses(double apart_m) {
    std::vector<RigidState> poses;
    for (int i = 0; i < kPoses; ++i) {
        const double t = 0.001 * i;
        RigidState state;
        state.pose_W.position = apart_m * Vector3(0.6, 0.64, 0.48).normalized() +
                                1.0e-3 * Vector3(std::sin(100.0 * t), std::cos(90.0 * t), 0.0);
        state.pose_W.orientation = compute_exp(Vector3(0.2 * t, 1.0 * t, -0.3));
        state.velocity_W.linear = {0.05, -0.08, 0.02};
        poses.push_back(state);
    }
    return poses;
}

// The least that any method does: nine products a point, an index, one byte.
class Limit {
  public:
    Limit(const VoxelGrid& grid, const Pointshell& shell) : grid_(grid) {
        const double s = grid.frame.voxel_m;
        for (std::size_t i = 0; i < shell.size() / kBatch * kBatch; ++i) {
            x_.push_back(static_cast<float>(shell.x_m[i] / s));
            y_.push_back(static_cast<float>(shell.y_m[i] / s));
            z_.push_back(static_cast<float>(shell.z_m[i] / s));
        }
    }
    [[nodiscard]] unsigned read(const Pose& pose) const {
        // Turned as the tool is, about the map's own middle: every place lies in the map.
        const Matrix3f R = 0.5F * pose.orientation.toRotationMatrix().cast<float>();
        const Vector3f t =
            grid_.frame.to_lattice(0.5 * (grid_.frame.lower_O + grid_.frame.upper_O()))
                .cast<float>();
        const auto [nx, ny, nz] = grid_.frame.n_cells;
        alignas(64) std::array<std::int32_t, kBatch> index;
        unsigned sum = 0;
        for (std::size_t first = 0; first < x_.size(); first += kBatch) {
            const float* const x = &x_[first];
            const float* const y = &y_[first];
            const float* const z = &z_[first];
            for (std::size_t i = 0; i < kBatch; ++i) {
                const auto cx = static_cast<std::int32_t>(R(0, 0) * x[i] + R(0, 1) * y[i] +
                                                          R(0, 2) * z[i] + t[0]);
                const auto cy = static_cast<std::int32_t>(R(1, 0) * x[i] + R(1, 1) * y[i] +
                                                          R(1, 2) * z[i] + t[1]);
                const auto cz = static_cast<std::int32_t>(R(2, 0) * x[i] + R(2, 1) * y[i] +
                                                          R(2, 2) * z[i] + t[2]);
                index[i] = (cz * ny + cy) * nx + cx;
            }
            for (std::size_t i = 0; i < kBatch; ++i) {
                sum += static_cast<unsigned>(grid_.cells[static_cast<std::size_t>(index[i])]);
            }
        }
        return sum;
    }

  private:
    const VoxelGrid& grid_;
    std::vector<float> x_, y_, z_;
};

// A way of looking up, and what it is asked.
struct Way {
    std::string name;
    VoxelSampling sampling;
};

struct Setup {
    std::shared_ptr<const VoxelGrid> grid;
    Pointshell shell;
    std::vector<Way> ways;
};

Setup make_setup() {
    Setup setup;
    const TriangleMesh ball = make_bumpy_sphere(kRadius_m, 37, 0.03, 9.0).value();
    setup.grid = std::make_shared<const VoxelGrid>(
        voxelise(ball, {.voxel_m = compute_voxel_m(ball, 76)}).value());
    setup.shell = make_surface_pointshell(ball, kPoints).value();
    VoxelSamplingSettings settings;
    const auto add = [&](const std::string& name, std::shared_ptr<const VoxelGrid> grid,
                         std::shared_ptr<const Voxmap> map) {
        setup.ways.push_back(
            {name, VoxelSampling::build({std::move(grid), std::move(map), setup.shell, settings})
                       .value()});
    };
    settings.braking = PreContactBraking::off;
    add("a byte a voxel", setup.grid, nullptr);
    for (const int depth : {1, 2, 3}) {
        add("tree, depth " + std::to_string(depth), nullptr,
            std::make_shared<const Voxmap>(Voxmap::build(*setup.grid, depth).value()));
    }
    settings.braking = PreContactBraking::one_cycle;
    add("a byte a voxel, brakes on", setup.grid, nullptr);
    settings.averaging = ContactAveraging::smooth;
    settings.braking = PreContactBraking::off;
    add("a byte a voxel, smooth average", setup.grid, nullptr);
    return setup;
}

// One scene: every way and the limit in turn, so that all see the same machine.
void measure_scene(const Run& run, const Scene& scene, const Setup& setup, Sheet& sheet) {
    const std::vector<RigidState> poses = make_poses(scene.apart_m);
    const Limit limit(*setup.grid, setup.shell);
    const Timing timing{.samples = kPoses, .batch = 1, .warm_up = 0};
    std::vector<double> limit_us;
    std::vector<std::vector<double>> us(setup.ways.size() + 1);
    const int n_rounds = run.pick(40, 5);
    for (int round = 0; round <= n_rounds; ++round) {
        if (round == 1) {  // the first warms up
            limit_us.clear();
            us.assign(us.size(), {});
        }
        std::size_t pose = 0;
        const auto next = [&]() -> const RigidState& { return poses[pose++ % poses.size()]; };
        time_batches([&] { keep(limit.read(next().pose_W)); }, timing, limit_us);
        for (std::size_t w = 0; w < setup.ways.size(); ++w) {
            time_batches([&] { keep(setup.ways[w].sampling.sample(next(), {})); }, timing, us[w]);
        }
        time_batches(
            [&] {
                WrenchJacobian jacobian;
                keep(setup.ways[0].sampling.sample_linearised(next(), {}, jacobian));
                keep(jacobian);
            },
            timing, us.back());
    }
    std::int64_t n_surface = 0;
    std::int64_t n_interior = 0;
    for (const RigidState& pose : poses) {
        const VoxelContact contact = setup.ways[0].sampling.sample(pose, {});
        n_surface += contact.n_surface;
        n_interior += contact.n_interior;
    }
    const double least_us = summarise(limit_us).median_us;
    const auto add_row = [&](const std::string& name, const Cost& cost, std::size_t bytes) {
        sheet.add({scene.name, n_surface / kPoses, n_interior / kPoses, name,
                   rounded(cost.median_us, 2), rounded(cost.p99_us, 2),
                   rounded(cost.median_us / least_us, 2), bytes});
    };
    add_row("limit: transform and one byte", summarise(limit_us), setup.grid->memory_bytes());
    for (std::size_t w = 0; w < setup.ways.size(); ++w) {
        add_row(setup.ways[w].name, summarise(us[w]), setup.ways[w].sampling.memory_bytes());
    }
    add_row("a byte a voxel, with derivatives", summarise(us.back()),
            setup.ways[0].sampling.memory_bytes());
}

Report run_voxel_speed(Run& run) {
    const Setup setup = make_setup();
    Sheet sheet{
        "voxel-speed",
        "7782 points against 80^3 voxels",
        "a bumpy ball of points rocks on a bumpy ball of voxels, 256 poses at 1 kHz, one thread; "
        "microseconds a look at all points with net force and torque. The limit carries the same "
        "points into the map and reads one byte each, no more, in the same run.",
        "A byte a voxel is the fastest where it fits the second cache; a tree of depth 2 takes a "
        "fraction of the memory.",
        {"scene", "points in surface", "points inside", "way", "median µs", "99 % µs",
         "times the limit", "bytes"}};
    double done = 0.0;
    for (const Scene& scene : kScenes) {
        run.progress(done, scene.name);
        measure_scene(run, scene, setup, sheet);
        done += 1.0 / kScenes.size();
    }
    return {sheet};
}

const Registration kVoxelSpeed{
    {"voxel-speed", "voxel sampling against transform and one byte a point", run_voxel_speed}};

}  // namespace
}  // namespace fulcrum::bench
