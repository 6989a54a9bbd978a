// How finely a surface must be divided: the god-object's force on a meshed ball and ring against that of the true surface.
//
//   true force   k d n: stiffness times depth along the normal of the true surface
//   theory       for a ball of n facets like equilateral triangles, whose corners lie alpha^2 = 16 pi / (3 sqrt(3) n) off the
//                facet's normal: at an angle theta from it the force errs by k R (theta^2 - alpha^2) / 2 and by theta in
//                direction. Over the facet the mean of theta^2 is alpha^2 / 4, that of theta^4 alpha^4 / 10, so the root
//                mean square is sqrt(3/5) k R alpha^2 / 2 and alpha / 2: orders 2 and 1 in the edges' length.
#include "haptics/coupling/coupling_settings.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "runtime/scene/shape_models.h"
#include "tests/bench/curves/felt_surface.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

namespace fulcrum::bench {
namespace {

constexpr double kRing_m = 0.2;  // of the middle of the tube

// The same speed over the tube; the course bends by chance.
Course wander_on_ring(int n_steps) {
    Course course;
    Random random(82);
    double round = 0.0;  // about the ring's axis
    double tilt = 0.0;   // about the tube's middle
    double heading = 0.4;
    for (int i = 0; i < n_steps; ++i) {
        heading += 0.02 * random.uniform();
        tilt += Wanderer::kStep * std::cos(heading);
        round += Wanderer::kStep * kRadius_m * std::sin(heading) /
                 (kRing_m + kRadius_m * std::cos(tilt));
        const Vector3 outwards(std::sin(round), 0.0, std::cos(round));
        const Vector3 normal = std::cos(tilt) * outwards + std::sin(tilt) * Vector3::UnitY();
        course.push_back({kRing_m * outwards + (kRadius_m - kDepth_m) * normal, normal});
    }
    return course;
}

void press(GodObject& proxy, const Pressed& pressed) {
    proxy.reset(pressed.hand_W + 10.0 * kDepth_m * pressed.normal_W);
    proxy.step(pressed.hand_W, {});
}

CostPoint measure(const std::string& series, const Expected<TriangleMesh>& mesh,
                  const Course& course) {
    const auto solid = touchable(mesh);
    GodObject proxy(only_solid(solid));
    const auto restart = [&] { press(proxy, course.front()); };
    restart();
    return measure_felt(
        series, solid->n_triangles(), course, solid->memory_bytes(),
        [&](const Vector3& hand_W) {
            const ProxyContact& contact = proxy.step(hand_W, {});
            return Felt{kStiffness_N_per_m * (contact.position_W - hand_W), contact.normal_W,
                        contact.solid != kNoBody};
        },
        restart);
}

constexpr std::size_t kDirectionColumn = 2;
constexpr std::size_t kOrderColumn = 5;  // of the force, then of the direction

// Order in the edges' length, which is as 1 / sqrt(triangles), from one resolution to the next of the same series.
void add_orders(std::vector<CostPoint>& points) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const CostPoint& coarse = points[i - 1];
        CostPoint& fine = points[i];
        if (coarse.series == fine.series) {
            const double finer = 0.5 * std::log(fine.knob / coarse.knob);
            fine.extras[kOrderColumn] = std::log(coarse.error / fine.error) / finer;
            fine.extras[kOrderColumn + 1] =
                std::log(coarse.extras[kDirectionColumn] / fine.extras[kDirectionColumn]) / finer;
        }
    }
}

