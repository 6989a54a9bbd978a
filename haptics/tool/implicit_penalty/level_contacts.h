// Near contacts by contact levels of detail (levels/level_pairs.h): triangles against triangles, as finely as can be felt.
//
// Beside field_contacts: needs no field and no points, knows no band, and its time goes down with a tolerance or is bounded by a budget. Where
// time was up `answer()` says how many pairs were left, how deep these may be, and how far off a contact's push then is.
// What is deeper inside than d is found only where the surfaces cross; where one is wholly inside the other, by how often a mesh winds round a
// point of the other's (winding_number.h), where clusters of triangles are given for that.
//
// Thread: one at a time; build at load. Cost: see level_pairs.h; no allocation.
#pragma once

#include "haptics/levels/level_pairs.h"
#include "haptics/tool/implicit_penalty/near_contact.h"
#include "haptics/voxel/triangle_clusters.h"

#include <memory>
#include <utility>

namespace fulcrum {

/// What one object is found by.
struct LevelContactsPlan {
    std::shared_ptr<const ContactLevels> object;
    std::shared_ptr<const ContactLevels>
        tool;  ///< about the tool's centre of mass, along its principal axes
    LevelPairSettings settings{};
    // The same meshes' triangles, or null: then nothing is known to be enclosed.
    std::shared_ptr<const TriangleClusters> object_solid{};
    std::shared_ptr<const TriangleClusters> tool_solid{};
};

class LevelContacts final : public ContactFinder {
  public:
    /// The tool's levels are in its frame T. Refuses what `LevelPairs::create` does.
    [[nodiscard]] static Expected<std::unique_ptr<LevelContacts>> create(
        const LevelContactsPlan& plan);
    [[nodiscard]] static Expected<std::unique_ptr<LevelContacts>> create(
        std::shared_ptr<const ContactLevels> object, std::shared_ptr<const ContactLevels> tool,
        const LevelPairSettings& settings = {}) {
        return create({std::move(object), std::move(tool), settings});
    }

    /// `within_m` is at most what the levels were made for.
    void find(const Pose& X_OT, double within_m, BoundedList<NearContact>& near) noexcept override;
    /// No longer than the plan's own budget, where it has one.
    void limit(double budget_us) noexcept override;
    [[nodiscard]] bool is_cut() const noexcept override { return is_cut_; }
    [[nodiscard]] bool is_enclosed(const Pose& X_OT) const noexcept override;
    /// How the last question went.
    [[nodiscard]] const LevelAnswer& answer() const noexcept { return answer_; }
    [[nodiscard]] double reach_m() const noexcept override { return pairs_->tool().reach_m(); }
    [[nodiscard]] std::size_t memory_bytes() const noexcept override {
        return pairs_->memory_bytes();
    }

  private:
    LevelContacts(std::unique_ptr<LevelPairs> pairs, const LevelContactsPlan& plan);

    std::unique_ptr<LevelPairs> pairs_;
    std::shared_ptr<const TriangleClusters> object_solid_;
    std::shared_ptr<const TriangleClusters> tool_solid_;
    double budget_us_;
    LevelAnswer answer_{};
    bool is_cut_ = false;
};

}  // namespace fulcrum
