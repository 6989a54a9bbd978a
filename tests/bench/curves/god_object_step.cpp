// What a step of the god-object costs, two fine meshes pressed on each other and dragged: against how fine they are, beside the same questions asked
// by walks down both trees anew.
#include "haptics/math/rotation.h"
#include "tests/bench/curves/mesh_file.h"
#include "tests/bench/harness/csv.h"
#include "tests/bench/harness/measure.h"
#include "tests/bench/harness/registry.h"
#include "tests/support/god_scene.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace fulcrum::bench {
namespace {

constexpr double kDt_s = 0.001;
constexpr double kLarge_m = 0.1;  // each mesh
constexpr double kPressed_m = 0.004;
constexpr double kMass_kg = 0.05;
constexpr double kBudget_us = 500.0;  // as in a lesson at 1 kHz
const MovingFrame kHeld{};

struct Scene {
    std::string name;
    TriangleMesh mesh;
};

// Its largest side so long, its middle at the origin.
TriangleMesh make_large(const TriangleMesh& mesh, double length_m) {
    const Vector3 middle = 0.5 * (mesh.upper_B() + mesh.lower_B());
    const double scale = length_m / (mesh.upper_B() - mesh.lower_B()).maxCoeff();
    std::vector<Vector3> vertices = mesh.vertices_B();
    for (Vector3& v : vertices) {
        v = scale * (v - middle);
    }
    return TriangleMesh::build(std::move(vertices), mesh.triangles()).value();
}

std::vector<Scene> make_scenes(Run& run) {
    std::vector<Scene> scenes;
    for (const int frequency : run.pick<std::vector<int>>({6, 20, 37}, {6, 20})) {
        const TriangleMesh ball = make_bumpy_sphere(0.5 * kLarge_m, frequency, 0.04, 9.0).value();
        scenes.push_back({"bumpy balls", make_large(ball, kLarge_m)});
    }
    if (!run.mesh_file().empty()) {
        scenes.push_back({run.mesh_file().substr(run.mesh_file().find_last_of('/') + 1),
                          make_large(load_mesh_file(run.mesh_file()).value(), kLarge_m)});
    }
    return scenes;
}

// Down from above until they touch, then pressed, drawn to and fro by up to 7 cm/s, and tilted.
class Drag {
  public:
    explicit Drag(const TriangleMesh& mesh)
        : tool_(test::make_god_tool(mesh, {mesh}, make_settings())) {
        tool_.place(Pose::at({0.0, 1.2 * kLarge_m, 0.0}));
        for (int i = 1; i <= 2000 && tool_.last_step().contacts == 0; ++i) {
            touched_m_ = 1.2 * kLarge_m - 1.0e-4 * i;
            (void)tool_.move({Pose::at({0.0, touched_m_, 0.0}), {}}, {&kHeld, 1}, 0.0, kDt_s);
        }
    }
    ToolFelt step() {
        ++n_;
        return tool_.move({handle_W(), {}}, {&kHeld, 1}, n_ * kDt_s, kDt_s);
    }
    [[nodiscard]] Pose handle_W() const {
        const double t_s = n_ * kDt_s;
        const double down = std::min(1.0, t_s / 0.1);
        return {Vector3(0.02 * std::sin(3.0 * t_s), touched_m_ - kPressed_m * down,
                        0.01 * std::sin(5.0 * t_s)),
                compute_exp(Vector3(0.02 * std::sin(4.0 * t_s), 0.1 * std::sin(2.0 * t_s),
                                    0.02 * std::sin(3.0 * t_s)))};
    }
    [[nodiscard]] GodObjectTool& tool() { return tool_; }

  private:
    static GodObjectSettings make_settings() {
        GodObjectSettings settings =
            test::make_god_settings(make_ball_inertia(kMass_kg, 0.5 * kLarge_m));
        settings.budget_us = kBudget_us;
        return settings;
    }

