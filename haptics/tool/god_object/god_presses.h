// By what a god-object's tool may be pressed where its motion got: what is told of its contacts to the force (god_contact_set.h). For god_motion.h.
//
// A contact may press within two gaps at rest, where no surface rises beside it; from two on down to one it does so little by little. Its direction
// is felt as its surfaces are shaded (god_shading.h). Something is near within sixteen gaps.
//
// Thread: that of the motion. Cost: 0.1 us a contact; no allocation after it was built.
#pragma once

#include "haptics/tool/god_object/god_contact_set.h"
#include "haptics/tool/god_object/god_pairs.h"
#include "haptics/tool/god_object/god_slips.h"

#include <memory>
#include <vector>

namespace fulcrum {

/// Whether a contact holds the tool, where that rests at `gap_m`.
[[nodiscard]] bool may_press(const GodContact& contact, double gap_m) noexcept;

class GodPresses {
  public:
    GodPresses(const std::vector<GodObjectPlan>& plans, double gap_m);

    /// After a step: whether what is left of a force may still be felt, only beside something. `asks_near`: it must be known even where no contact presses.
    void look(GodPairs& pairs, bool asks_near) noexcept;
    /// Where tool and objects are, and whether they are near each other.
    void tell_places(const GodPairs& pairs, const GodSlips& slips,
                     GodContactSet& set) const noexcept;
    /// What presses there. More than there is room for is left out and told as `too_many`.
    void tell_presses(const GodPairs& pairs, const GodSlips& slips,
                      GodContactSet& set) const noexcept;
    /// Beside itself.
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return shadings_.capacity() * sizeof(Shading);
    }

  private:
    [[nodiscard]] Vector3 find_felt_normal_W(const GodPairs& pairs, std::size_t i,
                                             const GodContact& contact,
                                             const Matrix3& R_WO) const noexcept;
    [[nodiscard]] double find_share(const GodContact& contact) const noexcept;

    struct Shading {
        std::shared_ptr<const GodShading> object, tool;
    };
    double gap_m_;
    std::vector<Shading> shadings_;  // empty where nothing is shaded
    bool is_near_ = false;
};

}  // namespace fulcrum
