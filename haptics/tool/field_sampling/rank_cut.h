// Which of many have the highest ranks, without sorting them: as many as there is room for and no more.
//
// Ranks are counted in 128 bins from 0 to kFirst. Bins are taken whole from the highest on while there is room, and of the next
// one those that are asked for first. What has rank kFirst has a bin of its own.
//
// Thread: any. Cost: 1 ns a rank to count, as much to ask; 1 kB on the stack.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace fulcrum {

class RankCut {
  public:
    static constexpr float kFirst = 2.0F;

    /// Ranks from 0 on; above kFirst they count as that.
    RankCut(std::span<const float> ranks, std::size_t room) noexcept {
        std::array<std::size_t, kBins> counts{};
        for (const float rank : ranks) {
            ++counts[find_bin(rank)];
        }
        while (lowest_ > 0 && counts[lowest_ - 1] <= room) {
            room -= counts[--lowest_];
        }
        n_below_ = room;
    }

    /// Whether it is taken; to be asked once of each rank, in turn.
    [[nodiscard]] bool takes(float rank) noexcept {
        const std::size_t bin = find_bin(rank);
        if (bin + 1 == lowest_ && n_below_ > 0) {
            --n_below_;
            return true;
        }
        return bin >= lowest_;
    }

  private:
    static constexpr std::size_t kBins = 128;
    static std::size_t find_bin(float rank) noexcept {
        constexpr float kBinsARank = static_cast<float>(kBins - 1) / kFirst;
        return rank >= kFirst ? kBins - 1
                              : std::min(kBins - 2, static_cast<std::size_t>(rank * kBinsARank));
    }
    std::size_t lowest_ = kBins;  // bin that is taken whole
    std::size_t n_below_ = 0;     // room in the bin below
};

}  // namespace fulcrum
