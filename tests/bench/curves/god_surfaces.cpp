// What the god-object's tool costs where surfaces have more than a shape: friction, normals that turn evenly, and a relief; each beside the same steps without it.
#include "haptics/math/rotation.h"
#include "tests/bench/harness/csv.h"
#include "tests/bench/harness/measure.h"
#include "tests/bench/harness/registry.h"
#include "tests/support/god_scene.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace fulcrum::bench {
namespace {

constexpr double kDt_s = 0.001;
constexpr double kLarge_m = 0.1;  // of what is touched
constexpr double kPressed_m = 0.004;
constexpr double kMass_kg = 0.05;
constexpr FrictionSettings kWood{.static_coefficient = 0.54, .dynamic_coefficient = 0.43};
const TextureSettings kBumps{.source = NoiseTexture{.shortest_m = 0.001, .longest_m = 0.004}};
const MovingFrame kHeld{};

struct Scene {
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

std::vector<Scene> make_scenes() {
    const TriangleMesh ball = make_bumpy_sphere(0.5 * kLarge_m, 20, 0.04, 9.0).value();
    return {{"block on a table", make_box({3.0 * kLarge_m, kLarge_m, 3.0 * kLarge_m}).value(),
             make_box(Vector3::Constant(0.4 * kLarge_m)).value()},
            {"round stick on a table", make_box({3.0 * kLarge_m, kLarge_m, 3.0 * kLarge_m}).value(),
             make_cylinder(0.1 * kLarge_m, kLarge_m, 48).value()},
            {"bumpy balls", ball, ball}};
}

// Down from above until they touch, then pressed, drawn to and fro by up to 7 cm/s, and tilted.
class Drawn {
  public:
    Drawn(const Scene& scene, const Surface& surface)
        : tool_(GodObjectTool::build(
                    {make_plan(scene, surface)},
                    test::make_god_settings(make_ball_inertia(kMass_kg, 0.5 * kLarge_m)))
                    .value()) {
        tool_.place(Pose::at({0.0, 1.2 * kLarge_m, 0.0}));
        for (int i = 1; i <= 2000 && tool_.last_step().contacts == 0; ++i) {
            touched_m_ = 1.2 * kLarge_m - 1.0e-4 * i;
            (void)tool_.move({Pose::at({0.0, touched_m_, 0.0}), {}}, {&kHeld, 1}, 0.0, kDt_s);
        }
    }
    double step_us() {
        ++n_;
        const double t_s = n_ * kDt_s;
        const double down = std::min(1.0, t_s / 0.1);
        const Pose handle_W{
            Vector3(0.02 * std::sin(3.0 * t_s), touched_m_ - kPressed_m * down,
                    0.01 * std::sin(5.0 * t_s)),
            compute_exp(Vector3(0.02 * std::sin(4.0 * t_s), 0.1 * std::sin(2.0 * t_s),
                                0.02 * std::sin(3.0 * t_s)))};
        return time_once([&] { keep(tool_.move({handle_W, {}}, {&kHeld, 1}, t_s, kDt_s)); }).own_us;
    }
    [[nodiscard]] int contacts() const { return tool_.last_step().contacts; }

  private:
    static GodObjectPlan make_plan(const Scene& scene, const Surface& surface) {
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

    GodObjectTool tool_;
    double touched_m_ = 0.0;
    int n_ = 0;
};

std::string rounded(double value) {
    return to_text(std::round(100.0 * value) / 100.0);
}

// Steps without and with, in turn.
std::vector<std::string> measure(const Scene& scene, const Surface& surface, int n_steps) {
    Drawn without(scene, {});
    Drawn with(scene, surface);
    std::vector<double> plain_us;
    std::vector<double> surface_us;
    double contacts = 0.0;
    for (int i = 0; i < n_steps; ++i) {
        plain_us.push_back(without.step_us());
        surface_us.push_back(with.step_us());
        contacts += static_cast<double>(with.contacts()) / n_steps;
    }
    const Cost plain = summarise(std::move(plain_us));
    const Cost dressed = summarise(std::move(surface_us));
    return {scene.name,
            surface.name,
            rounded(contacts),
            rounded(plain.median_us),
            rounded(dressed.median_us),
            rounded(dressed.median_us / plain.median_us),
            rounded(plain.p99_us),
            rounded(dressed.p99_us),
            rounded(dressed.p99_us / plain.p99_us)};
}

Report run_god_surfaces(Run& run) {
    Sheet sheet;
    sheet.name = "god-surfaces";
    sheet.title = "What surfaces cost the god-object's tool";
    sheet.work =
        "A tool of 50 g pressed 4 mm too deep, drawn to and fro by up to 7 cm/s and tilted; the "
        "same steps without and with, in turn; processor time";
    sheet.advice =
        "Give bodies the friction of their material: what sticks saves the tool most of its way, "
        "and what slides leaves nine tenths of a millisecond free.";
    sheet.columns = {"scene", "surface",          "contacts",      "without, us",  "with, us",
                     "ratio", "99 % without, us", "99 % with, us", "ratio of 99 %"};
    const std::vector<Scene> scenes = make_scenes();
    for (const Scene& scene : scenes) {
        run.progress(static_cast<double>(sheet.rows.size()) /
                         static_cast<double>(scenes.size() * surfaces().size()),
                     scene.name);
        for (const Surface& surface : surfaces()) {
            sheet.rows.push_back(measure(scene, surface, run.pick(4000, 300)));
        }
    }
    return {sheet};
}

const Registration kGodSurfaces{
    {"god-surfaces", "what friction, even normals and reliefs cost the god-object's tool",
     run_god_surfaces}};

}  // namespace
}  // namespace fulcrum::bench
