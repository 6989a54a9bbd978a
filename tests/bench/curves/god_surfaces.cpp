#include "haptics/math/rotation.h"
#include "tests/bench/curves/mesh_file.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/god_scene.h"

namespace fulcrum::bench {
namespace {

// A god-object's tool over what it touches: down from above until they touch, then pressed 4 mm too deep, drawn to and fro by up to 7 cm/s,
// and tilted.

constexpr double kLarge_m = 0.1;  ///< each mesh

class DrawnTool {
  public:
    explicit DrawnTool(const std::vector<GodObjectPlan>& plans)
        : tool_(GodObjectTool::build(plans, make_settings()).value()) {
        tool_.place(Pose::at({0.0, 1.2 * kLarge_m, 0.0}));
        for (int i = 1; i <= 2000 && tool_.last_step().contacts == 0; ++i) {
            touched_m_ = 1.2 * kLarge_m - 1.0e-4 * i;
            (void)tool_.move({Pose::at({0.0, touched_m_, 0.0}), {}}, {&held_, 1}, 0.0,
                             test::kGodDt_s);
        }
    }
    /// What it takes of the processor.
    double step_us() {
        ++n_;
        const double t_s = n_ * test::kGodDt_s;
        return time_once([&] {
                   keep(tool_.move({handle_W(), {}}, {&held_, 1}, t_s, test::kGodDt_s));
               })
            .own_us;
    }
    [[nodiscard]] Pose handle_W() const {
        constexpr double kPressed_m = 0.004;
        const double t_s = n_ * test::kGodDt_s;
        const double down = std::min(1.0, t_s / 0.1);
        return {Vector3(0.02 * std::sin(3.0 * t_s), touched_m_ - kPressed_m * down,
                        0.01 * std::sin(5.0 * t_s)),
                compute_exp(Vector3(0.02 * std::sin(4.0 * t_s), 0.1 * std::sin(2.0 * t_s),
                                    0.02 * std::sin(3.0 * t_s)))};
    }
    [[nodiscard]] GodObjectTool& tool() { return tool_; }

  private:
    static GodObjectSettings make_settings() {
        constexpr double kMass_kg = 0.05;
        return test::make_god_settings(make_ball_inertia(kMass_kg, 0.5 * kLarge_m));
    }

    const MovingFrame held_{};
    GodObjectTool tool_;
    double touched_m_ = 0.0;
    int n_ = 0;
};

// What a step of the god-object costs, two fine meshes pressed on each other and dragged: against how fine they are, beside the same questions asked
// by walks down both trees anew.

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
    double unsettled = 0.0;  // share of steps that went on in the next one
    double nearest_m = HUGE_VAL;
};

Measured measure(const Scene& scene, int n_steps) {
    const auto surface = GodSurface::create(scene.mesh);
    DrawnTool drag({{surface, surface}});
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
        measured.unsettled += step.settled ? 0.0 : 1.0 / n_steps;
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
        "fro and tilted; processor time; a step of more than 100 rounds is not settled: the rest "
        "of "
        "its way goes on in the next. Anew: as many sweeps of the step's way and lists of "
        "contacts, each by a walk down both "
        "trees",
        "As fine as it is liked: what is near costs, not what there is. The force has a loop of "
        "its own where 1 kHz is not enough.",
        {"meshes", "triangles", "step, median us", "90 %, us", "99 %, us", "not settled, %",
         "anew, us", "force, us", "rounds", "contacts", "nearest, um"}};
    const std::vector<Scene> scenes = make_scenes(run);
    for (const Scene& scene : scenes) {
        run.progress(sheet.rows.size(), scenes.size(), scene.name);
        const Measured m = measure(scene, run.pick(4000, 300));
        sheet.add({scene.name, scene.mesh.triangles().size(), rounded(m.step.median_us, 2),
                   rounded(m.p90_us, 2), rounded(m.step.p99_us, 2), rounded(100.0 * m.unsettled, 2),
                   rounded(m.anew_us, 2), rounded(m.force_us, 2), rounded(m.rounds, 2),
                   rounded(m.contacts, 2), rounded(1.0e6 * m.nearest_m, 2)});
    }
    return {sheet};
}

const Registration kGodObjectStep{{"god-object-step",
                                   "what a step of the god-object costs, fine mesh on fine mesh",
                                   run_god_object_step}};

