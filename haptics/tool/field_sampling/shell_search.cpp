#include "haptics/tool/field_sampling/shell_search.h"

#include "haptics/base/prefetch.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace fulcrum {

void ShellSearch::list_leaves(std::size_t n) noexcept {
    nodes_.clear();
    for (std::size_t leaf = 0; leaf < n; ++leaf) {
        add(leaf, HUGE_VALF);
    }
}

std::size_t ShellSearch::begin_at_top() noexcept {
    groups_.back().clear();
    groups_.back().add(0);
    return groups_.size() - 1;
}

std::size_t ShellSearch::go_down(std::size_t level) noexcept {
    groups_[level - 1].copy(nodes_);
    return level - 1;
}

void ShellSearch::stop_at(std::size_t level) noexcept {
    for (std::size_t below = 0; below < level; ++below) {
        groups_[below].clear();
    }
}

void ShellSearch::search_group(const FieldLook& look, std::size_t level, std::size_t group,
                               unsigned due, FreeMemory& memory, LookWork& work) noexcept {
    if (level == 0) {
        due = memory.recall_leaves(look, group, due);
    }
    if (due == 0) {
        return;
    }
    FreeGroup known = memory.group(level, group);
    const std::size_t first = ShellTree::kWidth * group;
    if (known.is_hopeless()) {
        for (; due != 0; due &= due - 1U) {
            const auto i = static_cast<std::size_t>(std::countr_zero(due));
            add(first + i, known.find_depth(i));
        }
        return;
    }
    std::array<float, ShellTree::kWidth> slacks{};
    look.pair.kernels->find_slacks(look.pair.bounds, look.place,
                                   look.pair.shell->level(level)[group], slacks);
    ++work.n_groups;
    float hopeless = HUGE_VALF;
    for (; due != 0; due &= due - 1U) {
        const auto i = static_cast<std::size_t>(std::countr_zero(due));
        known.note_slack(i, slacks[i]);
        if (slacks[i] <= 0.0F) {
            add(first + i, known.find_depth(i));
        }
        hopeless = std::min(hopeless, -slacks[i]);
    }
    known.note_hopeless(hopeless);
}

void ShellSearch::search_level(const FieldLook& look, std::size_t level, FreeMemory& memory,
                               LookWork& work) noexcept {
    nodes_.clear();
    constexpr std::ptrdiff_t kAhead = 4;  // groups whose memory is asked for
    const NodeList& groups = groups_[level];
    for (const std::int32_t& node : groups) {
        if (level == 0 && groups.end() - &node > kAhead) {
            const auto next = static_cast<std::size_t>((&node)[kAhead]);
            memory.prefetch_group(next);
            prefetch(&look.pair.shell->level(0)[next], sizeof(EightBalls));
        }
        const auto group = static_cast<std::size_t>(node);
        const unsigned due = memory.group(level, group).find_due();
        if (due != 0) {
            search_group(look, level, group, due, memory, work);
        }
    }
}

void ShellSearch::search_known(const FieldLook& look, FreeMemory& memory, LookWork& work) noexcept {
    std::size_t level = begin_at_top();
    for (search_level(look, level, memory, work); level > 0;) {
        level = go_down(level);
        search_level(look, level, memory, work);
    }
}

float ShellSearch::search_level_anew(const FieldLook& look, std::size_t level, float within,
                                     LookWork& work) noexcept {
    nodes_.clear();
    float least = HUGE_VALF;
    for (const std::int32_t node : groups_[level]) {
        const auto group = static_cast<std::size_t>(node);
        std::array<float, ShellTree::kWidth> slacks{};
        look.pair.kernels->find_slacks(look.pair.bounds, look.place,
                                       look.pair.shell->level(level)[group], slacks);
        ++work.n_groups;
        for (std::size_t i = 0; i < ShellTree::kWidth; ++i) {
            if (slacks[i] <= within) {
                add(ShellTree::kWidth * group + i, -slacks[i]);
            } else {
                least = std::min(least, slacks[i]);
            }
        }
    }
    return least;
}

float ShellSearch::search_anew(const FieldLook& look, float within, LookWork& work) noexcept {
    std::size_t level = begin_at_top();
    float least = search_level_anew(look, level, within, work);
    while (level > 0) {
        level = go_down(level);
        least = std::min(least, search_level_anew(look, level, within, work));
    }
    return least;
}

void ShellSearch::note_groups(FreeMemory& memory) const noexcept {
    for (std::size_t level = 0; level < groups_.size(); ++level) {
        memory.note_groups(level, groups_[level]);
    }
}

}  // namespace fulcrum
