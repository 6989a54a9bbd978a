// What a step of the god-object costs against the number of triangles, beside the simple proxy that it replaces and a plain
// scan; and what the structure costs that makes it fast.
//
// A bumpy ball (3 % bumps), pressed in 2 % of the radius, 4 radii a second at 1 kHz. Each step is timed by itself, and every
// pass does the same steps: the least time of a step over the passes is what it costs when the machine does nothing else.
//
// At one speed a finer mesh has more edges to cross in a tick, so it is also measured at a quarter of an edge a tick: there the work of
// a tick is the same on every mesh, and what is left to grow is the search for triangles, log n, and how far away in memory they are.
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "tests/bench/curves/one_constraint_proxy.h"
#include "tests/bench/harness/csv.h"
#include "tests/bench/harness/measure.h"
#include "tests/bench/harness/registry.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numbers>

namespace fulcrum::bench {
namespace {

constexpr double kDepth = 0.02;
constexpr double kHeight = 0.03;
constexpr double kBumps = 20.0;
constexpr int kWarmUp = 200;
constexpr double kFelt = 0.1;           // of the depth: less is no touch to speak of
constexpr int kLargestScanned = 11000;  // triangles; beyond, a plain scan only takes longer
constexpr double kEdgesPerTick = 0.25;

double bumpy_radius(const Vector3& u) {
    return 1.0 +
           kHeight *
               (std::sin(kBumps * u.x()) + std::sin(kBumps * u.y()) + std::sin(kBumps * u.z())) /
               3.0;
}

// The length of an edge, radii, of a ball of so many triangles that are alike.
double edge_length(double n_triangles) {
    return std::sqrt(16.0 * std::numbers::pi / (std::numbers::sqrt3 * n_triangles));
}

std::vector<Vector3> make_hands(int n, double step) {
    Wanderer wanderer(1, step);
    std::vector<Vector3> hands;
    for (int i = 0; i < n; ++i) {
        const Vector3& u = wanderer.next();
        hands.emplace_back(u * (bumpy_radius(u) - kDepth));
    }
    return hands;
}

// One method on one mesh.
struct Figures {
    std::string method;
    double n_triangles = 0.0;
    double median_us = kNone;
    double p99_us = kNone;
    double worst_turn_deg = kNone;  // of the force from one tick to the next
    double worst_gap = kNone;       // between proxy and hand, radii
};

double now_us() {
    return std::chrono::duration<double, std::micro>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

void take_quantiles(std::vector<double> us, Figures& figures) {
    std::sort(us.begin(), us.end());
    figures.median_us = us[us.size() / 2];
    figures.p99_us = us[us.size() * 99 / 100];
}

Figures measure_proxy(const std::string& method, Proxy& proxy, const CollisionMesh& mesh,
                      const std::vector<Vector3>& hands, int n_passes) {
    Figures figures{method, static_cast<double>(mesh.n_triangles())};
    std::vector<double> least_us(hands.size(), HUGE_VAL);
    double worst_turn = 0.0;
    double worst_gap = 0.0;
    for (int pass = 0; pass < n_passes; ++pass) {
        proxy.reset(1.1 * hands[0]);
        Vector3 before = Vector3::Zero();
        for (std::size_t i = 0; i < hands.size(); ++i) {
            const double begin_us = now_us();
            const ProxyContact& contact = proxy.step(hands[i], {});
            least_us[i] = std::min(least_us[i], now_us() - begin_us);
            const double gap = (contact.position_W - hands[i]).norm();
            // A force near zero may turn any way.
            const Vector3 normal =
                gap > kFelt * kDepth ? contact.normal_W : Vector3(Vector3::Zero());
            if (i >= kWarmUp) {
                worst_turn = std::max(worst_turn,
                                      std::atan2(before.cross(normal).norm(), before.dot(normal)));
                worst_gap = std::max(worst_gap, gap);
            }
            before = normal;
        }
    }
    least_us.erase(least_us.begin(), least_us.begin() + kWarmUp);
    take_quantiles(std::move(least_us), figures);
    figures.worst_turn_deg = worst_turn * 180.0 / std::numbers::pi;
    figures.worst_gap = worst_gap;
    return figures;
}

// One search through all triangles a step, from where the god-object is to the hand.
Figures measure_scan(const std::string& method, const CollisionMesh& mesh, GodObject& proxy,
                     const std::vector<Vector3>& hands, int n_steps, int n_passes) {
    Figures figures{method, static_cast<double>(mesh.n_triangles())};
    std::vector<double> us;
    proxy.reset(1.1 * hands[0]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(n_steps); ++i) {
        const Vector3 from = proxy.step(hands[i], {}).position_W;
        double least_us = HUGE_VAL;
        for (int pass = 0; pass < n_passes; ++pass) {
            const double begin_us = now_us();
            keep(find_nearest_hit_brute_force(mesh, from, hands[i]).triangle);
            least_us = std::min(least_us, now_us() - begin_us);
        }
        us.push_back(least_us);
    }
    take_quantiles(std::move(us), figures);
    return figures;
}

// Of this thread alone, so that a build's time does not count what other programs take.
double cpu_now_ms() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1.0e3 * static_cast<double>(time.tv_sec) + 1.0e-6 * static_cast<double>(time.tv_nsec);
}

struct Build {
    double n_triangles = 0.0;
    double ms = HUGE_VAL;
    double megabytes = 0.0;
};

Build measure_build(const TriangleMesh& mesh, int n_builds) {
    Build build;
    for (int i = 0; i < n_builds; ++i) {
        const double begin_ms = cpu_now_ms();
        const auto made = touchable(mesh);
        build = {static_cast<double>(made->n_triangles()),
                 std::min(build.ms, cpu_now_ms() - begin_ms),
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
    const double grown = finest->median_us / coarsest->median_us;
    const double log_coarsest = std::log(coarsest->n_triangles);
    const double log_finest = std::log(finest->n_triangles);
    return {std::log(grown) / (log_finest - log_coarsest), grown * log_coarsest / log_finest};
}

constexpr const char* kWork =
    "A hand slides over a ball with bumps of 3 %, 2 % of the radius deep at 4 radii a second, "
    "1 kHz, or at a quarter of an edge a tick; the least time of each step over all passes, then "
    "the "
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
        Line median{method, LineStyle::measured, {}, {}};
        Line tail{method + ", 99 %", LineStyle::measured, {}, {}};
        for (const Figures& one : all) {
            if (one.method == method) {
                median.x.push_back(one.n_triangles);
                median.y.push_back(one.median_us);
                tail.x.push_back(one.n_triangles);
                tail.y.push_back(one.p99_us);
            }
        }
        chart.lines.push_back(std::move(median));
        chart.lines.push_back(std::move(tail));
    }
    const Line& even = chart.lines[2];
    Line theory{"log n", LineStyle::theory, even.x, {}};
    for (const double n_triangles : even.x) {
        theory.y.push_back(even.y.front() * std::log(n_triangles) / std::log(even.x.front()));
    }
    chart.lines.push_back(std::move(theory));
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
    Line measured{"measured", LineStyle::measured, {}, {}};
    Line theory{"n log n", LineStyle::theory, {}, {}};
    const double last = builds.back().n_triangles * std::log(builds.back().n_triangles);
    for (const Build& build : builds) {
        measured.x.push_back(build.n_triangles);
        measured.y.push_back(build.ms);
        theory.x.push_back(build.n_triangles);
        theory.y.push_back(builds.back().ms * build.n_triangles * std::log(build.n_triangles) /
                           last);
    }
    chart.lines = {std::move(measured), std::move(theory)};
    return chart;
}

Sheet list_all(const std::vector<Figures>& all, const std::vector<Build>& builds) {
    Sheet sheet;
    sheet.name = "god-object";
    sheet.title = "The god-object and what it replaces";
    sheet.work = kWork;
    sheet.advice =
        "Solve all constraints: of one a tick the force jumps by tens of degrees between ticks, on "
        "fine meshes too, and it saves no time.";
    sheet.columns = {"triangles",
                     "method",
                     "median µs",
                     "99 % µs",
                     "growth exponent of the median",
                     "growth of the median, of that of log n",
                     "most the force turned in a tick, degrees",
                     "largest gap to the hand, radii",
                     "build ms",
                     "memory MB"};
    for (const Figures& one : all) {
        const auto build = std::ranges::find(builds, one.n_triangles, &Build::n_triangles);
        const Growth growth = find_growth(all, one.method);
        sheet.rows.push_back({to_text(one.n_triangles), one.method, to_text(one.median_us),
                              to_text(one.p99_us), to_text(growth.exponent), to_text(growth.of_log),
                              to_text(one.worst_turn_deg), to_text(one.worst_gap),
                              to_text(build->ms), to_text(build->megabytes)});
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
        const auto source = make_bumpy_sphere(1.0, frequencies[i], kHeight, kBumps);
        const auto mesh = touchable(source);
        run.progress(static_cast<double>(i) / static_cast<double>(frequencies.size()),
                     std::to_string(mesh->n_triangles()) + " triangles");
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
