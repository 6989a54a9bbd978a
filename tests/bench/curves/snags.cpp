// Does the god-object snag or leak on a mesh? On our own shapes, or on any file: fulcrum bench snags --mesh FILE.
//
// A guide wanders over the surface, 4 radii a second at 1 kHz: each tick it goes on in its tangent's direction and to the
// nearest place of the mesh around. The hand is 2 % of the radius behind it, along a normal that follows the facet's in some ticks.
//   snagged   the proxy is further than three depths from the hand, where all facets within two depths of the guide are within 60
//             degrees of each other
//   leaked    nothing holds the proxy, a surface lies between it and the guide's outside, and it is inside the body: the solid angle
//             of all triangles seen from it is more than half the full one, which also tells for a body with holes. (Free behind
//             a thin ridge is no leak: the point went round it.)
// A way ends before the rim of a hole, where the point may rightly slip in, and where the guide would pass through another part of
// the mesh; another begins somewhere else.
#include "haptics/collision/self_intersection.h"
#include "haptics/geometry/mesh_edges.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "tests/bench/curves/mesh_file.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/god_scene.h"
#include "tests/support/nearest_point.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <filesystem>
#include <stdexcept>

namespace fulcrum::bench {
namespace {

constexpr double kDepth = 0.02;   // radii
constexpr double kTick = 0.004;   // radii: 4 a second at 1 kHz
constexpr double kFar = 3.0;      // depths: further is a snag
constexpr double kFollow = 0.05;  // of the way to the facet's normal in a tick
constexpr double kSmoothCosine = 0.5;
constexpr int kTicksACourse = 2000;

using Mesh = std::shared_ptr<const CollisionMesh>;

Vector3 normal_of(const CollisionMesh& mesh, std::int32_t triangle) {
    return prepare_triangle(mesh, triangle).doubled_area.normalized();
}

// Where the hand's way leads over the surface.
class Guide {
  public:
    Guide(const CollisionMesh& mesh, unsigned seed) : mesh_(mesh), random_(seed) {
        const auto triangle = static_cast<std::int32_t>(
            random_.integer() % static_cast<std::uint64_t>(mesh.n_triangles()));
        const PreparedTriangle t = prepare_triangle(mesh, triangle);
        place_ = (t.a + t.b + t.c) / 3.0;
        normal_ = normal_of(mesh, triangle);
        facet_ = normal_;
        way_ = random_.direction();
    }

    void step() {
        way_ += 0.05 * random_.vector();
        way_ = (way_ - way_.dot(facet_) * facet_).normalized();
        const double reach_m = kTick * mesh_.radius_m();
        const Vector3 wish = place_ + reach_m * way_;
        const Vector3 half = Vector3::Constant(1.5 * reach_m);
        double least_m = HUGE_VAL;
        mesh_.tree().for_each_in_box({wish - half, wish + half}, [&](std::int32_t triangle) {
            const PreparedTriangle t = prepare_triangle(mesh_, triangle);
            const Vector3 here = find_nearest_on_triangle(wish, t.a, t.b, t.c);
            if ((here - wish).norm() < least_m) {
                least_m = (here - wish).norm();
                place_ = here;
                facet_ = t.doubled_area.normalized();
                // The same side of the surface, whichever way its triangles look.
                facet_ *= facet_.dot(normal_) < 0.0 ? -1.0 : 1.0;
            }
        });
        normal_ = (normal_ + kFollow * facet_).normalized();
        way_ *= least_m < HUGE_VAL ? 1.0 : -1.0;  // a rim: back
    }
    [[nodiscard]] const Vector3& place() const { return place_; }
    [[nodiscard]] const Vector3& normal() const { return normal_; }
    /// Just outside the surface.
    [[nodiscard]] Vector3 outside() const {
        return place_ + 0.1 * kDepth * mesh_.radius_m() * normal_;
    }
    [[nodiscard]] bool is_near_rim(const std::vector<bool>& is_rim) const {
        const Vector3 half = Vector3::Constant(4.0 * kDepth * mesh_.radius_m());
        bool near = false;
        mesh_.tree().for_each_in_box({place_ - half, place_ + half}, [&](std::int32_t triangle) {
            for (const std::int32_t corner : mesh_.corners(triangle)) {
                near = near || is_rim[static_cast<std::size_t>(corner)];
            }
        });
        return near;
    }
    [[nodiscard]] bool is_smooth() const {
        const Vector3 half = Vector3::Constant(2.0 * kDepth * mesh_.radius_m());
        bool smooth = true;
        mesh_.tree().for_each_in_box({place_ - half, place_ + half}, [&](std::int32_t triangle) {
            smooth = smooth && std::abs(normal_of(mesh_, triangle).dot(facet_)) > kSmoothCosine;
        });
        return smooth;
    }

