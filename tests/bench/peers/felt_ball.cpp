#include "tests/bench/peers/felt_ball.h"

#include "haptics/geometry/shape.h"
#include "tests/bench/harness/must.h"
#include "tests/bench/harness/registry.h"

namespace fulcrum::bench {
namespace {

std::vector<CostPoint> measure_peer(const std::string& name, const MakeFeltBall& make,
                                    const Run& run) {
    const Course course = wander_on_ball(run.pick(20000, 4000));
    std::vector<CostPoint> points;
    for (const int frequency : ball_frequencies(run.quick())) {
        const TriangleMesh mesh = must(make_sphere(kRadius_m, frequency));
        const double n_triangles = 20.0 * frequency * frequency;
        // An icosahedron's edge subtends 63.4 degrees.
        constexpr double kIcosahedronEdge_rad = 1.107;
        const FeltBall ball = make(mesh, kRadius_m * kIcosahedronEdge_rad / frequency);
        points.push_back(measure_felt(name, n_triangles, course, ball.bytes, ball.feel));
    }
    return points;
}

}  // namespace

FeltBallRegistration::FeltBallRegistration(const std::string& name, const MakeFeltBall& make) {
    PeerRegistration(
        {name, "mesh-resolution", [=](Run& run) { return measure_peer(name, make, run); }});
}

}  // namespace fulcrum::bench
