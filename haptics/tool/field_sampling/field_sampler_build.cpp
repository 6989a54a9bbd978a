// The load-path half of field_sampler.h and of all its parts: what they make room for.
#include "haptics/tool/field_sampling/field_sampler.h"

#include <algorithm>

namespace fulcrum {
namespace {

double find_deepest_voxels(const DistanceField& field) {
    const double band_voxels = field.band_m() / field.frame().voxel_m;
    const auto deepest = std::max_element(field.depths().begin(), field.depths().end());
    return deepest == field.depths().end() ? band_voxels
                                           : std::max(band_voxels, static_cast<double>(*deepest));
}

}  // namespace

SeenLeaves::SeenLeaves(const SampledPair& pair) : boxes_(*pair.field), seen_(pair.n_most_nodes()) {
    for (std::size_t leaf = 0; leaf < seen_.size(); ++leaf) {
        const EightBalls& balls = pair.shell->level(0)[leaf / ShellTree::kWidth];
        seen_[leaf].radius_voxels =
            pair.bounds.voxels_per_metre * balls.radius[leaf % ShellTree::kWidth];
    }
}

FreeMemory::FreeMemory(const SampledPair& pair) : seen_(pair) {
    const ShellTree& shell = *pair.shell;
    for (std::size_t l = 0; l < shell.n_levels(); ++l) {
        const std::size_t n_groups = shell.level(l).size();
        levels_.push_back(
            {std::vector<float>(ShellTree::kWidth * n_groups), std::vector<float>(n_groups)});
    }
    for (std::size_t m = 1; m < shell.n_thinnings(); ++m) {
        thinned_until_.emplace_back(shell.n_leaves(m));
    }
    reset();
}

std::size_t FreeMemory::memory_bytes() const noexcept {
    std::size_t bytes = seen_.memory_bytes();
    for (const Level& level : levels_) {
        bytes += (level.until.capacity() + level.hopeless_until.capacity()) * sizeof(float);
    }
    for (const std::vector<float>& until : thinned_until_) {
        bytes += until.capacity() * sizeof(float);
    }
    return bytes;
}

ShellSearch::ShellSearch(const SampledPair& pair)
    : groups_(pair.shell->n_levels()), depths_(pair.n_most_nodes()) {
    for (std::size_t l = 0; l < groups_.size(); ++l) {
        groups_[l].reserve(pair.shell->level(l).size());
    }
    nodes_.reserve(pair.n_most_nodes());
}

std::size_t ShellSearch::memory_bytes() const noexcept {
    std::size_t bytes = nodes_.memory_bytes() + depths_.capacity() * sizeof(float);
    for (const NodeList& groups : groups_) {
        bytes += groups.memory_bytes();
    }
    return bytes;
}

LeafSums::LeafSums(const SampledPair& pair, const FieldSamplingSettings& settings)
    : along_(settings.along) {
    // With a budget leaves of thinnings first, then the leaves themselves.
    touched_.reserve((settings.budget_us > 0.0 ? 2 : 1) * pair.n_most_nodes());
}

LookError::LookError(const SampledPair& pair, const FieldSamplingSettings& settings)
    : stiffness_N_per_m_(settings.stiffness_N_per_m),
      slope_(settings.along == ForceAlong::slopes ? pair.field->slope_bound() : 1.0),
      deepest_voxels_(find_deepest_voxels(*pair.field)) {}

LookStages::LookStages(const SampledPair& pair, const FieldSamplingSettings& settings)
    : memory(pair), search(pair), sums(pair, settings), time(settings), error(pair, settings) {}

std::size_t LookStages::memory_bytes() const noexcept {
    return memory.memory_bytes() + search.memory_bytes() + sums.memory_bytes();
}

void CloserLook::reserve(const SampledPair& pair) {
    const std::size_t n_most = pair.n_most_nodes();
    for (NodeList* list : {&units_, &parts_, &more_, &scratch_}) {
        list->reserve(n_most);
    }
    ranks_.resize(n_most);
    if (pair.shell->n_thinnings() > 1) {
        seen_.reserve(pair.shell->n_leaves(1));
    }
}

std::size_t CloserLook::memory_bytes() const noexcept {
    return units_.memory_bytes() + parts_.memory_bytes() + more_.memory_bytes() +
           scratch_.memory_bytes() + ranks_.capacity() * sizeof(float) + seen_.memory_bytes();
}

void BudgetLook::reserve(const SampledPair& pair) {
    units_.reserve(pair.n_most_nodes());
    thinned_.reserve(pair);
    deepest_.reserve(pair);
    choice_.reserve(pair.n_most_nodes());
    touched_last_.reserve(pair.n_most_nodes());
}

std::size_t BudgetLook::memory_bytes() const noexcept {
    return units_.memory_bytes() + thinned_.memory_bytes() + deepest_.memory_bytes() +
           choice_.memory_bytes() + touched_last_.memory_bytes();
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
    : settings_(settings), pair_(std::move(field), std::move(shell)), stages_(pair_, settings) {
    if (settings.budget_us > 0.0) {
        budget_.reserve(pair_);
    }
}

std::size_t FieldSampler::memory_bytes() const noexcept {
    return sizeof(*this) + stages_.memory_bytes() + budget_.memory_bytes();
}

}  // namespace fulcrum