  private:
    const CollisionMesh& mesh_;
    Random random_;
    Vector3 place_;
    Vector3 normal_;  // follows the facet's
    Vector3 facet_;
    Vector3 way_;
};

struct Tally {
    int n_steps = 0;
    int n_smooth = 0;
    int n_snagged = 0;
    int n_leaked = 0;
    double worst_gap = 0.0;  // radii, where it is smooth
    std::vector<double> us;
};

// Which of the mesh's vertices lie at an open edge.
std::vector<bool> find_rim(const CollisionMesh& mesh) {
    std::vector<bool> is_rim(mesh.vertices_B().size(), false);
    const std::vector<MeshEdge> edges = collect_edges(mesh.triangles(), is_rim.size());
    for_each_shared_edge(edges, [&is_rim](std::span<const MeshEdge> shared) {
        if (shared.size() == 1) {
            is_rim[static_cast<std::size_t>(shared.front().low)] = true;
            is_rim[static_cast<std::size_t>(shared.front().high)] = true;
        }
    });
    return is_rim;
}

void run_course(const TriangleMesh& source, const Mesh& mesh, const std::vector<bool>& is_rim,
                unsigned seed, Tally& tally) {
    Guide guide(*mesh, seed);
    GodObject proxy(only_solid(mesh));
    const double depth_m = kDepth * mesh->radius_m();
    proxy.reset(guide.outside());
    for (int i = 0; i < kTicksACourse; ++i) {
        const Vector3 before = guide.outside();
        guide.step();
        if (guide.is_near_rim(is_rim) || find_nearest_hit(*mesh, before, guide.outside()).found()) {
            return;
        }
        // In deeper tick by tick, so that the hand does not jump through all at the start.
        const double deep_m = depth_m * std::min(1.0, i / 50.0);
        const Vector3 hand_W = guide.place() - deep_m * guide.normal();
        tally.us.push_back(time_by_clock_us([&] { keep(proxy.step(hand_W, {}).n_constraints); }));
        const ProxyContact& contact = proxy.contact();
        const double gap_m = (contact.position_W - hand_W).norm();
        const bool is_behind = find_nearest_hit(*mesh, hand_W, guide.outside()).found();
        ++tally.n_steps;
        tally.n_leaked += is_behind && contact.solid == kNoBody &&
                                  std::abs(test::find_winding(source, contact.position_W)) > 0.5
                              ? 1
                              : 0;
        if (guide.is_smooth()) {
            ++tally.n_smooth;
            tally.n_snagged += gap_m > kFar * depth_m ? 1 : 0;
            tally.worst_gap = std::max(tally.worst_gap, gap_m / mesh->radius_m());
        }
    }
}

void measure(const std::string& name, const TriangleMesh& source, Run& run, Sheet& sheet) {
    const Mesh mesh = touchable(source);
    const std::vector<bool> is_rim = find_rim(*mesh);
    const int n_steps = run.pick(200000, 40000);
    Tally tally;
    // Ways end early on meshes with holes; there are so many of them.
    constexpr unsigned kMostCourses = 20000;
    for (unsigned course = 0; course < kMostCourses && tally.n_steps < n_steps; ++course) {
        run.progress(static_cast<double>(tally.n_steps) / n_steps, name);
        run_course(source, mesh, is_rim, course, tally);
    }
    if (tally.n_steps == 0) {
        throw std::runtime_error("no way on the mesh " + name + " is free of rims");
    }
    const Cost cost = summarise(std::move(tally.us));
    sheet.add({name, static_cast<double>(mesh->n_triangles()), tally.n_steps, tally.n_smooth,
               tally.n_snagged, tally.n_leaked, tally.worst_gap, cost.median_us, cost.p99_us,
               to_sentence(compute_full_mesh_report(source))});
}

Report run_snags(Run& run) {
    Sheet sheet{
        "snags",
        "Snags and leaks of the god-object",
        "A hand slides 2 % of the radius behind a surface at 4 radii a second, 1 kHz. Snagged: "
        "further than three depths from the hand where the surface is smooth. Leaked: held by "
        "nothing, inside the body.",
        "Try your own: fulcrum bench snags --mesh FILE, an OBJ, GLB or glTF file.",
        {"mesh", "triangles", "steps", "on smooth surface", "snagged", "leaked",
         "largest gap there, radii", "median µs", "99 % µs", "report"}};
    if (!run.mesh_file().empty()) {
        measure(std::filesystem::path(run.mesh_file()).filename(),
                must(load_mesh_file(run.mesh_file())), run, sheet);
        return {sheet};
    }
    for (const int frequency : run.pick<std::vector<int>>({7, 22, 71, 224}, {22, 71})) {
        measure("bumpy ball", *make_bumpy_sphere(1.0, frequency, 0.03, 20.0), run, sheet);
    }
    for (const int n_ring : run.pick<std::vector<int>>({36, 354, 1120}, {354})) {
        measure("ring", *make_torus(1.0, 0.4, n_ring, n_ring * 2 / 5), run, sheet);
    }
    return {sheet};
}

const Registration kSnags{
    {"snags", "snags and leaks of the god-object, on our shapes or with --mesh FILE", run_snags}};

}  // namespace
}  // namespace fulcrum::bench
