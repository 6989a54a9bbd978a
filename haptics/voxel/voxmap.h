// McNeely's voxmap: two bits a voxel in a tree of chosen depth in which every node has 8 x 8 x 8 children.
//
//   depth 1   the root's children are blocks of b^3 voxels       b the least power of two with 8^depth b >= n
//   depth 2   the grandchildren are
//   depth 3   the great-grandchildren are; up to 512 voxels an axis they are the voxels themselves
// A node or block whose voxels are all alike is not stored: its parent holds the kind. A shallow tree asks fewer questions a look
// and stores coarser blocks; a deep one is smaller where the surface is thin.
//
// Thread: made at load; read from any thread, without waiting. Cost of a look: one dependent load a level, one more in a block.
// Source: W. McNeely, K. Puterbaugh, J. Troy 1999, Six degree-of-freedom haptic rendering using voxel sampling, section
// 4.3 (2^(3N)-trees; N = 3, the 512-tree).
#pragma once

#include "haptics/base/error.h"
#include "haptics/voxel/voxel_grid.h"

#include <cstdint>
#include <vector>

namespace fulcrum {

class Voxmap {
  public:
    /// From a grid of at least one and at most 512 voxels an axis; depth 1, 2 or 3.
    [[nodiscard]] static Expected<Voxmap> build(const VoxelGrid& grid, int depth);

    [[nodiscard]] const VoxelFrame& frame() const noexcept { return frame_; }
    [[nodiscard]] int depth() const noexcept { return depth_; }
    /// Edge of a stored block, in voxels.
    [[nodiscard]] std::int32_t block_edge() const noexcept {
        return std::int32_t{1} << block_bits_;
    }
    /// Nodes that are stored, the root among them, and blocks.
    [[nodiscard]] std::size_t n_nodes() const noexcept { return entries_.size() / kChildren; }
    [[nodiscard]] std::size_t n_blocks() const noexcept { return n_blocks_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

    /// Free outside the frame.
    [[nodiscard]] VoxelClass find_class(const VoxelFrame::Cell& cell) const noexcept {
        if (!frame_.contains(cell)) {
            return VoxelClass::free;
        }
        const int shift = root_shift();
        const std::int32_t child =
            (cell[0] >> shift) | (cell[1] >> shift) << 3 | (cell[2] >> shift) << 6;
        return find_below(static_cast<std::uint32_t>(child), cell);
    }
    /// A child of the root has edges of 2^root_shift voxels.
    [[nodiscard]] int root_shift() const noexcept { return block_bits_ + 3 * (depth_ - 1); }
    /// The same for a voxel of the frame in that child of the root, counted x + 8 y + 64 z.
    [[nodiscard]] VoxelClass find_below(std::uint32_t root_child,
                                        const VoxelFrame::Cell& cell) const noexcept {
        std::uint32_t entry = entries_[root_child];
        if (entry < kKinds) {
            return static_cast<VoxelClass>(entry);
        }
        const auto x = static_cast<std::uint32_t>(cell[0]);
        const auto y = static_cast<std::uint32_t>(cell[1]);
        const auto z = static_cast<std::uint32_t>(cell[2]);
        for (int shift = root_shift() - 3; shift >= block_bits_; shift -= 3) {
            const std::uint32_t child =
                ((x >> shift) & 7U) | ((y >> shift) & 7U) << 3 | ((z >> shift) & 7U) << 6;
            entry = entries_[entry - kKinds + child];
            if (entry < kKinds) {
                return static_cast<VoxelClass>(entry);
            }
        }
        const std::uint32_t mask = (1U << block_bits_) - 1U;
        const std::uint32_t voxel =
            (((z & mask) << block_bits_ | (y & mask)) << block_bits_) | (x & mask);
        return static_cast<VoxelClass>(bits_[entry - kKinds + voxel / 4] >> 2 * (voxel % 4) & 3U);
    }

  private:
    static constexpr std::size_t kChildren = 512;
    static constexpr std::uint32_t kKinds = 4;

    struct Block;
    Voxmap() = default;
    void add_children(const VoxelGrid& grid, std::vector<Block>& pending, const Block& node);
    [[nodiscard]] std::uint32_t add_bits(const VoxelGrid& grid, const VoxelFrame::Cell& least);

    VoxelFrame frame_{};
    int depth_ = 1;
    int block_bits_ = 0;  // block_edge = 2^block_bits
    // A child: a kind, or 4 + the place of its first child here, of its bits in bits_ on the last level.
    std::vector<std::uint32_t> entries_;
    std::vector<std::uint8_t> bits_;  // four voxels a byte
    std::size_t n_blocks_ = 0;
};

}  // namespace fulcrum
