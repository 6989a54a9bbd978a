#include "haptics/tool/field_sampling/sample_units.h"

#include <algorithm>

namespace fulcrum {

void SampleUnits::list(const NodeList& nodes, std::size_t level, std::size_t thinning,
                       std::size_t n_units, const FreeLeaves& known) noexcept {
    const std::size_t as_level = 3 * level;
    const std::size_t merge = thinning - std::min(thinning, as_level);
    const std::size_t split = as_level - std::min(thinning, as_level);
    all_.clear();
    due_.clear();
    std::size_t next = 0;
    for (const std::int32_t node : nodes) {
        const std::size_t first = static_cast<std::size_t>(node) >> merge << split;
        // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): at most 3 times the level
        const std::size_t n_parts = std::size_t{1} << split;
        const std::size_t end = std::min(first + n_parts, n_units);
        for (std::size_t unit = std::max(first, next); unit < end; ++unit) {
            all_.add(static_cast<std::int32_t>(unit));
            if (known.may_touch(unit)) {
                due_.add(static_cast<std::int32_t>(unit));
            }
        }
        next = std::max(next, end);
    }
}

void SampleUnits::list_due(const NodeList& units, const FreeLeaves& known) noexcept {
    all_.copy(units);
    due_.clear();
    for (const std::int32_t unit : units) {
        if (known.may_touch(static_cast<std::size_t>(unit))) {
            due_.add(unit);
        }
    }
}

}  // namespace fulcrum
