// How far a motion of a tool of points may go in a distance field: conservative advancement.
//
// With F_i(t) of point i on its way, voxels, and its limit
//   l_i = min(l, F_i(0) - slack),   l = a L / 2 - deepest        a the least advance, L the field's slope bound
// the motion goes on from t by min (F_i - l_i) / L, which no point outruns, or by a where that is less: sliding along a surface would
// take for ever otherwise. Samples a apart see every way into the surface but the last a L / 2, which l makes up for. Deeper than 3/4 of
// the band F is told by the depth, -D, which goes on where F ends.
// Points that touch at the start stop only what takes them deeper; a motion along the surface or out of it is free. So a tool in contact
// moves, and one that is fast does not tunnel through a wall that is more than twice the depth let to it.
//
// Thread: that of the step. Cost: a search of the tree for each advance.
// Source: B. Mirtich 1996, Impulse-based dynamic simulation, PhD thesis, Berkeley, section 2.3.2.
#pragma once

#include "haptics/tool/field_sampling/look_time.h"
#include "haptics/tool/field_sampling/shell_search.h"

#include <span>

namespace fulcrum {

class FieldSweep {
  public:
    static constexpr double kNearTouch_voxels = 0.15;  ///< it ends no more than that before a touch
    static constexpr int kMaxAdvances = 200;

    /// From one pose to the other, straight for the origin, about one axis at an even rate; no point may come deeper than `deepest_m`,
    /// at most 3/4 of the band. Refers to the pair.
    FieldSweep(const SampledPair& pair, const Pose& from_OT, const Pose& to_OT,
               double deepest_m) noexcept;

    /// The share of the way that may be gone. Where the step's time ends, so does the motion: a tenth of a voxel at most beyond what was
    /// looked at.
    [[nodiscard]] double find_first_touch(ShellSearch& search, LookTime& time) const noexcept;

  private:
    // How far all points may go there at least, voxels; below 0 where one is beyond its limit.
    [[nodiscard]] double find_margin(double share, float slack_voxels, ShellSearch& search,
                                     LookTime& time) const noexcept;
    [[nodiscard]] float find_leaf_margin(const FieldLook& look, std::size_t leaf,
                                         float slack_voxels) const noexcept;
    void deepen(const ShellPoints& points, const Pose& X_OT,
                std::span<float> values) const noexcept;
    [[nodiscard]] double find_end(double free, double not_free, ShellSearch& search,
                                  LookTime& time) const noexcept;

    FieldLook start_;
    Pose to_OT_;
    double way_voxels_;  // of the fastest point
    float limit_voxels_;
};

}  // namespace fulcrum
