// The load-path half of field_sampling.h.
#include "haptics/base/range.h"
#include "haptics/tool/field_sampling.h"

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
    if (has_budget && settings.mode == SamplingMode::brute_force) {
        return fail("a budget of time for sampling by brute force", {},
                    "take the tree or coherent sampling, or no budget");
    }
    return {};
}

Expected<FieldSampler> FieldSampler::build(Field field, Shell shell,
                                           const FieldSamplingSettings& settings) {
    if (field == nullptr || shell == nullptr) {
        return fail("field sampling without a field or without a shell", {}, "give it both");
    }
    if (auto valid = validate(settings); !valid) {
        return tl::unexpected(valid.error());
    }
    return FieldSampler(std::move(field), std::move(shell), settings);
}

FieldSampler::FieldSampler(Field field, Shell shell, const FieldSamplingSettings& settings)
    : field_(std::move(field)),
      shell_(std::move(shell)),
      settings_(settings),
      bounds_(*field_),
      kernels_(&best_field_kernels()) {
    for (std::size_t l = 0; l < shell_->n_levels(); ++l) {
        Level level;
        level.free_until.assign(ShellTree::kWidth * shell_->level(l).size(), kAlways);
        level.groups.reserve(shell_->level(l).size());
        levels_.push_back(std::move(level));
    }
    nodes_.reserve(levels_.front().free_until.size());
}

std::size_t FieldSampler::memory_bytes() const noexcept {
    std::size_t bytes = sizeof(*this) + nodes_.memory_bytes();
    for (const Level& level : levels_) {
        bytes += level.free_until.capacity() * sizeof(float) + level.groups.memory_bytes();
    }
    return bytes;
}

}  // namespace fulcrum
