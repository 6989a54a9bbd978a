#include "haptics/tool/field_sampling/timed_look.h"

#include <algorithm>

namespace fulcrum {

std::size_t TimedLook::search() noexcept {
    std::size_t level = on_.search.begin_at_top();
    for (;;) {
        const double before_us = on_.time.elapsed_us();
        on_.search.search_level(at_, level, on_.memory, on_.time.work());
        on_.time.end_groups(before_us, on_.search.n_groups_at(level));
        // Going down must leave the time to take each node as one leaf, should its parts be too many.
        if (level == 0 || !on_.time.has_time_to_open(found().size())) {
            on_.search.stop_at(level);
            return level;
        }
        level = on_.search.go_down(level);
    }
}

std::size_t TimedLook::go_down(std::size_t level) noexcept {
    level = on_.search.go_down(level);
    on_.search.search_level(at_, level, on_.memory, on_.time.work());
    return level;
}

std::size_t TimedLook::take(std::span<const std::int32_t> leaves) noexcept {
    double took_us = 0.0;
    std::size_t n = 0;
    while (n < leaves.size()) {
        const std::size_t n_next =
            std::min({LookTime::kBlock, leaves.size() - n, on_.time.find_room(1.0)});
        if (n_next == 0) {
            break;
        }
        const double before_us = on_.time.elapsed_us();
        on_.sums.take(at_, leaves.subspan(n, n_next), &on_.memory, on_.time.work());
        took_us += on_.time.end_leaves(before_us, n_next);
        n += n_next;
    }
    on_.time.learn_leaves(took_us, n);
    if (n == 0 && !leaves.empty() && on_.time.find_left_us() > 0.0) {
        // What is thought too dear for a single one is not seen again: less is thought of it.
        on_.time.learn_leaves(0.0, LookTime::kBlock);
    }
    on_.error.set_cut_short(on_.error.is_cut_short() || n < leaves.size());
    return n;
}

void TimedLook::take_found() noexcept {
    const std::size_t n = take(found().all());
    for (std::size_t i = n; i < found().size(); ++i) {
        leave_out(0, i);
    }
    on_.search.note_groups(on_.memory);
}

void TimedLook::leave_out_all(std::size_t level) noexcept {
    for (std::size_t i = 0; i < found().size(); ++i) {
        leave_out(level, i);
    }
}

void TimedLook::leave_out_others(std::size_t level, const NodeList& taken) noexcept {
    const FreeLeaves leaves = known(0);
    const std::int32_t* looked = taken.begin();
    for (std::size_t i = 0; i < found().size(); ++i) {
        const std::size_t first = found()[i] << (3 * level);
        const std::size_t end =
            std::min(first + (std::size_t{1} << (3 * level)), shell().n_leaves());
        for (std::size_t leaf = first; leaf < end; ++leaf) {
            const auto node = static_cast<std::int32_t>(leaf);
            looked = std::find_if(looked, taken.end(),
                                  [node](std::int32_t other) { return other >= node; });
            const bool was_taken = looked != taken.end() && *looked == node;
            if (!was_taken && leaves.may_touch(leaf)) {
                leave_out(level, i);
                break;
            }
        }
    }
}

}  // namespace fulcrum
