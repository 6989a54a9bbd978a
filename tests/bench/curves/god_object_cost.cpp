#include "haptics/collision/segment_query.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "haptics/point/proxy.h"
#include "tests/bench/curves/bumpy_way.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/touchable.h"

namespace fulcrum::bench {
namespace {

// The simple proxy that the god-object replaces: the hand's foot on the plane touched last, then on to what the sweep there meets,
// one constraint a tick. It needs several ticks into a corner and trembles on finely divided surfaces; kept as the thing to beat.

class OneConstraintProxy final : public Proxy {
  public:
    /// One mesh that stands still at the origin.
    explicit OneConstraintProxy(std::shared_ptr<const CollisionMesh> mesh)
        : mesh_(std::move(mesh)) {}
    void reset(const Vector3& hand_W) noexcept override;
    void put_solid(std::size_t /*solid*/, const Pose& /*pose_W*/) noexcept override {}
    const ProxyContact& step(const Vector3& hand_W,
                             std::span<const Pose> solid_poses_W) noexcept override;

  private:
    void take_plane(const SegmentHit& hit) noexcept;

    std::shared_ptr<const CollisionMesh> mesh_;
    ProxyContact contact_;
    Vector3 normal_{Vector3::UnitY()};
    Vector3 point_{Vector3::Zero()};
    bool touching_ = false;
};

constexpr double kGap_m = 1.0e-9;  // how high above a plane it is held

void OneConstraintProxy::reset(const Vector3& hand_W) noexcept {
    contact_ = {.position_W = hand_W};
    touching_ = false;
}

const ProxyContact& OneConstraintProxy::step(const Vector3& hand_W,
                                             std::span<const Pose> /*solid_poses_W*/) noexcept {
    Vector3 target = hand_W;
    if (touching_ && normal_.dot(hand_W - point_) < 0.0) {
        target -= normal_ * (normal_.dot(hand_W - point_) - kGap_m);
    }
    const SegmentHit hit = find_nearest_hit(*mesh_, contact_.position_W, target);
    touching_ = touching_ || hit.found();
    if (!hit.found()) {
        contact_.position_W = target;
        const SegmentHit below = find_nearest_hit(*mesh_, target, hand_W);
        touching_ = below.found();
        take_plane(below);
    } else {
        const Vector3 way = target - contact_.position_W;
        take_plane(hit);
        const double fall = -normal_.dot(way);
        contact_.position_W += std::max(0.0, hit.t - (fall > 0.0 ? kGap_m / fall : 0.0)) * way;
    }
    const Vector3 push = contact_.position_W - hand_W;
    contact_.n_constraints = touching_ ? 1 : 0;
    contact_.normal_W = push.squaredNorm() > 0.0 ? Vector3(push.normalized()) : push;
    return contact_;
}

void OneConstraintProxy::take_plane(const SegmentHit& hit) noexcept {
    if (hit.found()) {
        const PreparedTriangle triangle = prepare_triangle(*mesh_, hit.triangle);
        normal_ = triangle.doubled_area.normalized() * (hit.side < 0 ? -1.0 : 1.0);
        point_ = triangle.a;
    }
}

// What a step of the god-object costs against the number of triangles, beside the simple proxy that it replaces and a plain
// scan; and what the structure costs that makes it fast.
//
// A bumpy ball (3 % bumps), pressed in 2 % of the radius, 4 radii a second at 1 kHz. Each step is timed by itself, and every
// pass does the same steps: the least time of a step over the passes is what it costs when the machine does nothing else.
//
// At one speed a finer mesh has more edges to cross in a tick, so it is also measured at a quarter of an edge a tick: there the work of
// a tick is the same on every mesh, and what is left to grow is the search for triangles, log n, and how far away in memory they are.

constexpr double kFelt = 0.1;           // of the depth: less is no touch to speak of
constexpr int kLargestScanned = 11000;  // triangles; beyond, a plain scan only takes longer
constexpr double kEdgesPerTick = 0.25;

// The length of an edge, radii, of a ball of so many triangles that are alike.
double edge_length(double n_triangles) {
    return std::sqrt(16.0 * std::numbers::pi / (std::numbers::sqrt3 * n_triangles));
}

// One method on one mesh.
struct Figures {
    std::string method;
    double n_triangles = 0.0;
    Cost cost{};
    double worst_turn_deg = kNone;  // of the force from one tick to the next
    double worst_gap = kNone;       // between proxy and hand, radii
};

Figures measure_proxy(const std::string& method, Proxy& proxy, const CollisionMesh& mesh,
                      const std::vector<Vector3>& hands, int n_passes) {
    Vector3 before = Vector3::Zero();
    double worst_turn = 0.0;
    double worst_gap = 0.0;
    const Cost cost = measure_passes(
        proxy, hands, n_passes,
        [&](const ProxyContact& contact, const Vector3& hand, bool is_warm) {
            const double gap = (contact.position_W - hand).norm();
            // A force near zero may turn any way.
            const Vector3 normal = gap > kFelt * kPressedIn ? contact.normal_W : Vector3::Zero();
            if (is_warm) {
                worst_turn = std::max(worst_turn,
                                      std::atan2(before.cross(normal).norm(), before.dot(normal)));
                worst_gap = std::max(worst_gap, gap);
            }
            before = normal;
        });
    return {method, static_cast<double>(mesh.n_triangles()), cost,
            worst_turn * 180.0 / std::numbers::pi, worst_gap};
}

// One search through all triangles a step, from where the god-object is to the hand.
Figures measure_scan(const std::string& method, const CollisionMesh& mesh, GodObject& proxy,
                     const std::vector<Vector3>& hands, int n_steps, int n_passes) {
    std::vector<double> us;
    proxy.reset(1.1 * hands[0]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(n_steps); ++i) {
        const Vector3 from = proxy.step(hands[i], {}).position_W;
        double least_us = HUGE_VAL;
        for (int pass = 0; pass < n_passes; ++pass) {
            least_us = std::min(least_us, time_by_clock_us([&] {
                                    keep(find_nearest_hit_brute_force(mesh, from, hands[i]));
                                }));
        }
        us.push_back(least_us);
    }
    return {method, static_cast<double>(mesh.n_triangles()), summarise(std::move(us))};
}

struct Build {
    double n_triangles = 0.0;
    double ms = HUGE_VAL;
    double megabytes = 0.0;
};

Build measure_build(const TriangleMesh& mesh, int n_builds) {
    Build build;
    for (int i = 0; i < n_builds; ++i) {
        std::shared_ptr<const CollisionMesh> made;
        const Took took = time_once([&] { made = touchable(mesh); });
        build = {static_cast<double>(made->n_triangles()), std::min(build.ms, 1.0e-3 * took.own_us),
                 static_cast<double>(made->memory_bytes()) / 1.0e6};
    }
    return build;
}

struct Growth {
    double exponent = kNone;  // p of time ~ triangles^p
    double of_log = kNone;    // the medians' ratio, of that of the logarithms
};

// From the coarsest to the finest mesh of a method, by its medians.
Growth find_growth(const std::vector<Figures>& all, const std::string& method) {
    const auto is_of_it = [&](const Figures& one) { return one.method == method; };
    const auto coarsest = std::ranges::find_if(all, is_of_it);
    const auto finest = std::find_if(all.rbegin(), all.rend(), is_of_it);
    if (finest->n_triangles == coarsest->n_triangles) {
        return {};
    }
    const double grown = finest->cost.median_us / coarsest->cost.median_us;
    const double log_coarsest = std::log(coarsest->n_triangles);
    const double log_finest = std::log(finest->n_triangles);
    return {std::log(grown) / (log_finest - log_coarsest), grown * log_coarsest / log_finest};
}

constexpr const char* kWork =
    "A hand slides over a ball with bumps of 3 %, 2 % of the radius deep at 4 radii a second, 1 "
    "kHz, or at a quarter of an edge a tick; the least time of each step over all passes, then the "
    "median and 99 % of the steps.";

LineChart draw_steps(const std::vector<Figures>& all, const std::vector<std::string>& methods) {
    LineChart chart;
    chart.name = "god-object-cost";
    chart.title = "A step of the god-object against the number of triangles";
    chart.work = kWork;
    chart.reference =
        "beside it a proxy with one constraint a tick, and a search through all triangles for one "
        "segment; theory: as log n, through the coarsest mesh at a quarter of an edge a tick";
    chart.advice =
        "Take the mesh as fine as the touch needs it: a million triangles still leave 99 % of a "
        "millisecond free.";
    chart.x = {"triangles", "", true};
    chart.y = {"time a step", "µs", true};
    for (const std::string& method : methods) {
        const auto is_of_it = [&](const Figures& one) { return one.method == method; };
        const auto n_triangles = [](const Figures& one) { return one.n_triangles; };
        chart.draw(method, all, is_of_it, n_triangles,
                   [](const Figures& one) { return one.cost.median_us; });
        chart.draw(method + ", 99 %", all, is_of_it, n_triangles,
                   [](const Figures& one) { return one.cost.p99_us; });
    }
    const Line even = chart.lines[2];
    chart.trace("log n", LineStyle::theory, even.x, [&](double n_triangles) {
        return even.y.front() * std::log(n_triangles) / std::log(even.x.front());
    });
    return chart;
}

LineChart draw_builds(const std::vector<Build>& builds) {
    LineChart chart;
    chart.name = "god-object-build";
    chart.title = "Making a mesh touchable";
    chart.work = "The bounding tree is built over the mesh once, at load; processor time.";
    chart.reference = "theory: as n log n, through the largest mesh";
    chart.advice = "Up to 100 000 triangles no one waits; a million take part of a second at load.";
    chart.x = {"triangles", "", true};
    chart.y = {"time to build", "ms", true};
    const auto is_any = [](const Build&) { return true; };
    const auto n_triangles = [](const Build& build) { return build.n_triangles; };
    const Build& last = builds.back();
    chart.draw("measured", builds, is_any, n_triangles,
               [](const Build& build) { return build.ms; });
    chart.draw("n log n", builds, is_any, n_triangles, [&](const Build& build) {
        return last.ms * build.n_triangles * std::log(build.n_triangles) /
               (last.n_triangles * std::log(last.n_triangles));
    });
    chart.lines.back().style = LineStyle::theory;
    return chart;
}

Sheet list_all(const std::vector<Figures>& all, const std::vector<Build>& builds) {
    Sheet sheet{
        "god-object",
        "The god-object and what it replaces",
        kWork,
        "Solve all constraints: of one a tick the force jumps by tens of degrees between ticks, on "
        "fine meshes too, and it saves no time.",
        {"triangles", "method", "median µs", "99 % µs", "growth exponent of the median",
         "growth of the median, of that of log n", "most the force turned in a tick, degrees",
         "largest gap to the hand, radii", "build ms", "memory MB"}};
    for (const Figures& one : all) {
        const auto build = std::ranges::find(builds, one.n_triangles, &Build::n_triangles);
        const Growth growth = find_growth(all, one.method);
        sheet.add({one.n_triangles, one.method, one.cost.median_us, one.cost.p99_us,
                   growth.exponent, growth.of_log, one.worst_turn_deg, one.worst_gap, build->ms,
                   build->megabytes});
    }
    return sheet;
}

Report run_god_object(Run& run) {
    const std::vector<std::string> methods{"god-object", "god-object, a quarter of an edge a tick",
                                           "one constraint a tick", "plain scan, one segment"};
    const int n_steps = run.pick(20000, 4000);
    const std::vector<Vector3> hands = make_hands(n_steps, Wanderer::kStep);
    const int n_passes = run.pick(7, 3);
    const std::vector<int> frequencies =
        run.pick<std::vector<int>>({4, 7, 13, 22, 40, 71, 126, 224}, {7, 22, 71});
    std::vector<Figures> all;
    std::vector<Build> builds;
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
        const auto source = make_bumpy_sphere(1.0, frequencies[i], kBumpHeight, kBumpsRound);
        const auto mesh = touchable(source);
        run.progress(i, frequencies.size(), std::to_string(mesh->n_triangles()) + " triangles");
        builds.push_back(measure_build(*source, run.pick(5, 2)));
        GodObject god_object(only_solid(mesh));
        all.push_back(measure_proxy(methods[0], god_object, *mesh, hands, n_passes));
        const double step = kEdgesPerTick * edge_length(mesh->n_triangles());
        all.push_back(
            measure_proxy(methods[1], god_object, *mesh, make_hands(n_steps, step), n_passes));
        OneConstraintProxy simple(mesh);
        all.push_back(measure_proxy(methods[2], simple, *mesh, hands, n_passes));
        if (mesh->n_triangles() <= kLargestScanned) {
            all.push_back(
                measure_scan(methods[3], *mesh, god_object, hands, run.pick(1000, 400), n_passes));
        }
    }
    return {draw_steps(all, methods), draw_builds(builds), list_all(all, builds)};
}

const Registration kGodObject{
    {"god-object", "a step of the god-object against the number of triangles", run_god_object}};

}  // namespace
}  // namespace fulcrum::bench
