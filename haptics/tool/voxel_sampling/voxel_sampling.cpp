#include "haptics/tool/voxel_sampling/voxel_sampling.h"

#include "haptics/math/turned_slopes.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

namespace {

using voxel_lanes::Sums;

std::array<float, 3> to_floats(const Vector3& v) noexcept {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

// Force and moment in T and voxels, each times `force` and `force` times a voxel.
Wrench to_wrench(const std::array<double, 6>& sums, double force, double voxel_m,
                 const Matrix3& R_WT) noexcept {
    return {force * (R_WT * Vector3(sums[0], sums[1], sums[2])),
            force * voxel_m * (R_WT * Vector3(sums[3], sums[4], sums[5]))};
}

// Rows of force and torque, columns of metres and radians, from voxels and T.
Matrix6 to_slopes(const Matrix6& sums, double force, double voxel_m, const Matrix3& R_WT) noexcept {
    Matrix6 slopes = force * compute_turned(sums, R_WT);
    slopes.leftCols<3>() /= voxel_m;
    slopes.bottomRows<3>() *= voxel_m;
    return slopes;
}

// How much of the springs' sum is given, and how that changes with the fullness m.
struct Share {
    double share = 1.0;
    double by_fullness = 0.0;
};

Share compute_share(const VoxelSamplingSettings& settings, const Sums& sums) noexcept {
    const double full = settings.full_contacts;
    switch (settings.averaging) {
        case ContactAveraging::none:
            break;
        case ContactAveraging::beyond: {
            const auto n = static_cast<double>(sums.n_surface);
            return {n > full ? full / n : 1.0, 0.0};
        }
        case ContactAveraging::smooth: {
            const double ratio = sums.fullness / full;
            const double cube = ratio * ratio * ratio;
            const double root = std::sqrt(std::sqrt(1.0 + cube * ratio));
            const double share = 1.0 / root;
            return {share, -cube / full * share / (1.0 + cube * ratio)};
        }
    }
    return {};
}

// b of the header: as set or for one cycle, and bounded by what the tool's motion holds.
double compute_braking_Ns_per_m(const VoxelSamplingSettings& settings,
                                const voxel_lanes::Motion& motion, const Sums& sums,
                                double voxel_m) noexcept {
    const auto to_vector = [](const std::array<float, 3>& a) { return Vector3(a[0], a[1], a[2]); };
    const Vector3 force = voxel_m * Vector3(sums.brake[0], sums.brake[1], sums.brake[2]);
    const Vector3 torque = voxel_m * voxel_m * Vector3(sums.brake[3], sums.brake[4], sums.brake[5]);
    const double power =
        -voxel_m * force.dot(to_vector(motion.velocity_T)) - torque.dot(to_vector(motion.spin_T));
    if (!(power > 0.0)) {
        return 0.0;
    }
    const double yielding = force.squaredNorm() / settings.inertia.mass_kg +
                            torque.cwiseAbs2().cwiseQuotient(settings.inertia.moments_kg_m2).sum();
    const double wanted =
        settings.braking == PreContactBraking::viscous
            ? settings.braking_Ns_per_m
            : settings.inertia.mass_kg / (2.0 * settings.cycle_s * sums.brake_share);
    return std::min(wanted, power / (settings.cycle_s * yielding));
}

// b as derivatives see it. Where points slide along what brakes, b grows as 1 / sum(-n.u/|u|) and the force stays; slopes for a b
// held would grow with it until no step can be solved.
double limit_for_slopes(double braking_Ns_per_m, const VoxelSamplingSettings& settings,
                        std::int64_t n_proximity) noexcept {
    constexpr double kLeastShare = 1.0e-3;  // of -n.u/|u|, at the mean
    const auto n = static_cast<double>(std::max<std::int64_t>(n_proximity, 1));
    return std::min(braking_Ns_per_m,
                    settings.inertia.mass_kg / (2.0 * settings.cycle_s * kLeastShare * n));
}

}  // namespace

void VoxelSampling::set_cycle(double dt_s) noexcept {
    if (dt_s >= kShortestCycle_s && dt_s <= kLongestCycle_s) {
        settings_.cycle_s = dt_s;
    }
}

voxel_lanes::Motion VoxelSampling::compute_motion(const RigidState& state,
                                                  const MovingFrame& object) const noexcept {
    voxel_lanes::Motion motion;
    const Pose X_OT = object.pose_W.inverse() * state.pose_W;
    const Matrix3 R = X_OT.orientation.toRotationMatrix();
    for (std::size_t row = 0; row < 3; ++row) {
        const auto i = static_cast<Index>(row);
        motion.turn[row] = to_floats(R.row(i).transpose());
        motion.last[row] = static_cast<float>(frame_.n_cells[row]) - 0.5F;
    }
    motion.shift = to_floats(frame_.to_lattice(X_OT.position));
    // The tool's motion as the object sees it, at the tool's centre of mass, along the tool's axes.
    const Vector3 object_W = compute_velocity_at(object, state.pose_W.position);
    const Quaternion to_T = state.pose_W.orientation.conjugate();
    motion.velocity_T =
        to_floats(to_T * Vector3(state.velocity_W.linear - object_W) / frame_.voxel_m);
    motion.spin_T = to_floats(to_T * Vector3(state.velocity_W.angular - object.velocity_W.angular));
    motion.object_spin_T = to_floats(to_T * object.velocity_W.angular);
    // No voxel is deeper than half its diagonal.
    motion.least_depth = settings_.plane == TangentPlane::one_side ? 0.0F : -1.0F;
    motion.brakes = settings_.braking != PreContactBraking::off;
    motion.ahead_s = static_cast<float>(settings_.look_ahead_cycles * settings_.cycle_s);
    return motion;
}

bool VoxelSampling::is_far(const RigidState& state, const MovingFrame& object) const noexcept {
    const Vector3 middle =
        frame_.to_lattice(object.pose_W.inverse() * Vector3(state.pose_W.position));
    const double reach = reach_m_ / frame_.voxel_m + 1.0;
    const Vector3 n(frame_.n_cells[0], frame_.n_cells[1], frame_.n_cells[2]);
    return !(all_at_most(Vector3::Constant(-reach), middle) &&
             all_at_most(middle, n + Vector3::Constant(reach)));
}

template <bool kLinear>
VoxelContact VoxelSampling::sample_all(const RigidState& state, const MovingFrame& object,
                                       WrenchJacobian* springs_by,
                                       WrenchJacobian* brakes_by) const noexcept {
    if (is_far(state, object)) {
        return {};
    }
    const voxel_lanes::Motion motion = compute_motion(state, object);
    Sums sums;
    const voxel_lanes::Kernels& kernels = voxel_lanes::best_kernels();
    if (grid_ != nullptr) {
        kernels.sample_grid(shell_, *grid_, motion, kLinear, sums);
    } else {
        kernels.sample_tree(shell_, *map_, motion, kLinear, sums);
    }
    // Springs, averaged.
    const double s = frame_.voxel_m;
    const Matrix3 R_WT = state.pose_W.orientation.toRotationMatrix();
    const Share share = compute_share(settings_, sums);
    const double spring_N = settings_.stiffness_N_per_m * s;
    const Wrench springs = to_wrench(sums.push, share.share * spring_N, s, R_WT);
    // Brakes.
    const double braking_Ns_per_m = compute_braking_Ns_per_m(settings_, motion, sums, s);
    const Wrench brakes = to_wrench(sums.brake, braking_Ns_per_m * s, s, R_WT);
    if constexpr (kLinear) {
        Matrix6 pushed = share.share * sums.push_by_pose;
        pushed += share.by_fullness * Vector6(sums.push.data()) * sums.fullness_by_pose.transpose();
        springs_by->pose += to_slopes(pushed, spring_N, s, R_WT);
        add_turning(springs, springs_by->pose);  // everything but d turns with the tool
        const double slope_N = s * limit_for_slopes(braking_Ns_per_m, settings_, sums.n_proximity);
        brakes_by->pose += to_slopes(sums.brake_by.pose, slope_N, s, R_WT);
        brakes_by->velocity += to_slopes(sums.brake_by.velocity, slope_N, s, R_WT);
    }
    VoxelContact contact;
    contact.wrench_W = {springs.force + brakes.force, springs.torque + brakes.torque};
    contact.brakes_W = brakes;
    contact.n_surface = sums.n_surface;
    contact.n_interior = sums.n_interior;
    contact.n_proximity = sums.n_proximity;
    return contact;
}

bool VoxelSampling::stop_at_touch(const ToolMotion& motion, RigidState& end) const noexcept {
    constexpr double kMostPlaces = 32.0;
    const ToolWay way = find_way(motion, end.pose_W, reach_m_);
    constexpr double kSlow_voxels = 1.0;
    if (!(way.longest_m > kSlow_voxels * frame_.voxel_m) || !std::isfinite(way.longest_m)) {
        return false;
    }
    const double n_places = std::ceil(way.longest_m / (0.5 * frame_.voxel_m));
    // At rest: brakes are not asked.
    const auto count_inside = [&](double share) noexcept {
        RigidState state;
        state.pose_W = compute_between(way.from_OT, way.to_OT, share);
        return sample(state, {}).n_interior;
    };
    const std::int64_t n_before = count_inside(0.0);
    const int n = static_cast<int>(std::min(n_places, kMostPlaces));
    double free_share = 0.0;
    for (int i = 1; i <= n; ++i) {
        const double share = static_cast<double>(i) / n;
        if (count_inside(share) > n_before) {
            put_back(motion, way, free_share, 0.0, end);
            return true;
        }
        free_share = share;
    }
    return false;
}

VoxelContact VoxelSampling::sample(const RigidState& state,
                                   const MovingFrame& object) const noexcept {
    return sample_all<false>(state, object, nullptr, nullptr);
}

VoxelContact VoxelSampling::sample_linearised(const RigidState& state, const MovingFrame& object,
                                              WrenchJacobian& jacobian) const noexcept {
    return sample_all<true>(state, object, &jacobian, &jacobian);
}

VoxelContact VoxelSampling::sample_linearised(const RigidState& state, const MovingFrame& object,
                                              WrenchJacobian& springs_by,
                                              WrenchJacobian& brakes_by) const noexcept {
    return sample_all<true>(state, object, &springs_by, &brakes_by);
}

}  // namespace fulcrum