    GodObjectTool tool_;
    double touched_m_ = 0.0;
    int n_ = 0;
};

struct Measured {
    Cost step;
    double p90_us = 0.0;
    double force_us = 0.0;
    double anew_us = 0.0;
    double rounds = 0.0;
    double contacts = 0.0;
    double cut = 0.0;  // share of steps that went on in the next one
    double nearest_m = HUGE_VAL;
};

Measured measure(const Scene& scene, int n_steps) {
    Drag drag(scene.mesh);
    const auto swept = SweptMesh::create(scene.mesh);
    BoundedList<NearTriangles> near(16384);
    Measured measured;
    std::vector<double> step_us;
    std::vector<double> force_us;
    std::vector<double> anew_us;
    for (int i = 0; i < n_steps; ++i) {
        const Pose before_W = drag.tool().pose_W();
        step_us.push_back(time_once([&] { keep(drag.step()); }).own_us);
        const GodObjectStep& step = drag.tool().last_step();
        measured.cut += step.settled ? 0.0 : 1.0 / n_steps;
        measured.rounds += static_cast<double>(step.rounds) / n_steps;
        measured.contacts += static_cast<double>(step.contacts) / n_steps;
        measured.nearest_m = std::min(measured.nearest_m, step.least_gap_m);
        const Pose handle_W = drag.handle_W();
        force_us.push_back(time_once([&] { keep(drag.tool().force(handle_W)); }).own_us);
        if (i % 10 == 0) {
            // One round of the step: its way, and what is in contact behind it.
            const InBetweenMotion way(before_W, drag.tool().pose_W());
            const Took took = time_once([&] {
                keep(sweep_meshes(*swept, *swept, way, {.touch_m = 2.5e-7, .tolerance_m = 2.5e-7})
                         .outcome);
                keep(collect_near(*swept, *swept, way, 1.0, 4.0e-6, near));
            });
            anew_us.push_back(took.own_us * std::max(1, step.rounds));
        }
    }
    std::vector<double> sorted = step_us;
    std::ranges::sort(sorted);
    measured.p90_us = sorted[sorted.size() * 9 / 10];
    measured.step = summarise(std::move(step_us));
    measured.force_us = summarise(std::move(force_us)).median_us;
    measured.anew_us = summarise(std::move(anew_us)).median_us;
    return measured;
}

std::string rounded(double value) {
    return to_text(std::round(100.0 * value) / 100.0);
}

Report run_god_object_step(Run& run) {
    Sheet sheet;
    sheet.name = "god-object-step";
    sheet.title = "A step of the god-object, fine mesh on fine mesh";
    sheet.work =
        "Two meshes of 10 cm, one held and one the tool, 50 g, pressed 4 mm too deep, drawn to and "
        "fro "
        "and tilted; processor time; after half a millisecond no round is begun, and such a step, "
        "as "
        "one of more than 12 rounds, is cut: the rest of its way goes on in the next. Anew: as "
        "many "
        "sweeps of the step's way and lists of contacts, "
        "each "
        "by a walk down both trees";
    sheet.advice =
        "As fine as it is liked: what is near costs, not what there is. The force has a loop of "
        "its own where 1 kHz is not enough.";
    sheet.columns = {"meshes",   "triangles", "step, median us", "90 %, us", "99 %, us",   "cut, %",
                     "anew, us", "force, us", "rounds",          "contacts", "nearest, um"};
    const std::vector<Scene> scenes = make_scenes(run);
    for (const Scene& scene : scenes) {
        run.progress(static_cast<double>(sheet.rows.size()) / static_cast<double>(scenes.size()),
                     scene.name);
        const Measured m = measure(scene, run.pick(4000, 300));
        sheet.rows.push_back({scene.name, std::to_string(scene.mesh.triangles().size()),
                              rounded(m.step.median_us), rounded(m.p90_us), rounded(m.step.p99_us),
                              rounded(100.0 * m.cut), rounded(m.anew_us), rounded(m.force_us),
                              rounded(m.rounds), rounded(m.contacts),
                              rounded(1.0e6 * m.nearest_m)});
    }
    return {sheet};
}

const Registration kGodObjectStep{{"god-object-step",
                                   "what a step of the god-object costs, fine mesh on fine mesh",
                                   run_god_object_step}};

}  // namespace
}  // namespace fulcrum::bench
