#include "haptics/tool/voxel_sampling/voxel_lanes.h"

#include "haptics/base/processor.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <type_traits>

#if defined(__GNUC__)
// Vectors wider than the processor's never leave this file.
#pragma GCC diagnostic ignored "-Wpsabi"
#endif
#define FULCRUM_KERNEL plain_kernels
#include "haptics/tool/voxel_sampling/voxel_lane_kernel.h"
#undef FULCRUM_KERNEL
#ifdef FULCRUM_WIDER_KERNELS
#pragma GCC push_options
#pragma GCC target("avx2")
#define FULCRUM_KERNEL avx2_kernels
#include "haptics/tool/voxel_sampling/voxel_lane_kernel.h"
#undef FULCRUM_KERNEL
#pragma GCC pop_options
#endif

namespace fulcrum::voxel_lanes {

namespace {

constexpr Kernels kPlain{"plain", plain_kernels::sample_grid, plain_kernels::sample_tree};
#ifdef FULCRUM_WIDER_KERNELS
constexpr Kernels kAvx2{"AVX2", avx2_kernels::sample_grid, avx2_kernels::sample_tree};
#endif

}  // namespace

std::array<const Kernels*, 2> all_kernels() noexcept {
#ifdef FULCRUM_WIDER_KERNELS
    return {&kPlain, has_avx2() ? &kAvx2 : nullptr};
#else
    return {&kPlain, nullptr};
#endif
}

const Kernels& best_kernels() noexcept {
    return *widest_of(all_kernels());
}

// F = (n.u/|u|) u for b = 1, and its moment. With w = u/|u|, w_T and w_O the spins of tool and object:
//   dF = (w n^T (I - w w^T) + (n.w) I) du + u (n x w).dtheta        the second because n turns with the tool
//   du = dv + dw_T x r + w_T x (dtheta x r) - w_O x (dx + dtheta x r)    the object's own velocity is another where the point comes
void add_brake_slopes(const Motion& motion, const std::array<float, 3>& point,
                      const std::array<float, 3>& normal, Sums& sums) noexcept {
    const auto to_vector = [](const std::array<float, 3>& a) { return Vector3(a[0], a[1], a[2]); };
    const Vector3 spin = to_vector(motion.spin_T);
    const Vector3 object_spin = to_vector(motion.object_spin_T);
    const Vector3 p = to_vector(point);
    const Vector3 n = to_vector(normal);
    const Vector3 u = to_vector(motion.velocity_T) + spin.cross(p);
    const double towards = n.dot(u);
    if (!(towards < 0.0) || !(u.squaredNorm() > static_cast<double>(kLeastSquare))) {
        return;
    }
    const double speed = u.norm();
    const Vector3 w = u / speed;
    PointForce force;
    force.force = towards / speed * u;
    force.by_velocity = w * (n - n.dot(w) * w).transpose() + n.dot(w) * Matrix3::Identity();
    force.by_position = -force.by_velocity * compute_skew(object_spin);
    Wrench of_no_interest;
    add_point_force(p, spin + object_spin, force, of_no_interest, sums.brake_by);
    const Vector3 by_turn = n.cross(w);
    sums.brake_by.pose.topRightCorner<3, 3>() += u * by_turn.transpose();
    sums.brake_by.pose.bottomRightCorner<3, 3>() += p.cross(u) * by_turn.transpose();
}

}  // namespace fulcrum::voxel_lanes
