#include "haptics/voxel/ball_slack.h"

namespace fulcrum {

SlackBounds::SlackBounds(const DistanceField& field) noexcept
    : view(field),
      voxels_per_step(static_cast<float>(field.step_m() / field.frame().voxel_m)),
      voxels_per_metre(static_cast<float>(1.0 / field.frame().voxel_m)),
      inverse_slope(static_cast<float>(1.0 / field.slope_bound())),
      error(static_cast<float>(field.error_bound_m() / field.frame().voxel_m)),
      ball_centre{},
      ball_radius(static_cast<float>(field.ball_radius_m() / field.frame().voxel_m)) {
    const Vector3 centre = field.frame().to_lattice(field.ball_centre_O());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        ball_centre[axis] = static_cast<float>(centre[static_cast<int>(axis)]);
    }
}

}  // namespace fulcrum
