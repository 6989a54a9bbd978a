#include "haptics/voxel/distance_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {

namespace {

// Bounds give way to what rounding may amount to, in voxels.
constexpr double kFieldRounding = 1.0e-3;

}  // namespace

double DistanceField::error_bound_m() const noexcept {
    return 0.5 * std::numbers::sqrt3 * frame_.voxel_m + 0.5 * step_m();
}

std::size_t DistanceField::memory_bytes() const noexcept {
    return table_.capacity() * sizeof(Entry) + bricks_.capacity() * sizeof(Brick) +
           depths_.capacity() * sizeof(float);
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

DistanceCurve DistanceField::find_centre_depth(const Vector3& lattice) const noexcept {
    // From the eight centres round the place; at the block's ends as between its outermost.
    const Vector3 place = lattice / kBrickCells - Vector3::Constant(0.5);
    const std::array<std::int32_t, 3> n = n_bricks();
    std::array<std::int32_t, 3> low{};
    std::array<Vector3, 2> weight;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        low[i] = std::clamp(static_cast<std::int32_t>(place[axis]), 0, std::max(n[i] - 2, 0));
        weight[1][axis] = std::clamp(place[axis] - low[i], 0.0, 1.0);
        weight[0][axis] = 1.0 - weight[1][axis];
    }
    DistanceCurve found;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const std::array<unsigned, 3> high{corner & 1U, corner >> 1U & 1U, corner >> 2U};
        std::array<std::int32_t, 3> at{};
        Vector3 w;
        Vector3 by;  // of a weight, a voxel
        for (std::size_t i = 0; i < 3; ++i) {
            const auto axis = static_cast<int>(i);
            at[i] = std::min(low[i] + static_cast<std::int32_t>(high[i]), n[i] - 1);
            w[axis] = weight[high[i]][axis];
            by[axis] = (high[i] == 1 ? 1.0 : -1.0) / kBrickCells;
        }
        const std::int32_t entry = at[0] + n[0] * (at[1] + n[1] * at[2]);
        const double depth = static_cast<double>(depths_[static_cast<std::size_t>(entry)]);
        found.sample.value_m += depth * w.prod();
        found.sample.slope +=
            depth * Vector3(by.x() * w.y() * w.z(), w.x() * by.y() * w.z(), w.x() * w.y() * by.z());
        found.bend += depth * Vector3(w.x() * by.y() * by.z(), by.x() * w.y() * by.z(),
                                      by.x() * by.y() * w.z());
    }
    return found;
}

DepthSample DistanceField::sample_depth(const Vector3& p_O) const noexcept {
    const DistanceCurve near = sample_curve(p_O);
    const double depth_m = -near.sample.value_m;
    if (!(depth_m > 0.0)) {
        return {};
    }
    DepthSample deep{depth_m, near.sample.slope, -near.hessian()};
    const double t = (depth_m / band_m_ - kDeepFrom) / (1.0 - kDeepFrom);
    if (!(t > 0.0)) {
        return deep;
    }
    const DistanceCurve centre = find_centre_depth(frame_.to_lattice(p_O));
    const double more_m = centre.sample.value_m * frame_.voxel_m - band_m_;
    if (!(more_m > 0.0)) {
        return deep;
    }
    const double share = std::min(t, 1.0);
    const double by_depth = t < 1.0 ? 1.0 / ((1.0 - kDeepFrom) * band_m_) : 0.0;
    // With g the gradient of d, c that of K: the cross terms come from t's own change.
    const Matrix3 cross = -by_depth * near.sample.slope * centre.sample.slope.transpose();
    deep.depth_m += share * more_m;
    deep.way_out = (1.0 + by_depth * more_m) * near.sample.slope - share * centre.sample.slope;
    deep.hessian = (1.0 + by_depth * more_m) * deep.hessian + cross + cross.transpose() +
                   share / frame_.voxel_m * centre.hessian();
    return deep;
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
    const double within =
        std::max({from_centre - kFieldRounding, from_value - kFieldRounding, 0.0});
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
    const double slack_m = kFieldRounding * frame_.voxel_m;
    const double by_slope = value_m / slope_bound_ - slack_m;
    // Where d is above its error, F is above 0.
    const double by_distance = bound_distance_m(p_O) - error_bound_m() - slack_m;
    return std::max({by_slope, by_distance, 0.0});
}

}  // namespace fulcrum
