#include "haptics/tool/level_contacts.h"

#include <utility>

namespace fulcrum {

Expected<std::unique_ptr<LevelContacts>> LevelContacts::create(
    std::shared_ptr<const ContactLevels> object, std::shared_ptr<const ContactLevels> tool,
    const LevelPairSettings& settings) {
    auto pairs = LevelPairs::create(std::move(object), std::move(tool), settings);
    if (!pairs) {
        return tl::make_unexpected(pairs.error());
    }
    return std::unique_ptr<LevelContacts>(new LevelContacts(std::move(*pairs)));
}

void LevelContacts::find(const Pose& X_OT, double within_m,
                         BoundedList<NearContact>& near) noexcept {
    answer_ = pairs_->find(X_OT, within_m);
    const std::span<const LevelContact> contacts = pairs_->contacts();
    const std::size_t room = near.capacity() - near.count();
    if (contacts.empty() || room == 0) {
        return;
    }
    // Every so manieth where there is no room for all.
    const std::size_t thinning = (contacts.size() + room - 1) / room;
    const Pose X_TO = X_OT.inverse();
    // What only just came near weighs nothing where it is used.
    constexpr double kJustNear = 0.999;
    for (std::size_t i = 0; i < contacts.size(); i += thinning) {
        if (contacts[i].depth_m <= -kJustNear * within_m) {
            continue;
        }
        near.add({X_TO * contacts[i].point_O, contacts[i].normal_O, contacts[i].depth_m});
    }
}

}  // namespace fulcrum
