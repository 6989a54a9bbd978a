// Near contacts by contact levels of detail (levels/level_pairs.h): triangles against triangles, as finely as can be felt.
//
// Beside field_contacts: needs no field and no points, knows no band, and its time goes down with a tolerance or is bounded by a budget.
// What is deeper inside than d is found only where the surfaces cross.
//
// Thread: one at a time; build at load. Cost: see level_pairs.h; no allocation.
#pragma once

#include "haptics/levels/level_pairs.h"
#include "haptics/tool/near_contact.h"

#include <memory>

namespace fulcrum {

/// What one object is found by.
struct LevelContactsPlan {
    std::shared_ptr<const ContactLevels> object;
    std::shared_ptr<const ContactLevels>
        tool;  ///< about the tool's centre of mass, along its principal axes
    LevelPairSettings settings{};
};

class LevelContacts final : public ContactFinder {
  public:
    /// The tool's levels are in its frame T. Refuses what `LevelPairs::create` does.
    [[nodiscard]] static Expected<std::unique_ptr<LevelContacts>> create(
        std::shared_ptr<const ContactLevels> object, std::shared_ptr<const ContactLevels> tool,
        const LevelPairSettings& settings = {});

    /// `within_m` is at most what the levels were made for.
    void find(const Pose& X_OT, double within_m, BoundedList<NearContact>& near) noexcept override;
    /// How the last question went.
    [[nodiscard]] const LevelAnswer& answer() const noexcept { return answer_; }
    [[nodiscard]] double reach_m() const noexcept override { return pairs_->tool().reach_m(); }
    [[nodiscard]] std::size_t memory_bytes() const noexcept override {
        return pairs_->memory_bytes();
    }

  private:
    explicit LevelContacts(std::unique_ptr<LevelPairs> pairs) : pairs_(std::move(pairs)) {}

    std::unique_ptr<LevelPairs> pairs_;
    LevelAnswer answer_{};
};

}  // namespace fulcrum
