#include "haptics/dynamics/islands.h"

#include <algorithm>

namespace fulcrum {
namespace {

std::size_t to_place(std::int32_t i) noexcept {
    return static_cast<std::size_t>(i);
}

}  // namespace

Groups::Groups(int max_items, int max_groups) : items_(max_items), begins_(max_groups + 2) {}

void Groups::sort(std::span<const std::int32_t> group_of, int n_groups) noexcept {
    begins_.set_count(to_place(n_groups) + 2);
    std::ranges::fill(begins_.all(), 0);
    std::size_t n_items = 0;
    for (const std::int32_t group : group_of) {
        if (group >= 0) {
            ++begins_[to_place(group) + 2];
            ++n_items;
        }
    }
    for (std::size_t i = 2; i < begins_.count(); ++i) {
        begins_[i] += begins_[i - 1];
    }
    items_.set_count(n_items);
    for (std::size_t i = 0; i < group_of.size(); ++i) {
        if (group_of[i] >= 0) {
            items_[to_place(begins_[to_place(group_of[i]) + 1]++)] = static_cast<std::int32_t>(i);
        }
    }
}

std::span<const std::int32_t> Groups::group(int i) const noexcept {
    const std::size_t begin = to_place(begins_[to_place(i)]);
    return items_.all().subspan(begin, to_place(begins_[to_place(i) + 1]) - begin);
}

Islands::Islands(int max_bodies)
    : parents_(max_bodies), island_of_(max_bodies), bodies_(max_bodies, max_bodies) {}

void Islands::begin(std::span<const std::uint8_t> moves) noexcept {
    parents_.set_count(moves.size());
    for (std::size_t i = 0; i < parents_.count(); ++i) {
        parents_[i] = moves[i] != 0 ? static_cast<std::int32_t>(i) : -1;
    }
}

std::int32_t Islands::find_root(std::int32_t body) noexcept {
    while (parents_[to_place(body)] != body) {
        std::int32_t& parent = parents_[to_place(body)];
        parent = parents_[to_place(parent)];
        body = parent;
    }
    return body;
}

void Islands::link(std::int32_t a, std::int32_t b) noexcept {
    if (a < 0 || b < 0 || parents_[to_place(a)] < 0 || parents_[to_place(b)] < 0) {
        return;
    }
    const std::int32_t root_a = find_root(a);
    const std::int32_t root_b = find_root(b);
    parents_[to_place(std::max(root_a, root_b))] = std::min(root_a, root_b);
}

void Islands::finish() noexcept {
    n_islands_ = 0;
    island_of_.set_count(parents_.count());
    for (std::size_t i = 0; i < parents_.count(); ++i) {
        if (parents_[i] < 0) {
            island_of_[i] = -1;
            continue;
        }
        const auto root = to_place(find_root(static_cast<std::int32_t>(i)));
        // A root is the least of its island, so it has its number before the others ask.
        island_of_[i] = root == i ? n_islands_++ : island_of_[root];
    }
    bodies_.sort(island_of_.all(), n_islands_);
}

}  // namespace fulcrum
