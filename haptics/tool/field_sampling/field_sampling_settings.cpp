#include "haptics/tool/field_sampling/field_sampling_settings.h"

#include "haptics/base/range.h"

#include <array>

namespace fulcrum {

Expected<void> validate(const FieldSamplingSettings& settings) {
    const bool has_budget = settings.budget_us != 0.0;
    const std::array<Range, 4> ranges{
        {{"stiffness_N_per_m", settings.stiffness_N_per_m, 0.0, 1.0e6},
         {"budget_us", settings.budget_us, has_budget ? 5.0 : 0.0, 1.0e5},
         {"leaf_us", settings.leaf_us, 0.01, 10.0},
         {"group_us", settings.group_us, 0.01, 10.0}}};
    if (auto checked = check_ranges("the field sampling's", ranges); !checked) {
        return checked;
    }
    if (has_budget && settings.mode != SamplingMode::coherent) {
        return fail("a budget of time for sampling that remembers nothing", {},
                    "take the coherent mode, or no budget");
    }
    return {};
}

}  // namespace fulcrum
