#include "haptics/voxel/distance_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {

namespace {

// Bounds give way to what rounding may amount to, in voxels.
constexpr double kRounding = 1.0e-3;

}  // namespace

double DistanceField::error_bound_m() const noexcept {
    return 0.5 * std::numbers::sqrt3 * frame_.voxel_m + 0.5 * step_m();
}

std::size_t DistanceField::memory_bytes() const noexcept {
    return table_.capacity() * sizeof(Entry) + bricks_.capacity() * sizeof(Brick);
}

Vector3 DistanceField::clamp_to_block(const Vector3& lattice) const noexcept {
    const Vector3 most(frame_.n_cells[0], frame_.n_cells[1], frame_.n_cells[2]);
    return lattice.cwiseMax(0.0).cwiseMin(most);
}

DistanceField::Place DistanceField::find_place(const Vector3& lattice) const noexcept {
    Place place;
    const std::array<std::int32_t, 3> n = n_bricks();
    std::array<int, 3> brick{};
    std::array<int, 3> cell{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const int at = std::clamp(static_cast<int>(lattice[axis]), 0, frame_.n_cells[i] - 1);
        brick[i] = at / kBrickCells;
        cell[i] = at % kBrickCells;
        place.within[axis] = lattice[axis] - at;
        place.from_centre[axis] = lattice[axis] - kBrickCells * (brick[i] + 0.5);
    }
    const std::int32_t at = brick[0] + n[0] * (brick[1] + n[1] * brick[2]);
    place.entry = &table_[static_cast<std::size_t>(at)];
    place.corner = bricks_[static_cast<std::size_t>(place.entry->brick)].values.data() +
                   brick_corner_at(cell[0], cell[1], cell[2]);
    return place;
}

DistanceCurve DistanceField::interpolate(const Place& place) const noexcept {
    const Vector3& u = place.within;
    const auto value = [&](int x, int y, int z) noexcept {
        return static_cast<double>(place.corner[brick_corner_at(x, y, z)]);
    };
    // Along x, then y, then z; the slopes come from the same eight values.
    std::array<double, 4> along_x{};
    std::array<double, 4> by_x{};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto y = static_cast<int>(i & 1U);
        const auto z = static_cast<int>(i >> 1U);
        by_x[i] = value(1, y, z) - value(0, y, z);
        along_x[i] = value(0, y, z) + u.x() * by_x[i];
    }
    const std::array<double, 2> by_y{along_x[1] - along_x[0], along_x[3] - along_x[2]};
    const std::array<double, 2> along_y{along_x[0] + u.y() * by_y[0], along_x[2] + u.y() * by_y[1]};
    const std::array<double, 2> by_x_at_y{by_x[0] + u.y() * (by_x[1] - by_x[0]),
                                          by_x[2] + u.y() * (by_x[3] - by_x[2])};
    const double by_z = along_y[1] - along_y[0];
    const double by_xz = by_x_at_y[1] - by_x_at_y[0];
    const double by_yz = by_y[1] - by_y[0];
    const std::array<double, 2> by_xy{by_x[1] - by_x[0], by_x[3] - by_x[2]};
    const Vector3 slope(by_x_at_y[0] + u.z() * by_xz, by_y[0] + u.z() * by_yz, by_z);
    const Vector3 bend(by_yz, by_xz, by_xy[0] + u.z() * (by_xy[1] - by_xy[0]));
    const double per_voxel = step_m() / frame_.voxel_m;
    return {{step_m() * (along_y[0] + u.z() * by_z), per_voxel * slope},
            per_voxel / frame_.voxel_m * bend};
}

DistanceCurve DistanceField::sample_curve(const Vector3& p_O) const noexcept {
    const Vector3 lattice = frame_.to_lattice(p_O);
    if (clamp_to_block(lattice) != lattice) {
        return {{band_m_, Vector3::Zero()}, Vector3::Zero()};
    }
    return interpolate(find_place(lattice));
}

double DistanceField::bound_distance_m(const Vector3& p_O) const noexcept {
    const Vector3 lattice = frame_.to_lattice(p_O);
    const Vector3 nearest = clamp_to_block(lattice);
    const double outside = (lattice - nearest).norm();
    const Place place = find_place(nearest);
    const double value_m = interpolate(place).sample.value_m;
    // From the brick's centre, and from F itself.
    const double from_centre =
        std::abs(static_cast<double>(place.entry->centre_voxels)) - place.from_centre.norm();
    const double from_value = (std::abs(value_m) - error_bound_m()) / frame_.voxel_m;
    const double within = std::max({from_centre - kRounding, from_value - kRounding, 0.0});
    double bound = frame_.voxel_m * std::sqrt(within * within + outside * outside);
    if (outside > 0.0) {
        bound = std::max(bound, (p_O - ball_centre_O_).norm() - ball_radius_m_);
    }
    return value_m < 0.0 ? -bound : bound;
}

double DistanceField::find_free_radius_m(const Vector3& p_O) const noexcept {
    const double value_m = sample(p_O).value_m;
    if (!(value_m > 0.0)) {
        return 0.0;
    }
    const double slack_m = kRounding * frame_.voxel_m;
    const double by_slope = value_m / slope_bound_ - slack_m;
    // Where d is above its error, F is above 0.
    const double by_distance = bound_distance_m(p_O) - error_bound_m() - slack_m;
    return std::max({by_slope, by_distance, 0.0});
}

}  // namespace fulcrum
