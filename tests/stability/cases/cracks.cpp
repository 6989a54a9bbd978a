// A body whose two halves don't meet: cracks of 1e-5 and 1e-4 m along the seam, closed at load, and a hand that slides along them.
#include "haptics/geometry/mesh_report.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <cmath>

namespace fulcrum::stability {
namespace {

constexpr double kRadius_m = 0.1;
constexpr int kSlides = 50;
constexpr int kSteps = 1000;

// A star-shaped body: from a point inside, the way straight out meets it.
bool is_inside(const CollisionMesh& mesh, const Vector3& p_B) {
    return find_nearest_hit(mesh, p_B, p_B + 4.0 * kRadius_m * p_B.normalized()).found();
}

// Slides that ended inside, of kSlides along the seam, each back and forth across it.
int count_leaks(const CollisionMesh& mesh) {
    const std::shared_ptr<const CollisionMesh> shared(&mesh, [](const auto*) {});
    int n_leaks = 0;
    for (int slide = 0; slide < kSlides; ++slide) {
        GodObject proxy(only_solid(shared));
        Random random(400U + static_cast<unsigned>(slide));
        const double begin = 3.0 * random.uniform();
        const double pressed_m = kRadius_m * (0.93 + 0.03 * random.uniform());
        double height_m = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            const double turn = begin + 0.004 * i;
            height_m = 0.95 * height_m + 5.0e-4 * random.uniform();
            const Vector3 hand_W(pressed_m * std::sin(turn), height_m, pressed_m * std::cos(turn));
            if (i == 0) {
                proxy.reset(1.5 * hand_W);
            }
            proxy.step(hand_W, {});
        }
        n_leaks += is_inside(mesh, proxy.contact().position_W) ? 1 : 0;
    }
    return n_leaks;
}

// Built as any model is, and with its cracks left open beside it.
Finding slide_along_crack(double crack_m) {
    const auto body = make_bumpy_sphere(kRadius_m, 12, 0.03, 5.0);
    const auto open = make_cracked(*body, crack_m, 41, 0.0);
    const auto closed = TriangleMesh::build(open->vertices_B(), open->triangles());
    const MeshReport report = compute_mesh_report(*closed);
    const int n_leaks = count_leaks(*touchable(closed));
    return {
        report.is_closed() && report.closed_cracks == 1 ? static_cast<double>(n_leaks) : HUGE_VAL,
        0.0,
        "of 50; left open " + std::to_string(count_leaks(*touchable(open))) + " leak at " +
            std::to_string(compute_mesh_report(*open).open_edges) + " open edges"};
}

constexpr const char* kWhat = "the hand slides 50 times along a seam that was closed at load";
constexpr const char* kMeasured = "slides after which the proxy was inside";

const HardCase kCrack{{"a crack of 1e-5 m along a seam", kWhat, kMeasured, "",
                       [] { return slide_along_crack(1.0e-5); }}};
const HardCase kWideCrack{{"a crack of 1e-4 m along a seam", kWhat, kMeasured, "",
                           [] { return slide_along_crack(1.0e-4); }}};

}  // namespace
}  // namespace fulcrum::stability
