#include "tests/bench/harness/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace fulcrum::bench {

std::vector<std::size_t> find_pareto_front(const std::vector<CostPoint>& points) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::isfinite(points[i].error) && std::isfinite(points[i].cost.median_us)) {
            order.push_back(i);
        }
    }
    std::ranges::sort(order, {}, [&](std::size_t i) {
        return std::tuple(points[i].cost.median_us, points[i].error, i);
    });
    // From the fastest on, each that is more exact than all before it.
    std::vector<std::size_t> front;
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        if (points[i].error < least) {
            least = points[i].error;
            front.push_back(i);
        }
    }
    return front;
}

std::size_t find_default(const CostCurve& curve) {
    const auto found = std::ranges::find_if(curve.points, [&](const CostPoint& p) {
        return p.series == curve.default_series && p.knob == curve.default_knob;
    });
    return static_cast<std::size_t>(found - curve.points.begin());
}

}  // namespace fulcrum::bench
