// What the god-object's tool costs where surfaces have more than a shape: friction, normals that turn evenly, and a relief; each beside the same steps without it.
#include "tests/bench/curves/drawn_tool.h"
#include "tests/bench/harness/curve.h"

namespace fulcrum::bench {
namespace {

constexpr FrictionSettings kWood{.static_coefficient = 0.54, .dynamic_coefficient = 0.43};
const TextureSettings kBumps{.source = NoiseTexture{.shortest_m = 0.001, .longest_m = 0.004}};

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

GodObjectPlan make_plan(const Scene& scene, const Surface& surface) {
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
void measure(const Scene& scene, const Surface& surface, int n_steps, Sheet& sheet) {
    const double budget_us = GodObjectSettings{}.budget_us;
    DrawnTool without({make_plan(scene, {})}, budget_us);
    DrawnTool with({make_plan(scene, surface)}, budget_us);
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
    const std::vector<Scene> scenes = make_scenes();
    for (const Scene& scene : scenes) {
        run.progress(sheet.rows.size(), scenes.size() * surfaces().size(), scene.name);
        for (const Surface& surface : surfaces()) {
            measure(scene, surface, run.pick(4000, 300), sheet);
        }
    }
    return {sheet};
}

const Registration kGodSurfaces{
    {"god-surfaces", "what friction, even normals and reliefs cost the god-object's tool",
     run_god_surfaces}};

}  // namespace
}  // namespace fulcrum::bench