CostCurve measure_curve(Run& run) {
    CostCurve curve;
    curve.name = "mesh-resolution";
    curve.title = "Mesh resolution against the force of the true surface";
    curve.work =
        "A hand slides over a ball of 0.1 m and a ring whose tube is as thick, 2 mm (2 %) deep at "
        "4 radii a second, 1 kHz; the god-object touches the mesh, the coupling's default 500 N/m "
        "makes 1 N of it.";
    curve.reference =
        "analytic: stiffness times depth along the normal of the true surface; the error is that "
        "of the force's magnitude, root mean square over all steps";
    curve.advice =
        "Take the coarsest mesh whose direction error can't be felt: four times the triangles "
        "quarter the error in newtons but only halve that in degrees, and each factor of ten costs "
        "ten times the memory and little time.";
    curve.knob = {"triangles", "", true};
    curve.error = {"force error", "N", true};
    curve.extras = surface_columns();
    curve.default_series = "ball";
    curve.default_knob = 20.0 * runtime::kSphereModelFrequency * runtime::kSphereModelFrequency;

    const int n_steps = run.pick(20000, 4000);
    const Course on_ball = wander_on_ball(n_steps);
    const Course on_ring = wander_on_ring(n_steps);
    const std::vector<int> frequencies = ball_frequencies(run.quick());
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
        run.progress(i, 2 * frequencies.size(), "ball");
        curve.points.push_back(measure("ball", make_sphere(kRadius_m, frequencies[i]), on_ball));
    }
    const std::vector<int> rounds =
        run.pick<std::vector<int>>({5, 9, 16, 28, 54, 89, 158, 282, 500}, {5, 16, 54, 158});
    for (std::size_t i = 0; i < rounds.size(); ++i) {
        run.progress(rounds.size() + i, 2 * rounds.size(), "ring");
        curve.points.push_back(
            measure("ring", make_torus(kRing_m, kRadius_m, 2 * rounds[i], rounds[i]), on_ring));
    }
    add_orders(curve.points);
    return curve;
}

// One quantity of the curve's points against the number of triangles, with what theory says for the ball.
LineChart draw_against_triangles(const CostCurve& curve,
                                 const std::function<double(const CostPoint&)>& quantity,
                                 const std::function<double(double)>& theory) {
    LineChart chart;
    chart.work = curve.work;
    chart.x = curve.knob;
    for (const std::string series : {"ball", "ring"}) {
        chart.draw(
            series, curve.points, [&](const CostPoint& point) { return point.series == series; },
            [](const CostPoint& point) { return point.knob; }, quantity);
    }
    const std::vector<double> on_ball = chart.lines.front().x;
    chart.trace("theory for the ball", LineStyle::theory, on_ball, theory);
    return chart;
}

double corner_angle_squared(double n_triangles) {
    return 16.0 * std::numbers::pi / (3.0 * std::sqrt(3.0) * n_triangles);
}

Report run_mesh_resolution(Run& run) {
    CostCurve curve = measure_curve(run);
    LineChart force = draw_against_triangles(
        curve, [](const CostPoint& p) { return p.error; },
        [](double n) {
            return std::sqrt(0.6) * 0.5 * kStiffness_N_per_m * kRadius_m * corner_angle_squared(n);
        });
    force.name = "mesh-resolution-force";
    force.title = "Force error against the number of triangles";
    force.reference = "theory: as 1 / triangles, the square of the edges' length";
    force.advice =
        "Once the facets lie less deep in the true surface than the hand, ten times the triangles "
        "give a tenth of the error.";
    force.y = curve.error;
    LineChart direction = draw_against_triangles(
        curve, [](const CostPoint& p) { return p.extras[kDirectionColumn]; },
        [](double n) {
            return 0.5 * std::sqrt(corner_angle_squared(n)) * 180.0 / std::numbers::pi;
        });
    direction.name = "mesh-resolution-direction";
    direction.title = "Direction error against the number of triangles";
    direction.reference = "theory: as 1 / sqrt(triangles), the edges' length";
    direction.advice =
        "Facets are felt by the direction of the force first: halving its error takes four times "
        "the triangles.";
    direction.y = curve.extras[kDirectionColumn];
    return {std::move(curve), std::move(force), std::move(direction)};
}

const Registration kMeshResolution{
    {"mesh-resolution", "how finely a surface must be divided", run_mesh_resolution}};

}  // namespace
}  // namespace fulcrum::bench
