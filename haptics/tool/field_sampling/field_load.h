// A tool of points against a distance field (field_sampler.h) as a load on a rigid body, for every integrator and for the tool on
// its coupling: the same face as voxel sampling has, so that either carries a tool.
//
//   wrench      as field_sampler.h has it; continuous across voxels along `normals`, conservative along `slopes`
//   derivative  by the tool's pose, exact within a cell; none by its velocity, for the field neither brakes nor damps
// With a budget of time both are those of the points that were looked at, for all they stand for, and how far the wrench may be off is
// told with it. What was found in the last step says where to look first, so that the same pose may give another wrench in another
// step; within one the first look chooses for all.
// A motion that would take a point deeper than a voxel, or deeper than it was, can be stopped where it does (`find_first_touch`).
// What counts as a touch: a point inside the object, F < 0. It lies in the layer that pushes until it is as deep as the band
// (distance_field.h), from where on it is pushed out as well, but has penetrated. Nothing is felt before F = 0.
//
// Thread: one at a time, also to ask: the sampler remembers what is free, which without a budget changes no answer. Cost: that of
// field sampling; with derivatives 0.1 us more for a point that touches, within the budget where there is one. No allocation.
#pragma once

#include "haptics/tool/field_sampling/field_sampler.h"
#include "haptics/tool/tool_motion.h"
#include "haptics/tool/voxel_sampling/voxel_sampling.h"

namespace fulcrum {

/// What is sampled.
struct FieldSamplingPlan {
    FieldSampler::Field field;
    FieldSampler::Shell shell;  ///< from the tool's centre of mass, along its principal axes
    FieldSamplingSettings settings{};
};

class FieldSampling {
  public:
    /// How deep a motion may take a point that was not as deep: what pushes back, and less than walls are thick that the field has.
    static constexpr double kSweptDepth_voxels = 1.0;

    /// Refuses what FieldSampler::build does.
    [[nodiscard]] static Expected<FieldSampling> build(FieldSamplingPlan plan);

    [[nodiscard]] const VoxelFrame& frame() const noexcept { return sampler_.field().frame(); }
    [[nodiscard]] const FieldSamplingSettings& settings() const noexcept {
        return sampler_.settings();
    }
    [[nodiscard]] std::size_t n_points() const noexcept { return sampler_.shell().n_points(); }
    /// What is asked from now on is one step's: FieldSampler::begin_step.
    void begin_step(StepTime* time, int n_near) const noexcept {
        sampler_.begin_step(time, n_near);
    }
    /// How far the farthest point lies from the tool's centre of mass.
    [[nodiscard]] double reach_m() const noexcept { return sampler_.shell().reach_m(); }
    /// Of field and points, and what is remembered.
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

    /// The tool in `state` against the object in `object`, both in W: `n_surface` points are inside the object, of those looked at
    /// and what they stand for; `n_interior` is 1 where the deepest looked at is as deep as the band; nothing brakes.
    [[nodiscard]] VoxelContact sample(const RigidState& state,
                                      const MovingFrame& object) const noexcept;
    /// The same; adds the derivatives by the tool's pose.
    [[nodiscard]] VoxelContact sample_linearised(const RigidState& state, const MovingFrame& object,
                                                 WrenchJacobian& jacobian) const noexcept;
    /// The same: nothing brakes.
    [[nodiscard]] VoxelContact sample_linearised(const RigidState& state, const MovingFrame& object,
                                                 WrenchJacobian& springs_by,
                                                 WrenchJacobian& /*brakes_by*/) const noexcept {
        return sample_linearised(state, object, springs_by);
    }

    /// Puts `end`, where the motion leads, back to where its first point comes deeper than that, with as much of its velocity
    /// relative to the object; whether it did. `depth_m`: of the deepest point at the start. Asks nothing of a motion too short for
    /// it, which every slow one is; else a search of the tree for each tenth of a voxel at worst.
    bool stop_at_touch(const ToolMotion& motion, double depth_m, RigidState& end) const noexcept;

  private:
    explicit FieldSampling(FieldSampler sampler) noexcept : sampler_(std::move(sampler)) {}
    [[nodiscard]] VoxelContact to_contact(const FieldTouch& touch) const noexcept;

    mutable FieldSampler sampler_;  // remembers what is free
};

/// The same as a load on the tool.
using FieldSamplingLoad = SamplingLoad<FieldSampling>;

}  // namespace fulcrum
