#include "haptics/base/range.h"
#include "haptics/levels/level_pairs.h"

#include <algorithm>
#include <utility>

namespace fulcrum {

namespace {

constexpr double kPatch_us = 20.0;  // what one takes, until that is known

}  // namespace

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
    if (settings.now_s == nullptr) {
        return fail("contacts by levels of detail have no clock", {}, "leave now_s as it is");
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
    : settings_(settings),
      tree_(std::move(object), std::move(tool), settings.most_pairs),
      each_us_(kPatch_us),
      waiting_(settings.most_pairs),
      opened_(settings.most_pairs),
      contacts_(settings.most_contacts) {}

PairTree::PairTree(std::shared_ptr<const ContactLevels> object,
                   std::shared_ptr<const ContactLevels> tool, int most_pairs)
    : object_(std::move(object)),
      tool_(std::move(tool)),
      pairs_(static_cast<std::size_t>(most_pairs)) {
    clear();
}

std::size_t LevelPairs::memory_bytes() const noexcept {
    return object().memory_bytes() + (&tool() == &object() ? 0 : tool().memory_bytes()) +
           tree_.memory_bytes() + waiting_.capacity() * sizeof(Waiting) +
           opened_.capacity() * sizeof(std::int32_t) + contacts_.capacity() * sizeof(LevelContact);
}

}  // namespace fulcrum
