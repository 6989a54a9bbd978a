#include "haptics/voxel/voxelise.h"

#include "haptics/base/range.h"
#include "haptics/voxel/rasterise.h"

#include <array>
#include <cmath>
#include <vector>

namespace fulcrum {
namespace {

constexpr int kMostAcross = 512;  // along an axis: what a tree of three levels holds
// About as much of the time as each step takes.
constexpr double kShareMarked = 0.3;
constexpr double kShareFlooded = 0.8;

// Until it is reached from outside, what is not surface counts as interior.
VoxelGrid make_grid(const VoxelFrame& frame) {
    VoxelGrid grid;
    grid.frame = frame;
    const auto [nx, ny, nz] = frame.n_cells;
    grid.cells.assign(
        static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz),
        VoxelClass::interior);
    return grid;
}

// Asks whether to go on after each few thousand of what is cheap.
class Strides {
  public:
    Strides(LoadPulse& pulse, double share) : pulse_(pulse), share_(share) {}
    [[nodiscard]] bool goes_on() {
        constexpr int kStride = 4096;
        return ++n_ % kStride != 0 || pulse_.goes_on(share_);
    }

  private:
    LoadPulse& pulse_;
    double share_;
    int n_ = 0;
};

// How many voxels of each block are surface: those that are full need no look at another triangle.
class Marks {
  public:
    explicit Marks(VoxelGrid& grid) : grid_(grid) {
        std::size_t n_all = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            n_[axis] = grid.frame.n_cells[axis] / kRasterBlock + 1;
            n_all *= static_cast<std::size_t>(n_[axis]);
        }
        count_.assign(n_all, 0);
    }

    [[nodiscard]] bool is_full(const VoxelFrame::Cell& block) const {
        constexpr int kFull = kRasterBlock * kRasterBlock * kRasterBlock;
        return count_[index_of(block)] == kFull;
    }
    [[nodiscard]] bool is_marked(const VoxelFrame::Cell& cell) const {
        return grid_.cells[grid_.index_of(cell)] == VoxelClass::surface;
    }
    void mark(const VoxelFrame::Cell& cell) {
        grid_.cells[grid_.index_of(cell)] = VoxelClass::surface;
        ++count_[index_of(
            {cell[0] / kRasterBlock, cell[1] / kRasterBlock, cell[2] / kRasterBlock})];
    }

  private:
    [[nodiscard]] std::size_t index_of(const VoxelFrame::Cell& block) const {
        const std::int32_t at = block[0] + n_[0] * (block[1] + n_[1] * block[2]);
        return static_cast<std::size_t>(at);
    }

    VoxelGrid& grid_;
    VoxelFrame::Cell n_{};
    std::vector<std::int16_t> count_;
};

// False, here and below, where it was stopped.
bool mark_surface(const TriangleMesh& mesh, LoadPulse& pulse, VoxelGrid& grid) {
    Marks marks(grid);
    const std::vector<Vector3>& corners = mesh.vertices_B();
    double n_done = 0.0;
    for (const auto& [a, b, c] : mesh.triangles()) {
        const TrianglePoints triangle{corners[static_cast<std::size_t>(a)],
                                      corners[static_cast<std::size_t>(b)],
                                      corners[static_cast<std::size_t>(c)]};
        rasterise_wanted(
            grid.frame, triangle,
            [&](const VoxelFrame::Cell& block) { return !marks.is_full(block); },
            [&](const VoxelFrame::Cell& cell) { return !marks.is_marked(cell); },
            [&](const VoxelFrame::Cell& cell) { marks.mark(cell); });
        n_done += 1.0;
        if (!pulse.goes_on(kShareMarked * n_done / static_cast<double>(mesh.triangles().size()))) {
            return false;
        }
    }
    return true;
}

// Free space spreads from a corner; the margin joins all outermost voxels.
bool flood_free(LoadPulse& pulse, VoxelGrid& grid) {
    Strides strides(pulse, kShareMarked);
    std::vector<VoxelFrame::Cell> front{{0, 0, 0}};
    grid.cells[0] = VoxelClass::free;
    while (!front.empty()) {
        const VoxelFrame::Cell cell = front.back();
        front.pop_back();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (const std::int32_t step : {-1, 1}) {
                VoxelFrame::Cell next = cell;
                next[axis] += step;
                if (grid.find_class(next) == VoxelClass::interior) {
                    grid.cells[grid.index_of(next)] = VoxelClass::free;
                    front.push_back(next);
                }
            }
        }
        if (!strides.goes_on()) {
            return false;
        }
    }
    return true;
}

