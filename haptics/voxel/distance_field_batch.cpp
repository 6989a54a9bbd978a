#include "haptics/voxel/distance_field_batch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#if defined(__GNUC__)
// Vectors wider than the processor's never leave this file.
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace fulcrum {

FieldView::FieldView(const DistanceField& field) noexcept
    : table(field.table().data()),
      values(field.bricks().front().values.data()),
      row(field.n_bricks()[0]),
      layer(field.n_bricks()[0] * field.n_bricks()[1]),
      outside(static_cast<std::int32_t>(field.table().size()) - 1),
      end{},
      depths(field.depths().data()),
      n_bricks(field.n_bricks()),
      band_voxels(static_cast<float>(field.band_m() / field.frame().voxel_m)) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        end[axis] = std::nextafter(static_cast<float>(field.frame().n_cells[axis]), 0.0F);
    }
}

FieldPlace::FieldPlace(const DistanceField& field, const Pose& X_OT) noexcept : A{}, b{} {
    const Matrix3 turned = X_OT.orientation.toRotationMatrix() / field.frame().voxel_m;
    const Vector3 origin = field.frame().to_lattice(X_OT.position);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            A[static_cast<std::size_t>(3 * row) + static_cast<std::size_t>(column)] =
                static_cast<float>(turned(row, column));
        }
        b[static_cast<std::size_t>(row)] = static_cast<float>(origin[row]);
    }
}

namespace {

using Lanes = std::array<std::array<float, ContactLanes::kLanes>, 3>;

double sum_of(const SlopeLanes::Lanes& lanes) noexcept {
    // Four sums side by side: one would wait for itself at each number.
    using FourFloats = float __attribute__((vector_size(16)));
    using FourDoubles = double __attribute__((vector_size(32)));
    FourDoubles sums{};
    for (std::size_t i = 0; i < lanes.size(); i += 4) {
        FourFloats four;
        __builtin_memcpy(&four, lanes.data() + i, sizeof four);
        sums += __builtin_convertvector(four, FourDoubles);
    }
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

Vector3 sum_of(const Lanes& lanes) noexcept {
    return {sum_of(lanes[0]), sum_of(lanes[1]), sum_of(lanes[2])};
}

Matrix3 sum_of(const SlopeLanes::Symmetric& lanes) noexcept {
    Matrix3 sum;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto at = static_cast<int>(i);
        const int next = (at + 1) % 3;
        const int last = (at + 2) % 3;
        sum(at, at) = sum_of(lanes[i]);
        sum(next, last) = sum(last, next) = sum_of(lanes[3 + i]);
    }
    return sum;
}

Matrix3 sum_of(const SlopeLanes::Rows& lanes) noexcept {
    Matrix3 sum;
    for (std::size_t i = 0; i < lanes.size(); ++i) {
        sum(static_cast<int>(i) / 3, static_cast<int>(i) % 3) = sum_of(lanes[i]);
    }
    return sum;
}

double find_variance(const Lanes& lanes) noexcept {
    constexpr double kLanes = ContactLanes::kLanes;
    const Vector3 mean = sum_of(lanes) / kLanes;
    double squares = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float lane : lanes[static_cast<std::size_t>(axis)]) {
            const double away = static_cast<double>(lane) - mean[axis];
            squares += away * away;
        }
    }
    return kLanes / (kLanes - 1.0) * squares;
}

// From steps to metres. Slopes are steps a voxel, arms with them voxels; a depth times the slope pushes out.
struct LaneScales {
    double force, torque;
};
LaneScales find_scales(const DistanceField& field, ForceAlong along) noexcept {
    const double step_m = field.step_m();
    return along == ForceAlong::normals
               ? LaneScales{step_m, step_m}
               : LaneScales{step_m * (step_m / field.frame().voxel_m), step_m * step_m};
}

}  // namespace

ContactSpread find_spread(const DistanceField& field, ForceAlong along,
                          const ContactLanes& lanes) noexcept {
    const LaneScales scales = find_scales(field, along);
    return {scales.force * scales.force * find_variance(lanes.force),
            scales.torque * scales.torque * find_variance(lanes.torque)};
}

void add_lanes(const DistanceField& field, const Pose& X_OT, ForceAlong along, ContactLanes& lanes,
               ContactSums& sums) noexcept {
    const LaneScales scales = find_scales(field, along);
    const Vector3 force = scales.force * sum_of(lanes.force);
    const Vector3 torque = scales.torque * sum_of(lanes.torque);
    for (const std::int32_t count : lanes.count) {
        sums.n_touching += count;
    }
    lanes = {};
    const bool in_tool = along == ForceAlong::normals;
    sums.force += in_tool ? Vector3(X_OT.orientation * force) : force;
    sums.torque += in_tool ? Vector3(X_OT.orientation * torque) : torque;
}

void add_slope_lanes(const DistanceField& field, SlopeLanes& lanes, Matrix6& slopes) noexcept {
    const double step_m = field.step_m();
    const double voxel_m = field.frame().voxel_m;
    const double per_voxel = step_m / voxel_m;
    const Matrix3 turn = per_voxel * step_m * sum_of(lanes.turn);
    const Matrix3 arm_force = step_m * step_m * sum_of(lanes.arm_force);
    slopes.topLeftCorner<3, 3>() += per_voxel * per_voxel * sum_of(lanes.place);
    slopes.topRightCorner<3, 3>() += turn;
    slopes.bottomLeftCorner<3, 3>() += turn.transpose();
    slopes.bottomRightCorner<3, 3>() += step_m * step_m * sum_of(lanes.torque) + arm_force -
                                        arm_force.trace() * Matrix3::Identity();
    lanes = {};
}

ContactSums sum_contacts(const FieldKernels& kernels, const DistanceField& field, const Pose& X_OT,
                         const ShellPoints& points, std::size_t n, ForceAlong along) noexcept {
    constexpr std::size_t kBetween = 128;  // leaves whose sums single precision may hold
    const FieldView view(field);
    const FieldPlace place(field, X_OT);
    ContactLanes lanes;
    ContactSums sums;
    std::array<ShellPoints, kBetween> leaves;
    std::array<float, kBetween> least{};
    const auto add = [&](std::size_t n_leaves, std::size_t n_in_last) {
        const LeafRun run{leaves.data(), n_leaves, n_in_last, kBetween};
        static_cast<void>(kernels.sum_leaves(view, place, run, along, lanes, least.data()));
        add_lanes(field, X_OT, along, lanes, sums);
    };
    std::size_t n_leaves = 0;
    std::size_t first = 0;
    for (; first + kLeafPoints <= n; first += kLeafPoints) {
        leaves[n_leaves++] = points.from(first);
        if (n_leaves == kBetween) {
            add(n_leaves, kLeafPoints);
            n_leaves = 0;
        }
    }
    // The rest is read as a whole leaf, so it gets one of its own.
    std::array<std::array<float, kLeafPoints>, 6> rest{};
    if (first < n) {
        const std::array<const float*, 6> from{points.x,  points.y,  points.z,
                                               points.nx, points.ny, points.nz};
        for (std::size_t i = 0; i < rest.size(); ++i) {
            std::copy(from[i] + first, from[i] + n, rest[i].begin());
        }
        leaves[n_leaves++] = {rest[0].data(), rest[1].data(), rest[2].data(),
                              rest[3].data(), rest[4].data(), rest[5].data()};
    }
    if (n_leaves > 0) {
        add(n_leaves, first < n ? n - first : kLeafPoints);
    }
    return sums;
}

}  // namespace fulcrum
