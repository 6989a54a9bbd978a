// A tool of points against an object of voxels: force and torque by tangent planes, as McNeely has them.
//
// For each point at p with the unit normal n into the tool, in a voxel with the middle c (s its edge, k the stiffness):
//   surface     F = k d n,  d = max(n.(c - p), 0)      a spring to the plane through c across n; both_sides: without max
//   proximity   F = -b (-n.u/|u|) u  while n.u < 0     u the point's velocity; never while it recedes, so nothing sticks
//               looking ahead by m cycles, only while p + m dt u or p + m dt u/2 lies in surface or interior: without, what
//               glides along an object is dragged, for the point's own normal says nothing of where the object is
//   interior    no force: it has penetrated, and is counted                      free: nothing
// torque = r x F, r from the tool's centre of mass. The sum of the springs over n surface points is averaged:
//   none     sum                        beyond   sum min(1, N/n): a jump of less than 1/N of the others' sum where one comes or goes
//   smooth   sum (1 + (m/N)^4)^(-1/4),  m = sum of min(2 |d|/s, 1): a point comes in without weight, so nothing jumps there
// Brakes:  viscous   b as set           one_cycle   b = M / (2 dt sum(-n.u/|u|)): for a shift u common to all points, the
//   force's power over one step dt takes the kinetic energy M u^2/2 along it, whatever the number of points
// Neither takes more than there is: with f the brakes' wrench for b = 1, V the tool's motion against the object and W its
// inertia,  b <= -f.V / (dt f.W^-1 f),  at which one step leaves the least motion along W^-1 f. More would throw the tool back,
// harder at each step: a point far from the centre of mass is that much easier to turn.
// In free space, with no point in surface or proximity, the wrench is exactly zero.
// McNeely's limit of speed is half a voxel a step. What is faster may pass the layer that pushes: from a voxel a step on
// `stop_at_touch` looks on the way.
//
// The force is continuous within a voxel and jumps by up to k s where a point crosses into the next. Between jumps the
// derivatives are exact but for one_cycle's b and the averaging beyond N, which are held; derivatives take b to be at most
// M / (2 dt 1e-3 n), n the points that are near, for it grows without bound where they slide along what brakes.
//
// Thread: asked from the step, after which `set_object` may move the object. Cost: 0.6 ns a point, more where it touches
// (`fulcrum bench voxel-speed`); no allocation. Places are single precision: voxel_lanes.h says how exact.
// Source: W. McNeely, K. Puterbaugh, J. Troy 1999, Six degree-of-freedom haptic rendering using voxel sampling, sections 3
// (tangent plane), 5.2 (averaging from N = 10), 5.3 (brakes, both forms); N = 70 as in the thesis of systems.md. The smooth
// average, the brakes' bound, their look ahead and the look on the way are ours.
#pragma once

#include "haptics/base/error.h"
#include "haptics/tool/sampling_load.h"
#include "haptics/tool/tool_motion.h"
#include "haptics/tool/voxel_sampling/voxel_lanes.h"
#include "haptics/voxel/pointshell.h"
#include "haptics/voxel/voxmap.h"

#include <cstdint>
#include <memory>

namespace fulcrum {

enum class TangentPlane : std::uint8_t { one_side, both_sides };
enum class ContactAveraging : std::uint8_t { none, beyond, smooth };
enum class PreContactBraking : std::uint8_t { off, viscous, one_cycle };

inline constexpr double kShortestCycle_s = 1.0e-6;
inline constexpr double kLongestCycle_s = 1.0;

/// Fixed at load.
struct VoxelSamplingSettings {
    double stiffness_N_per_m = 500.0;  ///< k, of one point; 0 to 1e6
    TangentPlane plane = TangentPlane::one_side;
    ContactAveraging averaging = ContactAveraging::beyond;
    double full_contacts = 10.0;  ///< N, 1 to 1e6
    PreContactBraking braking = PreContactBraking::one_cycle;
    double braking_Ns_per_m = 1.0;   ///< b of `viscous`, a point; 0 to 1e4
    Inertia inertia{};               ///< of the tool, for the brakes
    double look_ahead_cycles = 0.0;  ///< m of the brakes, 0: McNeely's, by normals alone; to 100
    double cycle_s = 0.001;          ///< dt of the brakes, 1e-6 to 1; a tool's step tells its own
};

/// Refuses settings outside their ranges, NaN included.
[[nodiscard]] Expected<void> validate(const VoxelSamplingSettings& settings);

/// What is sampled. Either map does; both of one object must agree. The grid is faster where it fits the caches.
struct VoxelSamplingPlan {
    std::shared_ptr<const VoxelGrid> grid;  ///< from `voxelise`; or
    std::shared_ptr<const Voxmap> map;      ///< a tree, asked where `grid` is empty
    Pointshell shell;  ///< from the tool's centre of mass, along its principal axes
    VoxelSamplingSettings settings{};
};

/// What the points of one pose add up to.
struct VoxelContact {
    Wrench wrench_W{};             ///< on the tool, N and Nm about its centre of mass
    std::int64_t n_surface = 0;    ///< points in voxels that push, whether they push or not
    std::int64_t n_interior = 0;   ///< points that have penetrated
    std::int64_t n_proximity = 0;  ///< points in voxels that brake
    double error_N = 0.0;   ///< how far the force may be off for points that were left out; 0: none
    double error_Nm = 0.0;  ///< likewise the torque
    double depth_m = 0.0;   ///< of the deepest point, where a field tells it; 0 by voxels
    Wrench brakes_W{};      ///< the brakes' part of `wrench_W`

