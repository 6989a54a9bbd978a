#include "tests/bench/peers/felt_ball.h"

#include "haptics/geometry/shape.h"
#include "tests/bench/harness/measure.h"
#include "tests/bench/harness/registry.h"

#include <stdexcept>

namespace fulcrum::bench {
namespace {

std::vector<CostPoint> measure_peer(const std::string& name, const MakeFeltBall& make,
                                    const Run& run) {
    constexpr int kWarmUp = 300;
    const Course course = wander_on_ball(run.pick(20000, 4000));
    std::vector<CostPoint> points;
    for (const int frequency : ball_frequencies(run.quick())) {
        const auto mesh = make_sphere(kRadius_m, frequency);
        if (!mesh) {
            throw std::runtime_error(to_sentence(mesh.error()));
        }
        const double n_triangles = 20.0 * frequency * frequency;
        // An icosahedron's edge subtends 63.4 degrees.
        constexpr double kIcosahedronEdge_rad = 1.107;
        const FeltBall ball = make(*mesh, kRadius_m * kIcosahedronEdge_rad / frequency);
        const SurfaceErrors errors = find_errors(course, ball.feel);
        std::size_t next = 0;
        const Cost cost = measure_cost(
            [&] { keep(ball.feel(course[next++].hand_W)); },
            {.samples = static_cast<int>(course.size()) - kWarmUp, .batch = 1, .warm_up = kWarmUp},
            ball.bytes);
        points.push_back(make_point(name, n_triangles, errors, cost));
    }
    return points;
}

}  // namespace

FeltBallRegistration::FeltBallRegistration(const std::string& name, const MakeFeltBall& make) {
    PeerRegistration(
        {name, "mesh-resolution", [=](Run& run) { return measure_peer(name, make, run); }});
}

}  // namespace fulcrum::bench
