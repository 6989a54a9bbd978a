// How far the result of a look may be off for what was left out of it.
//
//   bound    k L_n sum over nodes left out of n D, and the samples' own sum. D = L min(-slack, m - m_free): how deep a node may be
//            by its ball and by when it was free last; where that is beyond 3/4 of the band, a brick's diagonal more, and as deep as
//            anything in the object where its middle may be. n its points, L_n = 1 by normals, L by slopes. For the torque times
//            the tool's reach. Never exceeded for closed meshes; often many times the error
//   error    where samples stand for all, or told where to look: four times the square root of 16/15 sum |X_l - mean|^2 over 16
//            interleaved sums X_l, as if samples were drawn by chance; they are spread evenly, so that the error is less. And for
//            what the first look missed at the rim, 2^m sqrt(N) points half as deep as the deepest, N its leaves that did; at least
//            as much as closer looks changed the sum. Else, and where the clock cut a look short, the bound. In local contact 5 to
//            25 times the true error at the median, in a socket 30 to 60 times
//
// Thread: that of the step. Cost: 10 ns a node left out.
#pragma once

#include "haptics/tool/field_sampling/field_sampling_settings.h"
#include "haptics/tool/field_sampling/leaf_sums.h"

namespace fulcrum {

/// What samples that told where to look may have missed.
struct SampleMiss {
    double points = 0.0;     ///< at the rim; 0: there were no such samples
    double force_m = 0.0;    ///< by which closer looks moved the force, over the stiffness
    double torque_m2 = 0.0;  ///< likewise the torque
};

class LookError {
  public:
    LookError(const SampledPair& pair, const FieldSamplingSettings& settings);

    /// Nothing is left out.
    void begin() noexcept;
    /// A node that may be so deep by slack and motion, with all its points.
    void leave_out(const SampledPair& pair, std::size_t level, std::size_t node,
                   float depth_voxels) noexcept;
    void set_miss(const SampleMiss& miss) noexcept { miss_ = miss; }
    [[nodiscard]] const SampleMiss& miss() const noexcept { return miss_; }
    /// Whether the clock ended the look before it had all it wanted.
    void set_cut_short(bool is_cut) noexcept { is_cut_short_ = is_cut; }
    [[nodiscard]] bool is_cut_short() const noexcept { return is_cut_short_; }

    /// Adds all of it to what the sums told of wrench and depth.
    void tell(const SampledPair& pair, const LeafSums& sums, FieldTouch& touch) const noexcept;

  private:
    // How deep any point of a node may be that may be so deep by slack and motion.
    [[nodiscard]] double bound_depth_m(const SampledPair& pair, std::size_t level, std::size_t node,
                                       float depth_voxels) const noexcept;

    double stiffness_N_per_m_;
    double slope_;             // L_n
    double deepest_voxels_;    // of all the object's bricks
    double left_out_m_ = 0.0;  // sum of n D
    std::int64_t n_left_ = 0;
    SampleMiss miss_;
    bool is_cut_short_ = false;
};

}  // namespace fulcrum
