#include "haptics/tool/field_sampling/leaf_sums.h"

#include <algorithm>

namespace fulcrum {

void LeafSums::settle(const FieldLook& look) noexcept {
    const DistanceField& field = *look.pair.field;
    if (total_.thinning > 0) {
        const ContactSpread spread = find_spread(field, along_, lanes_);
        total_.spread.force_square += spread.force_square;
        total_.spread.torque_square += spread.torque_square;
    }
    add_lanes(field, look.X_OT, along_, lanes_, total_.sums);
    n_in_lanes_ = 0;
}

void LeafSums::take(const FieldLook& look, std::span<const std::int32_t> leaves, FreeMemory* memory,
                    LookWork& work) noexcept {
    constexpr std::size_t kMostInLanes = 128;  // leaves whose sums single precision may hold
    constexpr std::size_t kRun = 64;
    const ShellTree& shell = *look.pair.shell;
    std::array<ShellPoints, kRun> points;
    std::array<float, kRun> least{};
    while (!leaves.empty()) {
        const std::size_t n = std::min(kRun, leaves.size());
        for (std::size_t i = 0; i < n; ++i) {
            points[i] = shell.points(total_.thinning, static_cast<std::size_t>(leaves[i]));
        }
        const auto last = static_cast<std::size_t>(leaves[n - 1]);
        const LeafRun run{points.data(), n, shell.count_in(total_.thinning, last),
                          kMostInLanes - n_in_lanes_};
        const std::size_t n_taken = look.pair.kernels->sum_leaves(
            look.pair.bounds.view, look.place, run, along_, lanes_, least.data());
        for (std::size_t i = 0; i < n_taken; ++i) {
            total_.least_steps = std::min(total_.least_steps, least[i]);
            // Only leaves that touch count, so that sums are the same in all modes.
            if (least[i] < 0.0F) {
                ++n_in_lanes_;
                touched_.add(leaves[i]);
            }
        }
        if (memory != nullptr) {
            memory->note_leaves(look, total_.thinning, leaves.first(n_taken), least.data());
        }
        work.n_leaves += static_cast<std::int64_t>(n_taken);
        if (n_in_lanes_ == kMostInLanes) {
            settle(look);
        }
        leaves = leaves.subspan(n_taken);
    }
}

}  // namespace fulcrum
