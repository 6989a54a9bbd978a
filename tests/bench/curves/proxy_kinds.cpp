// The proxies by name against each other: what a step costs, how far they are from the true nearest place, and how often they snag or
// leak; from a thousand to a million triangles.
//
// Time and snags: a ball with bumps of 3 %, pressed in 2 % of the radius, 4 radii a second at 1 kHz. Every pass does the same steps:
// the least time of a step over the passes is what it costs when the machine does nothing else. Error: inside a smooth ball, where
// there is one nearest place, found by asking every face. Leaks: slides along the seam of a body in two halves, not welded.
#include "haptics/collision/segment_query.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/make_proxy.h"
#include "haptics/point/plane_constraints.h"
#include "tests/bench/curves/bumpy_way.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/touchable.h"

namespace fulcrum::bench {
namespace {

constexpr double kRadius = 0.02;      // of the cursor that is a ball
constexpr double kHalfSide = 0.0115;  // of the cube within that ball
constexpr double kCrack = 1.0e-4;     // of the body's radius
constexpr int kSlides = 20;
constexpr double kFriction = 0.3;

struct Kind {
    std::string name;
    ProxySettings settings;
    double radius = 0.0;
    double friction = 0.0;
    bool is_round = true;
};

struct Figures {
    std::string kind;
    double n_triangles = 0.0;
    Cost cost{};
    double error = kNone;       // radii
    double snag_share = kNone;  // of steps
    double leak_share = kNone;  // of slides
};

std::unique_ptr<Proxy> make(const Kind& kind, const std::shared_ptr<const CollisionMesh>& mesh) {
    SolidPlan solid{.body = 0, .shape = mesh};
    solid.friction = {.static_coefficient = kind.friction, .dynamic_coefficient = kind.friction};
    return make_proxy(kind.settings, {solid}, {});
}

void measure_steps(const Kind& kind, const std::shared_ptr<const CollisionMesh>& mesh, int n_steps,
                   int n_passes, Figures& figures) {
    int n_snagged = 0;
    const auto proxy = make(kind, mesh);
    figures.cost = measure_passes(
        *proxy, make_hands(n_steps, Wanderer::kStep, kind.radius), n_passes,
        [&](const ProxyContact& contact, const Vector3& hand, bool is_warm) {
            n_snagged += is_warm && (contact.position_W - hand).norm() > 3.0 * kPressedIn ? 1 : 0;
        });
    figures.snag_share = n_snagged / static_cast<double>(n_steps - kWarmSteps);
}

// The plane that the place is furthest behind, of all faces of a convex body seen from inside; a zero normal when it is behind none.
PlaneConstraint find_most_violated(const CollisionMesh& mesh, double radius, const Vector3& place) {
    PlaneConstraint worst{.normal = Vector3::Zero()};
    double least = -1.0e-13;
    for (std::int32_t i = 0; i < mesh.n_triangles(); ++i) {
        const PreparedTriangle t = prepare_triangle(mesh, i);
        const Vector3 inwards = -t.doubled_area.normalized();
        const double height = inwards.dot(place - t.a) - radius;
        if (height < least) {
            least = height;
            worst = {inwards, inwards.dot(t.a) + radius};
        }
    }
    return worst;
}

// Of the body shrunk by the radius, the place nearest to the hand.
Vector3 find_nearest_within(const CollisionMesh& mesh, double radius, const Vector3& hand) {
    constexpr int kMostRounds = 100;
    std::vector<PlaneConstraint> acting;  // relative to the hand
    Vector3 place = hand;
    for (int round = 0; round < kMostRounds; ++round) {
        PlaneConstraint worst = find_most_violated(mesh, radius, place);
        if (worst.normal == Vector3::Zero()) {
            return place;
        }
        worst.offset_m -= worst.normal.dot(hand);
        acting.push_back(worst);
        const ConstrainedPoint found = compute_constrained_point(Vector3::Zero(), acting, 1.0e-12);
        place = hand + found.position;
        std::vector<PlaneConstraint> kept;
        for (std::size_t i = 0; i < static_cast<std::size_t>(found.n_active); ++i) {
            kept.push_back(acting[static_cast<std::size_t>(found.active[i])]);
        }
        acting = std::move(kept);
    }
    return Vector3::Constant(kNone);
}

double measure_error(const Kind& kind, const std::shared_ptr<const CollisionMesh>& mesh,
                     int n_places) {
    constexpr int kBetween = 37;  // steps
    const auto proxy = make(kind, mesh);
    Wanderer wanderer(3);
    proxy->reset(0.7 * wanderer.next());
    double worst = 0.0;
    for (int i = 0; i < n_places * kBetween; ++i) {
        const Vector3 hand = wanderer.next() * (1.0 - kind.radius + kPressedIn);
        const Vector3& at = proxy->step(hand, {}).position_W;
        if (i % kBetween == kBetween - 1) {
            worst = std::max(worst, (at - find_nearest_within(*mesh, kind.radius, hand)).norm());
        }
    }
    return worst;
}

double measure_leaks(const Kind& kind, int frequency) {
    const auto mesh = touchable(make_cracked(*make_sphere(1.0, frequency), kCrack, 41, 0.0));
    int n_leaks = 0;
    for (unsigned slide = 0; slide < kSlides; ++slide) {
        const auto proxy = make(kind, mesh);
        Random random(400U + slide);
        const double begin = 3.0 * random.uniform();
        double height = 0.0;
        Vector3 at;
        for (int i = 0; i < 1000; ++i) {
            height = 0.95 * height + 5.0e-3 * random.uniform();
            const double turn = begin + 0.004 * i;
            const Vector3 hand = (1.0 - 0.05) * Vector3(std::sin(turn), height, std::cos(turn));
            if (i == 0) {
                proxy->reset(1.3 * hand);
            }
            at = proxy->step(hand, {}).position_W;
        }
        n_leaks += find_nearest_hit(*mesh, at, 4.0 * at.normalized()).found() ? 1 : 0;
    }
    return n_leaks / static_cast<double>(kSlides);
}

LineChart draw(const std::vector<Figures>& all, const std::vector<Kind>& kinds) {
    LineChart chart;
    chart.name = "proxy-kinds-cost";
    chart.title = "A step of each proxy against the number of triangles";
    chart.work =
        "A hand slides over a ball with bumps of 3 %, pressed in 2 % of the radius at 4 radii a "
        "second, 1 kHz; the ball cursor has 2 % of the radius, the cube fits into it.";
    chart.advice =
        "A point where meshes are closed; a ball where they may have cracks: it pays for every "
        "triangle that it covers.";
    chart.x = {"triangles", "", true};
    chart.y = {"time a step", "µs", true};
    for (const Kind& kind : kinds) {
        chart.draw(
            kind.name, all, [&](const Figures& one) { return one.kind == kind.name; },
            [](const Figures& one) { return one.n_triangles; },
            [](const Figures& one) { return one.cost.median_us; });
    }
    return chart;
}

Sheet list(const std::vector<Figures>& all, const LineChart& chart) {
    Sheet sheet{"proxy-kinds",
                "The proxies against each other",
                chart.work +
                    " Error inside a smooth ball against the nearest place of all faces, where "
                    "nothing rubs; leaks along cracks of 1e-4 of the radius, not welded.",
                chart.advice,
                {"triangles", "proxy", "median µs", "99 % µs", "error, radii",
                 "snagged share of steps", "leaked share of slides"}};
    for (const Figures& one : all) {
        sheet.add({one.n_triangles, one.kind, one.cost.median_us, one.cost.p99_us, one.error,
                   one.snag_share, one.leak_share});
    }
    return sheet;
}

Report run_proxy_kinds(Run& run) {
    const SphereShape ball{kRadius};
    const std::vector<Kind> kinds{
        {"god-object", {.kind = ProxyKind::god_object}},
        {"virtual proxy, ball of 2 %", {.kind = ProxyKind::virtual_proxy, .cursor = ball}, kRadius},
        {"friction cone, point", {.kind = ProxyKind::friction_cone}, 0.0, kFriction},
        {"friction cone, ball of 2 %",
         {.kind = ProxyKind::friction_cone, .cursor = ball},
         kRadius,
         kFriction},
        {"virtual proxy, cube of 2 %",
         {.kind = ProxyKind::virtual_proxy, .cursor = BoxShape{Vector3::Constant(kHalfSide)}},
         kHalfSide,
         0.0,
         false}};
    const auto frequencies = run.pick<std::vector<int>>({7, 22, 71, 224}, {7, 22, 71});
    std::vector<Figures> all;
    double done = 0.0;
    for (const int frequency : frequencies) {
        const auto bumpy = touchable(make_bumpy_sphere(1.0, frequency, kBumpHeight, kBumpsRound));
        const auto smooth = touchable(make_sphere(1.0, frequency));
        for (const Kind& kind : kinds) {
            Figures figures{kind.name, static_cast<double>(bumpy->n_triangles())};
            run.progress(done, std::to_string(bumpy->n_triangles()) + " triangles, " + kind.name);
            measure_steps(kind, bumpy, run.pick(20000, 4000), run.pick(7, 3), figures);
            if (kind.friction == 0.0 && kind.is_round) {
                figures.error = measure_error(kind, smooth, run.pick(60, 10));
            }
            figures.leak_share = measure_leaks(kind, frequency);
            all.push_back(figures);
            done += 1.0 / static_cast<double>(frequencies.size() * kinds.size());
        }
    }
    LineChart chart = draw(all, kinds);
    Sheet sheet = list(all, chart);
    return {std::move(chart), std::move(sheet)};
}

const Registration kProxyKinds{
    {"proxy-kinds", "the proxies by name: time, error, snags and leaks", run_proxy_kinds}};

}  // namespace
}  // namespace fulcrum::bench
