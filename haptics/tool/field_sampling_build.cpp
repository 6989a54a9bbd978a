// The load-path half of field_sampling.h.
#include "haptics/base/range.h"
#include "haptics/tool/field_sampling.h"

#include <algorithm>
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

namespace {

double find_deepest_voxels(const DistanceField& field) {
    const double band_voxels = field.band_m() / field.frame().voxel_m;
    const auto deepest = std::max_element(field.depths().begin(), field.depths().end());
    return deepest == field.depths().end() ? band_voxels
                                           : std::max(band_voxels, static_cast<double>(*deepest));
}

}  // namespace

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
      slope_boxes_(*field_),
      deepest_voxels_(find_deepest_voxels(*field_)),
      kernels_(&best_field_kernels()),
      leaf_us_(settings.leaf_us),
      group_us_(settings.group_us),
      slopes_us_(static_cast<double>(slopes_leaves()) * settings.leaf_us) {
    for (std::size_t l = 0; l < shell_->n_levels(); ++l) {
        Level level;
        level.free_until.assign(ShellTree::kWidth * shell_->level(l).size(), kAlways);
        level.hopeless_until.assign(shell_->level(l).size(), kAlways);
        level.groups.reserve(shell_->level(l).size());
        levels_.push_back(std::move(level));
    }
    const std::size_t n_most = levels_.front().free_until.size();
    nodes_.reserve(n_most);
    leaves_.reserve(n_most);
    parts_.reserve(n_most);
    chosen_.reserve(n_most);
    more_parts_.reserve(n_most);
    for (std::size_t m = 1; m < shell_->n_thinnings(); ++m) {
        thinned_until_.emplace_back(shell_->n_leaves(m), kAlways);
    }
    if (settings_.budget_us > 0.0 && shell_->n_thinnings() > 1) {
        seen_samples_.reserve(shell_->n_leaves(1));
    }
    touched_.reserve(2 * n_most);  // leaves of thinnings first, then the leaves themselves
    last_touched_.reserve(2 * n_most);
    depths_.resize(n_most);
    seen_.resize(n_most);
    for (std::size_t leaf = 0; leaf < n_most; ++leaf) {
        const EightBalls& balls = shell_->level(0)[leaf / ShellTree::kWidth];
        seen_[leaf].radius_voxels =
            bounds_.voxels_per_metre * balls.radius[leaf % ShellTree::kWidth];
    }
    ranks_.resize(n_most);
}

std::size_t FieldSampler::memory_bytes() const noexcept {
    std::size_t bytes = sizeof(*this) + nodes_.memory_bytes() + leaves_.memory_bytes() +
                        parts_.memory_bytes() + chosen_.memory_bytes() +
                        more_parts_.memory_bytes() + touched_.memory_bytes() +
                        last_touched_.memory_bytes() + 2 * depths_.capacity() * sizeof(float) +
                        seen_.capacity() * sizeof(Seen) + slope_boxes_.memory_bytes() +
                        seen_samples_.memory_bytes();
    for (const Level& level : levels_) {
        bytes += (level.free_until.capacity() + level.hopeless_until.capacity()) * sizeof(float) +
                 level.groups.memory_bytes();
    }
    for (const std::vector<float>& until : thinned_until_) {
        bytes += until.capacity() * sizeof(float);
    }
    return bytes;
}

}  // namespace fulcrum
