#include "haptics/base/range.h"
#include "haptics/levels/level_pairs.h"

#include <utility>

namespace fulcrum {

Expected<void> validate(const LevelPairSettings& settings) {
    const Range ranges[] = {
        {"tolerance_m", settings.tolerance_m, 0.0, 1.0},
        {"budget_us", settings.budget_us, 0.0, 1.0e6},
        {"spread_m", settings.spread_m, 1.0e-6, 10.0},
        {"most_pairs", static_cast<double>(settings.most_pairs), 64.0, double{1 << 24}},
        {"most_contacts", static_cast<double>(settings.most_contacts), 1.0, double{1 << 20}}};
    return check_ranges("contacts by levels of detail", ranges);
}

Expected<std::unique_ptr<LevelPairs>> LevelPairs::create(
    std::shared_ptr<const ContactLevels> object, std::shared_ptr<const ContactLevels> tool,
    const LevelPairSettings& settings) {
    if (const Expected<void> right = validate(settings); !right) {
        return tl::make_unexpected(right.error());
    }
    if (object == nullptr || tool == nullptr) {
        return fail("contacts by levels of detail have no levels", {},
                    "give those of the object and of the tool");
    }
    if (object->settings().within_m != tool->settings().within_m) {
        return fail("the object's levels were made for another distance than the tool's", {},
                    "make both with the same within_m");
    }
    return std::unique_ptr<LevelPairs>(
        new LevelPairs(std::move(object), std::move(tool), settings));
}

LevelPairs::LevelPairs(std::shared_ptr<const ContactLevels> object,
                       std::shared_ptr<const ContactLevels> tool, const LevelPairSettings& settings)
    : object_(std::move(object)),
      tool_(std::move(tool)),
      settings_(settings),
      pairs_(static_cast<std::size_t>(settings.most_pairs)),
      waiting_(settings.most_pairs),
      opened_(settings.most_pairs),
      contacts_(settings.most_contacts) {
    clear();
}

void LevelPairs::clear() noexcept {
    free_ = kNone;
    for (std::size_t i = pairs_.size(); i-- > 0;) {
        pairs_[i].next = free_;
        pairs_[i].first_child = kNone;
        free_ = static_cast<std::int32_t>(i);
    }
    n_kept_ = 0;
    moved_m_ = 0.0;
    root_ = make_pair(0, 0);
}

std::size_t LevelPairs::memory_bytes() const noexcept {
    return object_->memory_bytes() + (tool_ == object_ ? 0 : tool_->memory_bytes()) +
           pairs_.capacity() * sizeof(Pair) + waiting_.capacity() * sizeof(Waiting) +
           opened_.capacity() * sizeof(std::int32_t) + contacts_.capacity() * sizeof(LevelContact);
}

}  // namespace fulcrum
