// Contact levels of detail: what a tolerance or a budget costs in force, and what it saves in time. After the experiments of Otaduy and Lin
// 2003, Sensation preserving simplification for haptic rendering, section 6, on meshes of our own.
#include "haptics/geometry/shape.h"
#include "tests/bench/curves/level_scenes.h"
#include "tests/bench/curves/mesh_file.h"
#include "tests/bench/harness/curve.h"

#include <filesystem>

namespace fulcrum::bench {
namespace {

// A scene, and what is felt in it exactly.
struct Course {
    LevelScene scene;
    SceneLevels levels;
    PlayedScene exact;
};

Course make_course(LevelScene scene) {
    Course course{.scene = std::move(scene), .levels = {}, .exact = {}};
    course.levels = make_scene_levels(course.scene);
    course.exact = play_scene(course.scene, course.levels, {});
    return course;
}

double compute_off_percent(const std::vector<Vector3>& forces, const std::vector<Vector3>& exact) {
    double square_off = 0.0;
    double square_exact = 0.0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        square_off += (forces[i] - exact[i]).squaredNorm();
        square_exact += exact[i].squaredNorm();
    }
    return 100.0 * std::sqrt(square_off / square_exact);
}

CostPoint measure_course(const Course& course, double knob, PlayedScene played) {
    const double off = compute_off_percent(played.felt_N, course.exact.felt_N);
    Cost cost = summarise(std::move(played.us), played.bytes);
    return {course.scene.name,
            knob,
            off > 0.0 ? off : kNone,
            cost,
            {1.0e3 / cost.median_us, played.n_contacts, played.n_pairs, 100.0 * played.n_late}};
}

CostCurve make_curve(const std::string& name, const std::string& title, const Axis& knob) {
    CostCurve curve;
    curve.name = name;
    curve.title = title;
    curve.work =
        "a hand presses a tool on another mesh by a coupling of 500 N/m, clusters of contacts of "
        "20 kN/m hold it back from d outside on; the time is that of one question for contacts, of "
        "the processor";
    curve.reference =
        "converged: what the hand feels without a tolerance, root mean square over the way; Otaduy "
        "and Lin's 40 k against 40 k triangles at 2.5 % took 2 to 10 ms";
    curve.knob = knob;
    curve.error = {"error of the felt force", "%", true};
    curve.extras = {{"rate", "kHz"}, {"contacts", ""}, {"pairs looked at", ""}, {"late", "%"}};
    return curve;
}

std::vector<LevelScene> make_scenes(Run& run) {
    const int n_steps = run.pick(1000, 120);
    std::vector<LevelScene> scenes;
    scenes.push_back(make_jaws_scene(run.pick(320, 80), run.pick(64, 32), n_steps));
    scenes.push_back(make_spoon_scene(run.pick(22, 8), n_steps));
    scenes.push_back(
        make_rolling_scene("bumpy ball on ball",
                           make_bumpy_sphere(0.1, run.pick(37, 12), 0.02, 60.0).value(), n_steps));
    if (!run.mesh_file().empty()) {
        if (const Expected<TriangleMesh> mesh = load_mesh_file(run.mesh_file())) {
            const std::string stem = std::filesystem::path(run.mesh_file()).stem().string();
            scenes.push_back(make_rolling_scene(stem, *mesh, n_steps));
        } else {
            run.progress(0.0, to_sentence(mesh.error()));
        }
    }
    return scenes;
}

void list_levels(const Course& course, Sheet& sheet) {
    const ContactLevels& levels = *course.levels.tool;
    sheet.add({course.scene.name, course.scene.tool.triangles().size(), levels.n_pieces(),
               levels.nodes().size(), levels.n_levels(), rounded(course.levels.seconds, 2),
               rounded(1.0e-6 * static_cast<double>(levels.memory_bytes()), 2)});
}

// Two lumps 10 mm deep in each other: the budget must hold there, too.
Sheet make_deep_sheet(Run& run) {
    Sheet sheet{
        "contact-levels-deep",
        "Two lumps deep in each other, by a budget or a tolerance",
        "bumpy balls of 0.1 m, 10 mm deep in each other, slide and turn; processor time of a "
        "question; the force is that of clusters of 20 kN/m where the tool is, root mean square "
        "against that without either",
        "A budget, where it may be deep: what it leaves out is told.",
        {"asked for", "triangles", "median us", "p99 us", "max us", "force off %", "left",
         "coarser", "left deepest mm"}};
    const TriangleMesh mesh = make_bumpy_sphere(0.1, run.pick(44, 12), 0.02, 60.0).value();
    const auto lump = ContactLevels::create(mesh, {.within_m = 1.0e-3}).value();
    const int n_steps = run.pick(2000, 120);
    const DeepPlay exact = play_deep(lump, n_steps, {});
    const auto add = [&](const std::string& name, DeepPlay played) {
        const double off = compute_off_percent(played.force_N, exact.force_N);
        const double most_us = std::ranges::max(played.us);
        const Cost cost = summarise(std::move(played.us));
        sheet.add({name, mesh.triangles().size(), rounded(cost.median_us, 1),
                   rounded(cost.p99_us, 1), rounded(most_us, 1), rounded(off, 1),
                   rounded(played.n_left, 1), rounded(played.n_coarser, 1),
                   rounded(1.0e3 * played.most_left_m, 1)});
    };
    add("nothing", exact);
    add("2.5 %", play_deep(lump, n_steps, {.tolerance_m = 0.025 * lump->size_m()}));
    add("2.5 %, the source's condition alone",
        play_deep(lump, n_steps, {.tolerance_m = 0.025 * lump->size_m(), .is_as_source = true}));
    for (const double budget_us : {100.0, 200.0, 500.0}) {
        add(to_text(budget_us) + " us", play_deep(lump, n_steps, {.budget_us = budget_us}));
    }
    return sheet;
}

Report run_contact_levels(Run& run) {
    CostCurve tolerance =
        make_curve("contact-levels", "Contact levels of detail by their tolerance",
                   {"tolerance, of the tool's radius", "%", true});
    tolerance.advice =
        "2.5 %: it moves surfaces out by no more, and saves most where much detail lies close "
        "together; none where each contact is to be exact.";
    CostCurve budget =
        make_curve("contact-levels-budget", "The same by a budget of time", {"budget", "us", true});
    budget.advice =
        "Enough for the exact answer most of the time; a smaller one is as a coarse tolerance.";
    Sheet made{
        "contact-levels-made",
        "What making contact levels takes",
        "one processor, once for a mesh; the tool of each scene",
        "Make them at load, once for each mesh, where a bar can be shown: they take seconds.",
        {"scene", "triangles", "pieces", "nodes", "levels", "s", "MB"}};
    std::vector<LevelScene> scenes = make_scenes(run);
    const auto n_scenes = static_cast<double>(scenes.size());
    double done = 0.0;
    for (LevelScene& scene : scenes) {
        run.progress(done / n_scenes, scene.name);
        const Course course = make_course(std::move(scene));
        list_levels(course, made);
        const double radius_m = course.levels.tool->size_m();
        for (const double percent : run.pick<std::vector<double>>(
                 {0.01, 0.03, 0.1, 0.3, 1.0, 2.5, 5.0, 10.0}, {0.1, 2.5})) {
            tolerance.points.push_back(
                measure_course(course, percent,
                               play_scene(course.scene, course.levels,
                                          {.tolerance_m = 0.01 * percent * radius_m})));
        }
        CostPoint theirs =
            measure_course(course, 2.5,
                           play_scene(course.scene, course.levels,
                                      {.tolerance_m = 0.025 * radius_m, .is_as_source = true}));
        theirs.series += ", the source's condition alone";
        tolerance.points.push_back(std::move(theirs));
        // It is what the others are held against.
        tolerance.points.push_back(measure_course(course, 0.001, course.exact));
        for (const double budget_us :
             run.pick<std::vector<double>>({20.0, 50.0, 100.0, 200.0, 500.0}, {100.0})) {
            budget.points.push_back(
                measure_course(course, budget_us,
                               play_scene(course.scene, course.levels, {.budget_us = budget_us})));
        }
        done += 1.0;
    }
    tolerance.default_series = tolerance.points.front().series;
    tolerance.default_knob = 2.5;
    budget.default_series = budget.points.front().series;
    budget.default_knob = run.pick(200.0, 100.0);
    return {tolerance, budget, made, make_deep_sheet(run)};
}

const Registration kContactLevels{
    {"contact-levels",
     "contact levels of detail: tolerance and budget against force error and time",
     run_contact_levels}};

}  // namespace
}  // namespace fulcrum::bench
