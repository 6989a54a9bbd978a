#include "haptics/voxel/distance_field_batch.h"

#include "haptics/voxel/distance_field_wide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#if defined(__GNUC__)
// Vectors wider than the processor's never leave this file.
#pragma GCC diagnostic ignored "-Wpsabi"
#endif
#define FULCRUM_KERNEL plain_kernels
#define FULCRUM_KERNEL_LANES 8
#include "haptics/voxel/distance_field_kernel.h"

namespace fulcrum {

namespace {

constexpr FieldKernels kPlain{"8 lanes", plain_kernels::sample, plain_kernels::sum_leaf};

}  // namespace

std::array<const FieldKernels*, 2> all_field_kernels() noexcept {
    return {&kPlain, find_wide_kernels()};
}

const FieldKernels& best_field_kernels() noexcept {
    const FieldKernels* const wide = find_wide_kernels();
    return wide == nullptr ? kPlain : *wide;
}

FieldView::FieldView(const DistanceField& field) noexcept
    : table(field.table().data()),
      values(field.bricks().front().values.data()),
      row(field.n_bricks()[0]),
      layer(field.n_bricks()[0] * field.n_bricks()[1]),
      outside(static_cast<std::int32_t>(field.table().size()) - 1),
      end{} {
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

void add_lanes(const DistanceField& field, const Pose& X_OT, ForceAlong along, ContactLanes& lanes,
               ContactSums& sums) noexcept {
    Vector3 force = Vector3::Zero();
    Vector3 torque = Vector3::Zero();
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        for (std::size_t lane = 0; lane < ContactLanes::kLanes; ++lane) {
            force[axis] += static_cast<double>(lanes.force[i][lane]);
            torque[axis] += static_cast<double>(lanes.torque[i][lane]);
        }
    }
    for (const std::int32_t count : lanes.count) {
        sums.n_touching += count;
    }
    lanes = {};
    const double step_m = field.step_m();
    const double voxel_m = field.frame().voxel_m;
    if (along == ForceAlong::normals) {
        sums.force += X_OT.orientation * Vector3(step_m * force);
        sums.torque += X_OT.orientation * Vector3(step_m * torque);
    } else {
        // Slopes are steps a voxel, arms are voxels; a depth times the slope pushes out.
        sums.force += step_m * (step_m / voxel_m) * force;
        sums.torque += step_m * step_m * torque;
    }
}

ContactSums sum_contacts(const FieldKernels& kernels, const DistanceField& field, const Pose& X_OT,
                         const ShellPoints& points, std::size_t n, ForceAlong along) noexcept {
    constexpr std::size_t kBetween = 4096;  // points whose sums single precision may hold
    const FieldView view(field);
    const FieldPlace place(field, X_OT);
    ContactLanes lanes;
    ContactSums sums;
    const std::size_t n_whole = n / kLeafPoints * kLeafPoints;
    for (std::size_t first = 0; first < n_whole; first += kLeafPoints) {
        kernels.sum_leaf(view, place, points.from(first), kLeafPoints, along, lanes);
        if (first % kBetween == 0) {
            add_lanes(field, X_OT, along, lanes, sums);
        }
    }
    if (n_whole < n) {
        std::array<std::array<float, kLeafPoints>, 6> leaf{};
        const std::array<const float*, 6> from{points.x,  points.y,  points.z,
                                               points.nx, points.ny, points.nz};
        for (std::size_t i = 0; i < leaf.size(); ++i) {
            std::copy(from[i] + n_whole, from[i] + n, leaf[i].begin());
        }
        kernels.sum_leaf(view, place,
                         {leaf[0].data(), leaf[1].data(), leaf[2].data(), leaf[3].data(),
                          leaf[4].data(), leaf[5].data()},
                         n - n_whole, along, lanes);
    }
    add_lanes(field, X_OT, along, lanes, sums);
    return sums;
}

std::size_t collect_hits(std::span<const float> values, std::span<std::int32_t> hits) noexcept {
    std::size_t n = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        hits[n] = static_cast<std::int32_t>(i);
        n += values[i] < 0.0F ? 1 : 0;
    }
    return n;
}

}  // namespace fulcrum
