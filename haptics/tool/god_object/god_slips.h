// By how much a god-object's tool slipped over each object in its last step, and so by which coefficient a contact holds along itself. For god_motion.h.
//
//   slip = what a place of the tool went along the contact, as the object saw it, in the step before
// What slipped by more than a thousandth of the gap at rest holds by the dynamic coefficient, else by the static one.
//
// Thread: that of the motion. Cost: 30 ns a contact where the coefficients differ; no allocation after it was built.
#pragma once

#include "haptics/tool/god_object/god_pairs.h"

#include <vector>

namespace fulcrum {

class GodSlips {
  public:
    GodSlips(const std::vector<GodObjectPlan>& plans, double gap_m);

    /// Where the tool was over an object before the last step and after it; followed where an object has friction or relief.
    struct Slip {
        Pose from_OT{}, to_OT{};
    };

    /// It is here, and slipped over nothing.
    void forget(const GodPairs& pairs) noexcept;
    /// It is here after a step.
    void note(const GodPairs& pairs) noexcept;
    [[nodiscard]] const Slip& over(std::size_t i) const noexcept { return slips_[i]; }
    /// The coefficient of a contact with the i-th object.
    [[nodiscard]] double find_friction(std::size_t i, const GodContact& contact) const noexcept;
    /// Beside itself.
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return slips_.capacity() * sizeof(Slip) + frictions_.capacity() * sizeof(FrictionSettings);
    }

  private:
    double gap_m_;
    bool is_followed_;
    std::vector<FrictionSettings> frictions_;  // of objects
    std::vector<Slip> slips_;
};

}  // namespace fulcrum