// What the god-object's tool costs where surfaces have more than a shape: friction, normals that turn evenly, and a relief; each beside the same steps without it.

constexpr FrictionSettings kWood{.static_coefficient = 0.54, .dynamic_coefficient = 0.43};
const TextureSettings kBumps{.source = NoiseTexture{.shortest_m = 0.001, .longest_m = 0.004}};

struct SurfaceScene {
    std::string name;
    TriangleMesh object;
    TriangleMesh tool;
};

struct Surface {
    std::string name;
    FrictionSettings friction{};
    ShadingSettings shading{};
    TextureSettings texture{};
};

const std::vector<Surface>& surfaces() {
    static const std::vector<Surface> all{
        {"friction", kWood, {}, {}},
        {"even normals", {}, {.on = true}, {}},
        {"relief", {}, {}, kBumps},
        {"all", kWood, {.on = true}, kBumps},
    };
    return all;
}

std::vector<SurfaceScene> make_surface_scenes() {
    const TriangleMesh ball = make_bumpy_sphere(0.5 * kLarge_m, 20, 0.04, 9.0).value();
    return {{"block on a table", make_box({3.0 * kLarge_m, kLarge_m, 3.0 * kLarge_m}).value(),
             make_box(Vector3::Constant(0.4 * kLarge_m)).value()},
            {"round stick on a table", make_box({3.0 * kLarge_m, kLarge_m, 3.0 * kLarge_m}).value(),
             make_cylinder(0.1 * kLarge_m, kLarge_m, 48).value()},
            {"bumpy balls", ball, ball}};
}

GodObjectPlan make_plan(const SurfaceScene& scene, const Surface& surface) {
    GodObjectPlan plan{.object = GodSurface::create(scene.object),
                       .tool = GodSurface::create(scene.tool),
                       .friction = surface.friction};
    if (surface.shading.on) {
        plan.object_shading = GodShading::create(scene.object, surface.shading).value();
        plan.tool_shading = GodShading::create(scene.tool, surface.shading).value();
    }
    if (surface.texture.any()) {
        plan.texture = std::make_shared<const Texture>(surface.texture);
    }
    return plan;
}

// Steps without and with, in turn.
void measure_surface(const SurfaceScene& scene, const Surface& surface, int n_steps, Sheet& sheet) {
    DrawnTool without({make_plan(scene, {})});
    DrawnTool with({make_plan(scene, surface)});
    std::vector<double> plain_us;
    std::vector<double> surface_us;
    double contacts = 0.0;
    for (int i = 0; i < n_steps; ++i) {
        plain_us.push_back(without.step_us());
        surface_us.push_back(with.step_us());
        contacts += static_cast<double>(with.tool().last_step().contacts) / n_steps;
    }
    const Cost plain = summarise(std::move(plain_us));
    const Cost dressed = summarise(std::move(surface_us));
    sheet.add({scene.name, surface.name, rounded(contacts, 2), rounded(plain.median_us, 2),
               rounded(dressed.median_us, 2), rounded(dressed.median_us / plain.median_us, 2),
               rounded(plain.p99_us, 2), rounded(dressed.p99_us, 2),
               rounded(dressed.p99_us / plain.p99_us, 2)});
}

Report run_god_surfaces(Run& run) {
    Sheet sheet{
        "god-surfaces",
        "What surfaces cost the god-object's tool",
        "A tool of 50 g pressed 4 mm too deep, drawn to and fro by up to 7 cm/s and tilted; the "
        "same steps without and with, in turn; processor time",
        "Give bodies the friction of their material: what sticks saves the tool most of its way, "
        "and what slides leaves nine tenths of a millisecond free.",
        {"scene", "surface", "contacts", "without, us", "with, us", "ratio", "99 % without, us",
         "99 % with, us", "ratio of 99 %"}};
    const std::vector<SurfaceScene> scenes = make_surface_scenes();
    for (const SurfaceScene& scene : scenes) {
        run.progress(sheet.rows.size(), scenes.size() * surfaces().size(), scene.name);
        for (const Surface& surface : surfaces()) {
            measure_surface(scene, surface, run.pick(4000, 300), sheet);
        }
    }
    return {sheet};
}

const Registration kGodSurfaces{
    {"god-surfaces", "what friction, even normals and reliefs cost the god-object's tool",
     run_god_surfaces}};

}  // namespace
}  // namespace fulcrum::bench
