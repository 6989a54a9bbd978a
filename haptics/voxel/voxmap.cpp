#include "haptics/voxel/voxmap.h"

#include <algorithm>
#include <string>

namespace fulcrum {

// A node whose children are still to be looked at.
struct Voxmap::Block {
    std::size_t first = 0;  // of its entries
    VoxelFrame::Cell least{};
    int bits = 0;  // its children's edges are 2^bits voxels
};

namespace {

constexpr std::int32_t kMostCells = 512;

// The kind of all voxels of a cube, or none where they differ; outside the frame they are free.
bool are_alike(const VoxelGrid& grid, const VoxelFrame::Cell& least, std::int32_t edge,
               VoxelClass& kind) {
    kind = grid.find_class(least);
    VoxelFrame::Cell end{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // What lies outside is looked at once for all.
        end[axis] =
            std::min(least[axis] + edge, std::max(least[axis], grid.frame.n_cells[axis]) + 1);
    }
    for (std::int32_t z = least[2]; z < end[2]; ++z) {
        for (std::int32_t y = least[1]; y < end[1]; ++y) {
            for (std::int32_t x = least[0]; x < end[0]; ++x) {
                if (grid.find_class({x, y, z}) != kind) {
                    return false;
                }
            }
        }
    }
    return true;
}

int find_block_bits(const VoxelFrame& frame, int depth) {
    const std::int32_t longest = *std::max_element(frame.n_cells.begin(), frame.n_cells.end());
    int bits = 0;
    while ((std::int32_t{1} << (3 * depth + bits)) < longest) {
        ++bits;
    }
    return bits;
}

}  // namespace

Expected<Voxmap> Voxmap::build(const VoxelGrid& grid, int depth) {
    if (depth < 1 || depth > 3) {
        return fail("a voxmap's tree of depth " + std::to_string(depth) + " is not one of 1, 2, 3",
                    {}, "take 1 for speed or 3 for memory");
    }
    const auto [least, most] =
        std::minmax_element(grid.frame.n_cells.begin(), grid.frame.n_cells.end());
    if (*least < 1 || *most > kMostCells) {
        return fail("a voxmap needs from 1 to 512 voxels along each axis", {},
                    "choose another voxel size");
    }
    Voxmap map;
    map.frame_ = grid.frame;
    map.depth_ = depth;
    map.block_bits_ = find_block_bits(grid.frame, depth);
    map.entries_.resize(kChildren);
    std::vector<Block> pending{{0, {0, 0, 0}, map.block_bits_ + 3 * (depth - 1)}};
    while (!pending.empty()) {
        const Block node = pending.back();
        pending.pop_back();
        map.add_children(grid, pending, node);
    }
    map.entries_.shrink_to_fit();
    map.bits_.shrink_to_fit();
    return map;
}

void Voxmap::add_children(const VoxelGrid& grid, std::vector<Block>& pending, const Block& node) {
    const std::int32_t edge = std::int32_t{1} << node.bits;
    for (std::int32_t child = 0; child < static_cast<std::int32_t>(kChildren); ++child) {
        const VoxelFrame::Cell least{node.least[0] + (child & 7) * edge,
                                     node.least[1] + (child >> 3 & 7) * edge,
                                     node.least[2] + (child >> 6) * edge};
        VoxelClass kind = VoxelClass::free;
        std::uint32_t entry = 0;
        if (are_alike(grid, least, edge, kind)) {
            entry = static_cast<std::uint32_t>(kind);
        } else if (node.bits == block_bits_) {
            entry = kKinds + add_bits(grid, least);
        } else {
            entry = kKinds + static_cast<std::uint32_t>(entries_.size());
            pending.push_back({entries_.size(), least, node.bits - 3});
            entries_.resize(entries_.size() + kChildren);
        }
        entries_[node.first + static_cast<std::size_t>(child)] = entry;
    }
}

std::uint32_t Voxmap::add_bits(const VoxelGrid& grid, const VoxelFrame::Cell& least) {
    const auto first = static_cast<std::uint32_t>(bits_.size());
    const std::int32_t edge = block_edge();
    const std::size_t n_voxels = std::size_t{1} << (3 * block_bits_);
    bits_.resize(bits_.size() + n_voxels / 4);
    std::size_t voxel = 0;
    for (std::int32_t z = 0; z < edge; ++z) {
        for (std::int32_t y = 0; y < edge; ++y) {
            for (std::int32_t x = 0; x < edge; ++x, ++voxel) {
                const VoxelClass kind = grid.find_class({least[0] + x, least[1] + y, least[2] + z});
                bits_[first + voxel / 4] = static_cast<std::uint8_t>(
                    bits_[first + voxel / 4] | static_cast<unsigned>(kind) << 2 * (voxel % 4));
            }
        }
    }
    ++n_blocks_;
    return first;
}

std::size_t Voxmap::memory_bytes() const noexcept {
    return sizeof(*this) + entries_.size() * sizeof(entries_[0]) + bits_.size();
}

}  // namespace fulcrum
