// The settings worth choosing: those for which no other is both faster and more exact.
#pragma once

#include "tests/bench/harness/report.h"

#include <cstddef>
#include <vector>

namespace fulcrum::bench {

/// Indices of the points that no other point beats: p is beaten when another has error <= p's and median time <= p's, one
/// of them less. Points without an error or a time are never in it. In the order of growing time.
[[nodiscard]] std::vector<std::size_t> find_pareto_front(const std::vector<CostPoint>& points);

/// The index of the default's point; points.size() when it is not among them.
[[nodiscard]] std::size_t find_default(const CostCurve& curve);

}  // namespace fulcrum::bench
