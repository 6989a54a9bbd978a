// What the samples of a shell's thinning tell of its parts: where a unit's samples touch, which of the parts it stands for are
// worth a closer look.
//
// A unit is a leaf of thinning m: 32 samples, each for 2^m points that follow each other (shell_tree.h). By thinning f < m it has
// 2^(m - f) parts, and a part's F is the least of its samples'; of more than 32 parts several have one sample.
//
// Thread: one at a time; room is made at load. Cost: 1 ns a sample; 128 bytes a unit.
// Source: finer levels only where the coarser one comes near: J. Barbic, D. James 2008, Six-DoF haptic rendering of contact between
// geometrically complex reduced deformable models, IEEE Trans. Haptics 1(1), section 4.2.
#pragma once

#include "haptics/voxel/distance_field_batch.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace fulcrum {

class SeenSamples {
  public:
    /// Room for so many units; at load.
    void reserve(std::size_t n_units) { least_.resize(kLeafPoints * n_units); }
    [[nodiscard]] std::size_t n_most_units() const noexcept { return least_.size() / kLeafPoints; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return least_.capacity() * sizeof(float);
    }

    void clear() noexcept {
        n_units_ = 0;
        n_kept_ = kLeafPoints;
    }
    /// Where the next unit's F are to be written, kLeafPoints of them.
    [[nodiscard]] float* add_unit() noexcept { return least_.data() + kLeafPoints * n_units_++; }
    /// Each unit has so many parts, a power of two; after all units were added, and never more than before.
    void split(std::size_t n_parts) noexcept {
        n_parts_ = n_parts;
        for (; n_kept_ > n_parts; n_kept_ /= 2) {
            for (std::size_t unit = 0; unit < n_units_; ++unit) {
                float* const each = least_.data() + kLeafPoints * unit;
                for (std::size_t i = 0; i < n_kept_ / 2; ++i) {
                    each[i] = std::min(each[2 * i], each[2 * i + 1]);
                }
            }
        }
    }

    [[nodiscard]] std::size_t n_units() const noexcept { return n_units_; }
    /// Parts that have the same sample.
    [[nodiscard]] std::size_t n_parts_a_sample() const noexcept { return n_parts_ / n_kept_; }
    /// F of a part.
    [[nodiscard]] float least(std::size_t unit, std::size_t part) const noexcept {
        return least_[kLeafPoints * unit + part * n_kept_ / n_parts_];
    }
    /// Samples, or of larger parts the parts, that touch.
    [[nodiscard]] std::size_t count_touching() const noexcept {
        std::size_t n = 0;
        for (std::size_t unit = 0; unit < n_units_; ++unit) {
            const float* const first = least_.data() + kLeafPoints * unit;
            n += static_cast<std::size_t>(
                std::count_if(first, first + n_kept_, [](float F) { return F < 0.0F; }));
        }
        return n;
    }

  private:
    std::vector<float> least_;
    std::size_t n_units_ = 0;
    std::size_t n_parts_ = 1;
    std::size_t n_kept_ = kLeafPoints;  // numbers of a unit that count
};

}  // namespace fulcrum
