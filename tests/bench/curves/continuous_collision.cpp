// When triangles and meshes on their way first touch: tolerance against time, and what is missed.
#include "haptics/continuous/interval_sweep.h"
#include "haptics/continuous/mesh_sweep.h"
#include "haptics/continuous/triangle_sweep.h"
#include "tests/bench/curves/continuous_ways.h"

#include <string>
#include <vector>

namespace fulcrum::bench {
namespace {

using SweepOf = TriangleSweep (*)(const InBetweenMotion&, const Triangle&, const MovingTriangle&,
                                  const SweepSettings&, double, double);

double time_of(const auto& told) {
    return told.outcome == SweepOutcome::free ? 2.0 : told.contact.time;
}

CostCurve make_curve(const std::string& name, const std::string& title,
                     const std::string& default_series) {
    CostCurve curve;
    curve.name = name;
    curve.title = title;
    curve.knob = {"tolerance", "m", true};
    curve.error = {"error along the way, 99 %", "um", true};
    curve.extras = {{"missed", "%"}, {"told falsely", "%"}, {"latest behind the contact", "um"}};
    curve.default_series = default_series;
    curve.default_knob = SweepSettings{}.tolerance_m;
    return curve;
}

CostPoint measure_sweep(const Run& run, const std::string& series, SweepOf sweep,
                        double tolerance_m) {
    return measure_pairs(run, series, tolerance_m, [sweep, tolerance_m](const KnownPair& known) {
        const InBetweenMotion motion = known.pair.motion();
        return time_of(sweep(motion, known.pair.fixed_A,
                             MovingTriangle::of(motion, known.pair.moving_B),
                             {.touch_m = 0.0, .tolerance_m = tolerance_m}, 0.0, 1.0));
    });
}

CostCurve measure_triangles(Run& run) {
    CostCurve curve = make_curve("continuous-collision",
                                 "When two triangles on their way first touch", "Newton steps");
    curve.work =
        "Pairs of triangles about a metre large, half of them by chance, half hard ones of twelve "
        "kinds (grazing, sliding, coincident edges, slivers, half turns, in one plane, bullets, "
        "far from the origin; gaps from a nanometre to a micrometre); the in-between motion is "
        "made anew for each";
    curve.reference =
        "a judge in 64-bit mantissas that walks all of the way; the error is how far apart the "
        "told and the true contact are along the way, 99 % of them below. Where a way grazes, a "
        "tolerance is worth a long way.";
    curve.advice =
        "A micrometre; what is told falsely lies within the tolerance, so a smaller one tells less "
        "of it, at little cost.";
    const auto tolerances = run.pick<std::vector<double>>(
        {1.0e-9, 1.0e-8, 1.0e-7, 1.0e-6, 1.0e-5, 1.0e-4, 1.0e-3}, {1.0e-8, 1.0e-6, 1.0e-4});
    double done = 0.0;
    for (const double tolerance_m : tolerances) {
        run.progress(0.5 * done++ / static_cast<double>(tolerances.size()), "triangles");
        curve.points.push_back(measure_sweep(run, "Newton steps", sweep_triangles, tolerance_m));
        curve.points.push_back(
            measure_sweep(run, "intervals alone", sweep_triangles_by_intervals, tolerance_m));
    }
    return curve;
}

CostCurve measure_meshes(Run& run) {
    CostCurve curve = make_curve("continuous-collision-meshes",
                                 "When a mesh on its way first touches another", "27380 triangles");
    curve.work =
        "Two bumpy balls of 0.2 m, half a millimetre apart; one goes a millimetre or two towards "
        "the other and turns by up to 0.01 rad, 200 ways; processor time";
    curve.reference = "converged: our own at a tolerance of 0.1 nm";
    curve.advice =
        "A micrometre costs hardly more than a tenth of a millimetre: boxes take most of the time.";
    const auto tolerances =
        run.pick<std::vector<double>>({1.0e-9, 1.0e-8, 1.0e-7, 1.0e-6, 1.0e-5, 1.0e-4}, {1.0e-6});
    double done = 0.0;
    for (const int frequency : run.pick<std::vector<int>>({6, 20, 37}, {6, 37})) {
        const MeshWays& ways = get_mesh_ways(frequency);
        const auto mesh = SweptMesh::create(ways.mesh);
        const std::string series = std::to_string(mesh->n_triangles()) + " triangles";
        run.progress(0.5 + 0.15 * done++, series);
        for (const double tolerance_m : tolerances) {
            curve.points.push_back(measure_ways(ways, series, tolerance_m, 200, [&](std::size_t i) {
                const InBetweenMotion motion(ways.ways[i].first, ways.ways[i].second);
                return time_of(sweep_meshes(*mesh, *mesh, motion,
                                            {.touch_m = 0.0, .tolerance_m = tolerance_m}));
            }));
            curve.points.back().cost.bytes = mesh->memory_bytes();
        }
    }
    return curve;
}

Report run_continuous_collision(Run& run) {
    return {measure_triangles(run), measure_meshes(run)};
}

const Registration kContinuousCollision{
    {"continuous-collision",
     "when triangles and meshes on their way first touch: tolerance against time, and what is "
     "missed",
     run_continuous_collision}};

}  // namespace
}  // namespace fulcrum::bench
