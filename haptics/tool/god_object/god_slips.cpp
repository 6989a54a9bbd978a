#include "haptics/tool/god_object/god_slips.h"

namespace fulcrum {
namespace {

constexpr double kSlipShare = 1.0e-3;  // of the gap at rest: what goes so far in a step slips

}  // namespace

void GodSlips::forget(const GodPairs& pairs) noexcept {
    for (std::size_t i = 0; i < slips_.size() && is_followed_; ++i) {
        const Pose at_OT = pairs.seen_OT(i);
        slips_[i] = {at_OT, at_OT};
    }
}

void GodSlips::note(const GodPairs& pairs) noexcept {
    for (std::size_t i = 0; i < slips_.size() && is_followed_; ++i) {
        slips_[i] = {slips_[i].to_OT, pairs.seen_OT(i)};
    }
}

double GodSlips::find_friction(std::size_t i, const GodContact& contact) const noexcept {
    const FrictionSettings& friction = frictions_[i];
    if (friction.static_coefficient == friction.dynamic_coefficient) {
        return friction.dynamic_coefficient;
    }
    const Slip& slip = slips_[i];
    const Vector3 at_T = slip.to_OT.inverse() * contact.on_tool_O;
    const Vector3 slip_O = slip.to_OT * at_T - slip.from_OT * at_T;
    const Vector3 along_O = slip_O - contact.normal_O * contact.normal_O.dot(slip_O);
    return along_O.norm() > kSlipShare * gap_m_ ? friction.dynamic_coefficient
                                                : friction.static_coefficient;
}

}  // namespace fulcrum
