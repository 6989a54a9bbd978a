#include "tests/bench/harness/pareto.h"

#include <catch2/catch.hpp>

namespace fulcrum::bench {
namespace {

CostPoint point(double time_us, double error) {
    return {"s", 0.0, error, {time_us, time_us, 0}, {}};
}

TEST_CASE("pareto: only what nothing beats stays, from the fastest on") {
    const std::vector<CostPoint> points{point(4, 1),     point(1, 8), point(2, 8),      point(2, 3),
                                        point(3, kNone), point(8, 1), point(kNone, 0.1)};
    CHECK(find_pareto_front(points) == std::vector<std::size_t>{1, 3, 0});
}

TEST_CASE("pareto: of two alike one stays, and of nothing nothing") {
    CHECK(find_pareto_front({point(1, 1), point(1, 1)}).size() == 1);
    CHECK(find_pareto_front({}).empty());
}

TEST_CASE("pareto: no point of the front is beaten, and every other one is", "[property]") {
    std::vector<CostPoint> points;
    for (int i = 0; i < 200; ++i) {
        points.push_back(point(1 + (i * 37) % 101, 1 + (i * 61) % 89));
    }
    const auto front = find_pareto_front(points);
    const auto beats = [&](const CostPoint& a, const CostPoint& b) {
        return a.error <= b.error && a.cost.median_us <= b.cost.median_us &&
               (a.error < b.error || a.cost.median_us < b.cost.median_us);
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool in_front = std::find(front.begin(), front.end(), i) != front.end();
        const bool beaten = std::any_of(points.begin(), points.end(),
                                        [&](const CostPoint& p) { return beats(p, points[i]); });
        CHECK((!in_front || !beaten));
        // One of several alike stands for all.
        const bool stands_in = std::any_of(front.begin(), front.end(), [&](std::size_t k) {
            return points[k].error == points[i].error &&
                   points[k].cost.median_us == points[i].cost.median_us;
        });
        CHECK((in_front || beaten || stands_in));
    }
}

TEST_CASE("pareto: the default is found by its series and its knob") {
    CostCurve curve;
    curve.points = {{"a", 1, 0, {}, {}}, {"b", 1, 0, {}, {}}, {"b", 2, 0, {}, {}}};
    curve.default_series = "b";
    curve.default_knob = 2;
    CHECK(find_default(curve) == 2);
    curve.default_knob = 3;
    CHECK(find_default(curve) == 3);
}

}  // namespace
}  // namespace fulcrum::bench
