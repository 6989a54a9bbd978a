#include "haptics/tool/god_object/god_presses.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr double kPressGaps = 2.0;  // what is within so many may press
constexpr double kPressRise =
    0.05;  // likewise; of a gap: what rounding and the last round leave of a flat contact
constexpr double kNearGaps = 16.0;  // what is within is near

}  // namespace

bool may_press(const GodContact& contact, double gap_m) noexcept {
    return contact.gap_m <= kPressGaps * gap_m && contact.rise_m <= kPressRise * gap_m;
}

void GodPresses::look(GodPairs& pairs, bool asks_near) noexcept {
    const double near_m = kNearGaps * gap_m_;
    const auto presses = [&](const GodContact& contact) { return may_press(contact, gap_m_); };
    is_near_ = pairs.found().least_gap_m <= near_m ||
               std::ranges::any_of(pairs.all(),
                                   [&](const GodPair& pair) {
                                       return std::ranges::any_of(pair.contacts(), presses);
                                   }) ||
               (asks_near && pairs.has_within(near_m));
}

Vector3 GodPresses::find_felt_normal_W(const GodPairs& pairs, std::size_t i,
                                       const GodContact& contact,
                                       const Matrix3& R_WO) const noexcept {
    if (shadings_.empty()) {
        return R_WO * contact.normal_O;
    }
    return R_WO * find_felt_normal_O(shadings_[i].object.get(), shadings_[i].tool.get(), contact,
                                     pairs.seen_OT(i));
}

// What comes nearer begins to press little by little.
double GodPresses::find_share(const GodContact& contact) const noexcept {
    const double gaps = contact.gap_m / gap_m_;
    return std::clamp((kPressGaps - gaps) / (kPressGaps - 1.0), 0.0, 1.0);
}

void GodPresses::tell_places(const GodPairs& pairs, const GodSlips& slips,
                             GodContactSet& set) const noexcept {
    set.is_near = pairs.is_begun() && is_near_;
    set.tool_W = pairs.tool_W();
    set.n_objects = static_cast<std::int32_t>(pairs.size());
    // Where all objects are, though there may be no room for what presses on the last of them.
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        set.objects[i] = {pairs.object_W(i), slips.over(i).from_OT, slips.over(i).to_OT};
    }
}

void GodPresses::tell_presses(const GodPairs& pairs, const GodSlips& slips,
                              GodContactSet& set) const noexcept {
    set.n = 0;
    for (std::size_t i = 0; i < pairs.size() && pairs.is_begun(); ++i) {
        const Pose& object_W = pairs.object_W(i);
        const Matrix3 R_WO = object_W.orientation.toRotationMatrix();
        for (const GodContact& contact : pairs.all()[i].contacts()) {
            if (!may_press(contact, gap_m_)) {
                continue;
            }
            if (static_cast<std::size_t>(set.n) == kMostPresses) {
                set.step.too_many = true;
                return;
            }
            set.presses[static_cast<std::size_t>(set.n++)] = {
                .object = static_cast<std::int32_t>(i),
                .arm_W = R_WO * contact.on_tool_O + object_W.position - pairs.tool_W().position,
                .normal_W = find_felt_normal_W(pairs, i, contact, R_WO),
                .true_W = R_WO * contact.normal_O,
                .on_object_O = contact.on_object_O,
                .least_m = std::min(gap_m_ - contact.gap_m, 0.0),
                .friction = slips.find_friction(i, contact),
                .share = find_share(contact)};
        }
    }
}

}  // namespace fulcrum
