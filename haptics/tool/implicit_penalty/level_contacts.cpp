#include "haptics/tool/implicit_penalty/level_contacts.h"

#include "haptics/voxel/winding_number.h"

#include <algorithm>
#include <utility>

namespace fulcrum {

Expected<std::unique_ptr<LevelContacts>> LevelContacts::create(const LevelContactsPlan& plan) {
    auto pairs = LevelPairs::create(plan.object, plan.tool, plan.settings);
    if (!pairs) {
        return tl::make_unexpected(pairs.error());
    }
    return std::unique_ptr<LevelContacts>(new LevelContacts(std::move(*pairs), plan));
}

LevelContacts::LevelContacts(std::unique_ptr<LevelPairs> pairs, const LevelContactsPlan& plan)
    : pairs_(std::move(pairs)),
      object_solid_(plan.object_solid),
      tool_solid_(plan.tool_solid),
      budget_us_(plan.settings.budget_us) {}

void LevelContacts::limit(double budget_us) noexcept {
    const bool is_shorter = budget_us > 0.0 && (budget_us_ == 0.0 || budget_us < budget_us_);
    pairs_->set_budget_us(is_shorter ? budget_us : budget_us_);
}

bool LevelContacts::is_enclosed(const Pose& X_OT) const noexcept {
    return (object_solid_ != nullptr &&
            is_wound_round(*object_solid_, X_OT * pairs_->tool().hull(0).points.front())) ||
           (tool_solid_ != nullptr &&
            is_wound_round(*tool_solid_, X_OT.inverse() * pairs_->object().hull(0).points.front()));
}

void LevelContacts::find(const Pose& X_OT, double within_m,
                         BoundedList<NearContact>& near) noexcept {
    // Always as far out as the levels were made for, for what is kept of a question is of one distance.
    answer_ = pairs_->find(X_OT, pairs_->object().settings().within_m);
    is_cut_ = answer_.is_cut || answer_.is_late || answer_.n_coarser + answer_.n_left > 0;
    const std::span<const LevelContact> contacts = pairs_->contacts();
    const std::size_t room = near.capacity() - near.count();
    if (contacts.empty() || room == 0) {
        return;
    }
    // Where there is no room for all, the deepest of every so many.
    const std::size_t thinning = (contacts.size() + room - 1) / room;
    const Pose X_TO = X_OT.inverse();
    // What only just came near weighs nothing where it is used.
    constexpr double kJustNear = 0.999;
    for (std::size_t i = 0; i < contacts.size(); i += thinning) {
        const LevelContact& contact =
            *std::ranges::max_element(contacts.subspan(i, std::min(thinning, contacts.size() - i)),
                                      {}, &LevelContact::depth_m);
        if (contact.depth_m > -kJustNear * within_m) {
            near.add({X_TO * contact.point_O, contact.normal_O, contact.depth_m});
        }
    }
}

}  // namespace fulcrum
