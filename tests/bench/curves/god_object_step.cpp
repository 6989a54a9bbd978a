// What a step of the god-object costs, two fine meshes pressed on each other and dragged: against how fine they are, beside the same questions asked
// by walks down both trees anew.
#include "tests/bench/curves/drawn_tool.h"
#include "tests/bench/curves/mesh_file.h"
#include "tests/bench/harness/curve.h"

namespace fulcrum::bench {
namespace {

constexpr double kBudget_us = 500.0;  // as in a lesson at 1 kHz

struct Scene {
    std::string name;
    TriangleMesh mesh;
};

TriangleMesh make_large(const TriangleMesh& mesh) {
    return make_scaled(mesh, kLarge_m / (mesh.upper_B() - mesh.lower_B()).maxCoeff());
}

std::vector<Scene> make_scenes(Run& run) {
    std::vector<Scene> scenes;
    for (const int frequency : run.pick<std::vector<int>>({6, 20, 37}, {6, 20})) {
        const TriangleMesh ball = make_bumpy_sphere(0.5 * kLarge_m, frequency, 0.04, 9.0).value();
        scenes.push_back({"bumpy balls", make_large(ball)});
    }
    if (!run.mesh_file().empty()) {
        scenes.push_back({run.mesh_file().substr(run.mesh_file().find_last_of('/') + 1),
                          make_large(must(load_mesh_file(run.mesh_file())))});
    }
    return scenes;
}

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
    const auto surface = GodSurface::create(scene.mesh);
    DrawnTool drag({{surface, surface}}, kBudget_us);
    const auto swept = SweptMesh::create(scene.mesh);
    BoundedList<NearTriangles> near(16384);
    Measured measured;
    std::vector<double> step_us;
    std::vector<double> force_us;
    std::vector<double> anew_us;
    for (int i = 0; i < n_steps; ++i) {
        const Pose before_W = drag.tool().pose_W();
        step_us.push_back(drag.step_us());
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

Report run_god_object_step(Run& run) {
    Sheet sheet{
        "god-object-step",
        "A step of the god-object, fine mesh on fine mesh",
        "Two meshes of 10 cm, one held and one the tool, 50 g, pressed 4 mm too deep, drawn to and "
        "fro and tilted; processor time; after half a millisecond no round is begun, and such a "
        "step, as one of more than 12 rounds, is cut: the rest of its way goes on in the next. "
        "Anew: as many sweeps of the step's way and lists of contacts, each by a walk down both "
        "trees",
        "As fine as it is liked: what is near costs, not what there is. The force has a loop of "
        "its own where 1 kHz is not enough.",
        {"meshes", "triangles", "step, median us", "90 %, us", "99 %, us", "cut, %", "anew, us",
         "force, us", "rounds", "contacts", "nearest, um"}};
    const std::vector<Scene> scenes = make_scenes(run);
    for (const Scene& scene : scenes) {
        run.progress(sheet.rows.size(), scenes.size(), scene.name);
        const Measured m = measure(scene, run.pick(4000, 300));
        sheet.add({scene.name, scene.mesh.triangles().size(), rounded(m.step.median_us, 2),
                   rounded(m.p90_us, 2), rounded(m.step.p99_us, 2), rounded(100.0 * m.cut, 2),
                   rounded(m.anew_us, 2), rounded(m.force_us, 2), rounded(m.rounds, 2),
                   rounded(m.contacts, 2), rounded(1.0e6 * m.nearest_m, 2)});
    }
    return {sheet};
}

const Registration kGodObjectStep{{"god-object-step",
                                   "what a step of the god-object costs, fine mesh on fine mesh",
                                   run_god_object_step}};

}  // namespace
}  // namespace fulcrum::bench
