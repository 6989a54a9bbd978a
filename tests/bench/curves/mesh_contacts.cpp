// What it costs to find where a body of triangles with a hollow touches a ball: cells of its field and places on its surface against
// the error of the gap, where that is known in closed form.
#include "haptics/collision/sampled_contacts.h"
#include "haptics/geometry/shape.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

namespace fulcrum::bench {
namespace {

constexpr double kRing_m = 0.1;
constexpr double kTube_m = 0.03;
constexpr double kBall_m = 0.02;
constexpr double kGap_m = 1.0e-4;
constexpr double kMargin_m = 2.0e-3;
constexpr int kPlaces = 400;

// Balls that lie 0.1 mm over the tube, anywhere on it.
std::vector<ContactPlace> make_places() {
    Random random(5);
    std::vector<ContactPlace> places;
    for (int i = 0; i < kPlaces; ++i) {
        const double round = std::numbers::pi * random.uniform();
        const double up = std::numbers::pi * random.uniform();
        const Vector3 outwards(std::cos(round), 0.0, std::sin(round));
        const Vector3 normal = std::cos(up) * outwards + std::sin(up) * Vector3::UnitY();
        places.push_back(ContactPlace::of(
            {kRing_m * outwards + (kTube_m + kBall_m + kGap_m) * normal, random.turn(3.0)}));
    }
    return places;
}

double find_least_gap_m(std::span<const ContactManifold> manifolds) {
    double least_m = kMargin_m;
    for (const ContactManifold& manifold : manifolds) {
        for (const ContactPoint& point : manifold.points()) {
            least_m = std::min(least_m, point.gap_m);
        }
    }
    return least_m;
}

CostPoint measure_places(const SampledShape& ring, const SampledShape& ball,
                         const std::vector<ContactPlace>& places, const std::string& series,
                         double knob) {
    const ContactPlace at_ring = ContactPlace::of(Pose{});
    std::vector<double> us;
    double worst_m = 0.0;
    for (const ContactPlace& place : places) {
        std::array<ContactManifold, kMostPatches> manifolds{};
        std::array<ContactManifold*, kMostPatches> patches{};
        for (std::size_t i = 0; i < patches.size(); ++i) {
            patches[i] = &manifolds[i];
        }
        time_batches(
            [&] {
                find_sampled_contacts({ball, place}, {ring, at_ring}, kBall_m,
                                      {.margin_m = kMargin_m}, patches);
            },
            {.samples = 3, .batch = 1, .warm_up = 1}, us);
        worst_m = std::max(worst_m, std::abs(find_least_gap_m(manifolds) - kGap_m));
    }
    return {series, knob, 1.0e6 * worst_m, summarise(std::move(us), ring.memory_bytes()), {}};
}

Report run_mesh_contacts(Run& run) {
    CostCurve curve;
    curve.name = "mesh-contacts";
    curve.title = "Where a ball touches a ring of triangles";
    curve.work =
        "A ball of 20 mm lies 0.1 mm over a ring of 0.26 m with a tube of 60 mm, of 115 200 "
        "triangles, at 400 places; all its contacts are found anew.";
    curve.reference =
        "analytic: the gap of a ball and a torus; the triangles' chords are 6 um of it";
    curve.advice =
        "96 cells and 1024 places hold the gap within a tenth of a millimetre or so; more of both "
        "cost memory and little time.";
    curve.knob = {"cells along the longest side", "", true};
    curve.error = {"largest error of the gap", "um", true};
    curve.default_series = "1024 places";
    curve.default_knob = SampledShapeSettings{}.n_cells;
    const SolidShape mesh(touchable(make_torus(kRing_m, kTube_m, 480, 120)));
    const auto ball = SampledShape::make(SphereShape{kBall_m}).value();
    const auto places = make_places();
    const auto cells = run.pick<std::vector<int>>({32, 64, 96, 192, 384}, {32, 96});
    const auto numbers = run.pick<std::vector<int>>({256, 1024, 4096}, {1024});
    double done = 0.0;
    for (const int n_places : numbers) {
        for (const int n_cells : cells) {
            const std::string series = std::to_string(n_places) + " places";
            run.progress(done++ / static_cast<double>(cells.size() * numbers.size()), series);
            const auto ring =
                SampledShape::make(mesh, {.n_cells = n_cells, .n_face_places = n_places}).value();
            curve.points.push_back(measure_places(*ring, *ball, places, series, n_cells));
        }
    }
    return {std::move(curve)};
}

const Registration kMeshContacts{
    {"mesh-contacts",
     "a ball on a ring of triangles: cells and places against the error of the gap and time",
     run_mesh_contacts}};

}  // namespace
}  // namespace fulcrum::bench
