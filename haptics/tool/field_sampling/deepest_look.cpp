#include "haptics/tool/field_sampling/deepest_look.h"

#include "haptics/tool/field_sampling/rank_cut.h"

#include <algorithm>

namespace fulcrum {

void DeepestLook::rank(TimedLook& in, std::size_t level, const NodeList& touched_last) noexcept {
    const std::vector<EightBalls>& balls = in.shell().level(level);
    const float voxels_per_metre = in.at().pair.bounds.voxels_per_metre;
    const std::int32_t* touched = touched_last.begin();
    for (std::size_t i = 0; i < in.found().size(); ++i) {
        const std::int32_t node = in.found().begin()[i];
        const auto at = static_cast<std::size_t>(node);
        while (touched != touched_last.end() && (*touched >> (3 * level)) < node) {
            ++touched;
        }
        const bool touched_last_time =
            touched != touched_last.end() && (*touched >> (3 * level)) == node;
        const float radius =
            voxels_per_metre * balls[at / ShellTree::kWidth].radius[at % ShellTree::kWidth];
        // Never more than about 2, as a ball round its middle is no deeper than a radius when its points begin to touch.
        const float rank =
            std::clamp(in.search_stage().depth_voxels(i) / (radius + 0.01F), 0.0F, RankCut::kFirst);
        ranks_[i] = touched_last_time ? RankCut::kFirst : rank;
    }
}

void DeepestLook::choose(TimedLook& in, std::size_t level, std::size_t room,
                         const NodeList& touched_last) noexcept {
    rank(in, level, touched_last);
    RankCut cut({ranks_.data(), in.found().size()}, room);
    in.search_stage().keep_if([&](std::size_t i) {
        const bool is_kept = cut.takes(ranks_[i]);
        if (!is_kept) {
            in.leave_out(level, i);
        }
        return is_kept;
    });
}

void DeepestLook::look(TimedLook& in, std::size_t level, const NodeList& touched_last) noexcept {
    while (level > 0) {
        // Of what is opened at least a leaf must fit.
        choose(in, level, in.time().find_room_to_open(), touched_last);
        level = in.go_down(level);
    }
    choose(in, 0, in.time().find_room(1.0), touched_last);
    in.take_found();
}

}  // namespace fulcrum