// Free voxels with a neighbour in `front` become `kind`; returns them.
std::vector<VoxelFrame::Cell> grow(VoxelGrid& grid, const std::vector<VoxelFrame::Cell>& front,
                                   VoxelClass kind, Strides& strides) {
    std::vector<VoxelFrame::Cell> next;
    for (const VoxelFrame::Cell& cell : front) {
        const CellRange around{{cell[0] - 1, cell[1] - 1, cell[2] - 1},
                               {cell[0] + 1, cell[1] + 1, cell[2] + 1}};
        for_each_cell(around, [&](const VoxelFrame::Cell& neighbour) {
            if (!grid.frame.contains(neighbour)) {
                return;
            }
            VoxelClass& here = grid.cells[grid.index_of(neighbour)];
            if (here == VoxelClass::free) {
                here = kind;
                next.push_back(neighbour);
            }
        });
        if (!strides.goes_on()) {
            return {};
        }
    }
    return next;
}

std::vector<VoxelFrame::Cell> collect_surface(const VoxelGrid& grid) {
    std::vector<VoxelFrame::Cell> found;
    const auto [nx, ny, nz] = grid.frame.n_cells;
    for_each_cell({{0, 0, 0}, {nx - 1, ny - 1, nz - 1}}, [&](const VoxelFrame::Cell& cell) {
        if (grid.cells[grid.index_of(cell)] == VoxelClass::surface) {
            found.push_back(cell);
        }
    });
    return found;
}

bool add_layers(const VoxeliseSettings& settings, LoadPulse& pulse, VoxelGrid& grid) {
    Strides strides(pulse, kShareFlooded);
    std::vector<VoxelFrame::Cell> front = collect_surface(grid);
    for (int k = 0; k < settings.offset_layers; ++k) {
        const std::vector<VoxelFrame::Cell> next = grow(grid, front, VoxelClass::surface, strides);
        for (const VoxelFrame::Cell& cell : front) {
            grid.cells[grid.index_of(cell)] = VoxelClass::interior;
        }
        front = next;
    }
    for (int k = 0; k < settings.proximity_layers; ++k) {
        front = grow(grid, front, VoxelClass::proximity, strides);
    }
    return pulse.goes_on_now(1.0);
}

}  // namespace

double compute_voxel_m(const TriangleMesh& mesh, int n_cells) noexcept {
    return (mesh.upper_B() - mesh.lower_B()).maxCoeff() / (n_cells - 0.5);
}

Expected<void> validate(const VoxeliseSettings& settings) {
    const std::array<Range, 3> ranges{
        {{"voxel_m", settings.voxel_m, 1.0e-9, 1.0e3},
         {"offset_layers", static_cast<double>(settings.offset_layers), 0.0, 8.0},
         {"proximity_layers", static_cast<double>(settings.proximity_layers), 0.0, 8.0}}};
    return check_ranges("the voxels'", ranges);
}

Expected<VoxelFrame> make_voxel_frame(const TriangleMesh& mesh, const VoxeliseSettings& settings) {
    if (const auto checked = validate(settings); !checked) {
        return tl::unexpected(checked.error());
    }
    // One free voxel remains outside the last layer.
    const int margin = settings.offset_layers + settings.proximity_layers + 1;
    VoxelFrame frame;
    frame.voxel_m = settings.voxel_m;
    Vector3 inner;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Index>(axis);
        // A side that is whole voxels long, to rounding, gets one more, so that it ends inside and not on a face.
        const double side = (mesh.upper_B()[i] - mesh.lower_B()[i]) / settings.voxel_m;
        const double needed = std::floor(side + 1.0e-6) + 1.0 + 2.0 * margin;
        if (!(needed <= kMostAcross)) {
            return fail("a voxel of " + std::to_string(settings.voxel_m) +
                            " m needs more than 512 voxels along a side of the mesh",
                        {}, "make the voxels larger or the mesh smaller");
        }
        frame.n_cells[axis] = static_cast<std::int32_t>(needed);
        inner[i] = settings.voxel_m * (needed - 2.0 * margin);
    }
    // What the mesh does not fill is shared between both sides.
    const Vector3 middle = 0.5 * (mesh.lower_B() + mesh.upper_B());
    frame.lower_O = middle - 0.5 * inner - Vector3::Constant(settings.voxel_m * margin);
    return frame;
}

Expected<VoxelGrid> voxelise(const TriangleMesh& mesh, const VoxeliseSettings& settings,
                             const LoadProgress& progress) {
    const auto frame = make_voxel_frame(mesh, settings);
    if (!frame) {
        return tl::unexpected(frame.error());
    }
    VoxelGrid grid = make_grid(*frame);
    LoadPulse pulse(progress);
    const bool is_done = mark_surface(mesh, pulse, grid) && pulse.goes_on_now(kShareMarked) &&
                         flood_free(pulse, grid) && pulse.goes_on_now(kShareFlooded) &&
                         add_layers(settings, pulse, grid);
    if (!is_done) {
        return fail("the voxels were stopped before they were made", {}, "make them again");
    }
    return grid;
}

}  // namespace fulcrum
