// Where a distance field may lie and what may be set of it: the checking half of distance_field.h.
#include "haptics/base/range.h"
#include "haptics/voxel/distance_field.h"

#include <cmath>

namespace fulcrum {

namespace {

constexpr double kOutermost = 1.0;  // voxels that lie free beyond the band at the block's border

}  // namespace

Expected<void> validate(const VoxelFrame& frame, const TriangleMesh& mesh, double band_voxels) {
    for (const std::int32_t n : frame.n_cells) {
        if (n < kBrickCells || n > 2048 || n % kBrickCells != 0) {
            return fail("a distance field of " + std::to_string(n) + " cells along an axis", {},
                        "take a multiple of 8 from 8 to 2048");
        }
    }
    if (!(frame.voxel_m > 0.0) || !std::isfinite(frame.voxel_m) || !frame.lower_O.allFinite()) {
        return fail("a distance field whose voxels have no size or place", {},
                    "give its frame a voxel above 0 and a finite corner");
    }
    const double margin_m = (band_voxels + kOutermost) * frame.voxel_m;
    const bool fits = all_at_most(Vector3::Constant(margin_m), mesh.lower_B() - frame.lower_O) &&
                      all_at_most(Vector3::Constant(margin_m), frame.upper_O() - mesh.upper_B());
    if (!fits) {
        return fail("the block of the distance field ends less than " + std::to_string(margin_m) +
                        " m from the mesh",
                    {}, "take a larger block or a narrower band");
    }
    return {};
}

Expected<void> validate(const DistanceFieldSettings& settings) {
    const bool is_sheet = settings.sheet_voxels != 0.0;
    const std::array<Range, 3> ranges{
        {{"band_voxels", settings.band_voxels, 2.0, 16.0},
         {"sheet_voxels", settings.sheet_voxels, is_sheet ? 1.0 : 0.0, settings.band_voxels},
         {"n_threads", static_cast<double>(settings.n_threads), 1.0, 64.0}}};
    return check_ranges("the distance field's", ranges);
}

Expected<VoxelFrame> make_field_frame(const TriangleMesh& mesh, int n_along, double band_voxels) {
    if (n_along < 16 || n_along > 2048 || n_along % kBrickCells != 0) {
        return fail(
            "a distance field of " + std::to_string(n_along) + " cells along its longest side", {},
            "take a multiple of 8 from 16 to 2048");
    }
    // A little more than the margin, so that rounding leaves enough.
    const double margin = band_voxels + kOutermost + 0.01;
    const Vector3 size_m = mesh.upper_B() - mesh.lower_B();
    if (!(n_along > 2.0 * margin)) {
        return fail("a band of " + std::to_string(band_voxels) + " voxels in " +
                        std::to_string(n_along) + " cells",
                    {}, "take more cells or a narrower band");
    }
    VoxelFrame frame;
    frame.voxel_m = size_m.maxCoeff() / (n_along - 2.0 * margin);
    for (int axis = 0; axis < 3; ++axis) {
        const double n_bricks =
            std::ceil((size_m[axis] / frame.voxel_m + 2.0 * margin) / kBrickCells - 1.0e-9);
        frame.n_cells[static_cast<std::size_t>(axis)] = kBrickCells * static_cast<int>(n_bricks);
    }
    frame.lower_O =
        0.5 * (mesh.lower_B() + mesh.upper_B()) - 0.5 * (frame.upper_O() - frame.lower_O);
    return frame;
}

}  // namespace fulcrum
