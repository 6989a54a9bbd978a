// What the loop of voxel_lanes.h works on, in the namespace FULCRUM_KERNEL: eight numbers side by side, and the two kinds of map with their
// ways of being asked for a block of points. Included by voxel_lane_kernel.h alone, for each of its versions.
//
// Thread: that of the step. Cost: see voxel_lanes.h.

// NOLINTBEGIN(misc-definitions-in-headers): each version is a set of functions of its own
namespace fulcrum::voxel_lanes::FULCRUM_KERNEL {
namespace {

// The compilers we know lower these to whatever the processor has.
using Floats = float __attribute__((vector_size(32)));
using Ints = std::int32_t __attribute__((vector_size(32)));

// The kinds of the voxels that eight points lie in, a byte each: that of lane l is byte l/2 of the lower half for even l, of
// the upper half for odd l, so that one shift of both halves, spread over all lanes, unpacks them.
using PackedKinds = std::uint64_t;
using Kinds = std::array<PackedKinds, kBlock / kLanes>;

constexpr std::array<int, kLanes> kKindShift{0, 32, 8, 40, 16, 48, 24, 56};

// A byte a voxel.
class GridMap {
  public:
    using Cells = std::array<std::int32_t, kBlock>;  // places in the grid

    explicit GridMap(const VoxelGrid& grid) noexcept
        : cells_(grid.cells.data()), nx_(grid.frame.n_cells[0]), ny_(grid.frame.n_cells[1]) {}
    // Notes where the points from i on lie.
    void note(const Ints& x, const Ints& y, const Ints& z, std::size_t i,
              Cells& cells) const noexcept {
        const Ints index = (z * ny_ + y) * nx_ + x;
        std::memcpy(&cells[i], &index, sizeof index);
    }
    // False where all are free.
    [[nodiscard]] bool look_up(const Cells& cells, Kinds& kinds) const noexcept {
        PackedKinds any = 0;
        for (std::size_t group = 0; group < kinds.size(); ++group) {
            PackedKinds eight = 0;
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                eight |= static_cast<PackedKinds>(cells_[cells[group * kLanes + lane]])
                         << kKindShift[lane];
            }
            kinds[group] = eight;
            any |= eight;
        }
        return any != 0;
    }

    // Of a cell within the map.
    [[nodiscard]] VoxelClass find_class(const VoxelFrame::Cell& cell) const noexcept {
        return cells_[(cell[2] * ny_ + cell[1]) * nx_ + cell[0]];
    }

  private:
    const VoxelClass* cells_;
    std::int32_t nx_, ny_;
};

// A 512-tree.
class TreeMap {
  public:
    using Cells = std::array<std::array<std::int32_t, kBlock>, 4>;  // by axis, and the root's child

    explicit TreeMap(const Voxmap& map) noexcept : map_(&map) {}
    void note(const Ints& x, const Ints& y, const Ints& z, std::size_t i,
              Cells& cells) const noexcept {
        std::memcpy(&cells[0][i], &x, sizeof x);
        std::memcpy(&cells[1][i], &y, sizeof y);
        std::memcpy(&cells[2][i], &z, sizeof z);
        const int shift = map_->root_shift();
        const Ints child = (x >> shift) | (y >> shift) << 3 | (z >> shift) << 6;
        std::memcpy(&cells[3][i], &child, sizeof child);
    }
    // False where all are free.
    [[nodiscard]] bool look_up(const Cells& cells, Kinds& kinds) const noexcept {
        kinds = {};
        PackedKinds any = 0;
        for (std::size_t i = 0; i < kBlock; ++i) {
            const VoxelClass kind = map_->find_below(static_cast<std::uint32_t>(cells[3][i]),
                                                     {cells[0][i], cells[1][i], cells[2][i]});
            kinds[i / kLanes] |= static_cast<PackedKinds>(kind) << kKindShift[i % kLanes];
            any |= static_cast<PackedKinds>(kind);
        }
        return any != 0;
    }

    // Of a cell within the map.
    [[nodiscard]] VoxelClass find_class(const VoxelFrame::Cell& cell) const noexcept {
        return map_->find_class(cell);
    }

  private:
    const Voxmap* map_;
};

}  // namespace
}  // namespace fulcrum::voxel_lanes::FULCRUM_KERNEL
// NOLINTEND(misc-definitions-in-headers)