    /// The deepest kind that any point reached: interior, surface, proximity, free in that order.
    [[nodiscard]] VoxelClass deepest() const noexcept {
        return n_interior > 0    ? VoxelClass::interior
               : n_surface > 0   ? VoxelClass::surface
               : n_proximity > 0 ? VoxelClass::proximity
                                 : VoxelClass::free;
    }
};

class VoxelSampling {
  public:
    /// Refuses settings outside their ranges, a plan without a map, a shell without points or with numbers that are none, and a
    /// grid whose outermost voxels are not free.
    [[nodiscard]] static Expected<VoxelSampling> build(VoxelSamplingPlan plan);

    [[nodiscard]] const VoxelFrame& frame() const noexcept { return frame_; }
    [[nodiscard]] const VoxelSamplingSettings& settings() const noexcept { return settings_; }
    /// Length of the cycle that the brakes reckon with; one out of the settings' range changes nothing.
    void set_cycle(double dt_s) noexcept;
    [[nodiscard]] std::size_t n_points() const noexcept { return shell_.n_points; }
    /// How far the farthest point lies from the tool's centre of mass.
    [[nodiscard]] double reach_m() const noexcept { return reach_m_; }
    /// Of map and points.
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

    /// The tool in `state` against the object in `object`, both in W.
    [[nodiscard]] VoxelContact sample(const RigidState& state,
                                      const MovingFrame& object) const noexcept;
    /// The same; adds the derivatives by the tool's pose and velocity.
    [[nodiscard]] VoxelContact sample_linearised(const RigidState& state, const MovingFrame& object,
                                                 WrenchJacobian& jacobian) const noexcept;
    /// The same, springs and brakes apart.
    [[nodiscard]] VoxelContact sample_linearised(const RigidState& state, const MovingFrame& object,
                                                 WrenchJacobian& springs_by,
                                                 WrenchJacobian& brakes_by) const noexcept;

    /// Puts `end`, where the motion leads, back to the last of some places on the way, half a voxel apart, at which no more points
    /// had penetrated than at its start, where it rests in the object's eyes; whether it did. Of a way of more than 16 voxels the
    /// places lie further apart. Asks nothing of a motion of a voxel or less, else a sampling for each place.
    bool stop_at_touch(const ToolMotion& motion, RigidState& end) const noexcept;

  private:
    VoxelSampling() = default;
    // Not even a ball around the tool reaches the voxels.
    [[nodiscard]] bool is_far(const RigidState& state, const MovingFrame& object) const noexcept;
    template <bool kLinear>
    [[nodiscard]] VoxelContact sample_all(const RigidState& state, const MovingFrame& object,
                                          WrenchJacobian* springs_by,
                                          WrenchJacobian* brakes_by) const noexcept;
    [[nodiscard]] voxel_lanes::Motion compute_motion(const RigidState& state,
                                                     const MovingFrame& object) const noexcept;

    std::shared_ptr<const VoxelGrid> grid_;
    std::shared_ptr<const Voxmap> map_;
    VoxelFrame frame_{};
    voxel_lanes::Shell shell_;
    VoxelSamplingSettings settings_{};
    double reach_m_ = 0.0;
};

/// The same as a load on the tool, for every integrator.
using VoxelSamplingLoad = SamplingLoad<VoxelSampling>;

}  // namespace fulcrum
