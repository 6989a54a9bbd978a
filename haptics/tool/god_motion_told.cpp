// What god_motion.h tells of where the tool got: by what it may be pressed there, and by which coefficients that holds along itself.
#include "haptics/tool/god_motion.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr double kPressGaps = 2.0;  // what is within so many may press
constexpr double kPressRise =
    0.05;  // likewise; of a gap: what rounding and the last round leave of a flat contact
constexpr double kSlipShare = 1.0e-3;  // of the gap at rest: what goes so far in a step slips
constexpr double kNearGaps = 16.0;     // what is within is near

}  // namespace

bool GodMotion::may_press(const GodContact& contact) const noexcept {
    return contact.gap_m <= kPressGaps * settings_.gap_m &&
           contact.rise_m <= kPressRise * settings_.gap_m;
}

// Whether what is left of a force may still be felt: only beside something.
bool GodMotion::find_near(bool asks_near) noexcept {
    const double near_m = kNearGaps * settings_.gap_m;
    const auto presses = [&](const GodContact& contact) { return may_press(contact); };
    if (step_.least_gap_m <= near_m || std::ranges::any_of(pairs_, [&](const GodPair& pair) {
            return std::ranges::any_of(pair.contacts(), presses);
        })) {
        return true;
    }
    if (!asks_near) {
        return false;
    }
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        if (pairs_[i].has_within(objects_W_[i].inverse() * pose_W_, near_m)) {
            return true;
        }
    }
    return false;
}

// Of a place of the tool over the object, in the step before: it holds by the static coefficient what did not slip.
double GodMotion::find_friction(std::size_t i, const GodContact& contact) const noexcept {
    const FrictionSettings& friction = frictions_[i];
    if (friction.static_coefficient == friction.dynamic_coefficient) {
        return friction.dynamic_coefficient;
    }
    const Slip& slip = slips_[i];
    const Vector3 at_T = slip.to_OT.inverse() * contact.on_tool_O;
    const Vector3 slip_O = slip.to_OT * at_T - slip.from_OT * at_T;
    const Vector3 along_O = slip_O - contact.normal_O * contact.normal_O.dot(slip_O);
    return along_O.norm() > kSlipShare * settings_.gap_m ? friction.dynamic_coefficient
                                                         : friction.static_coefficient;
}

Vector3 GodMotion::find_felt_normal_W(std::size_t i, const GodContact& contact,
                                      const Matrix3& R_WO) const noexcept {
    if (shadings_.empty()) {
        return R_WO * contact.normal_O;
    }
    const Pose X_OT = objects_W_[i].inverse() * pose_W_;
    return R_WO *
           find_felt_normal_O(shadings_[i].object.get(), shadings_[i].tool.get(), contact, X_OT);
}

void GodMotion::note_slips() noexcept {
    for (std::size_t i = 0; i < pairs_.size() && is_followed_; ++i) {
        slips_[i] = {slips_[i].to_OT, objects_W_[i].inverse() * pose_W_};
    }
}

void GodMotion::forget_slips() noexcept {
    for (std::size_t i = 0; i < pairs_.size() && is_followed_; ++i) {
        const Pose at_OT = objects_W_[i].inverse() * pose_W_;
        slips_[i] = {at_OT, at_OT};
    }
}

// What comes nearer begins to press little by little.
double GodMotion::find_press_share(const GodContact& contact) const noexcept {
    const double gaps = contact.gap_m / settings_.gap_m;
    return std::clamp((kPressGaps - gaps) / (kPressGaps - 1.0), 0.0, 1.0);
}

bool GodMotion::tell(GodContactSet& set) const noexcept {
    set.step = step_;
    set.is_near = is_begun_ && is_near_;
    set.tool_W = pose_W_;
    set.n_objects = static_cast<std::int32_t>(pairs_.size());
    // Where all objects are, though there may be no room for what presses on the last of them.
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        set.objects[i] = {objects_W_[i], slips_[i].from_OT, slips_[i].to_OT};
    }
    if (is_told()) {
        tell_presses(set);
    }
    return is_told();
}

void GodMotion::tell_presses(GodContactSet& set) const noexcept {
    set.n = 0;
    for (std::size_t i = 0; i < pairs_.size() && is_begun_; ++i) {
        const Matrix3 R_WO = objects_W_[i].orientation.toRotationMatrix();
        for (const GodContact& contact : pairs_[i].contacts()) {
            if (!may_press(contact)) {
                continue;
            }
            if (static_cast<std::size_t>(set.n) == kMostPresses) {
                set.step.too_many = true;
                return;
            }
            set.presses[static_cast<std::size_t>(set.n++)] = {
                .object = static_cast<std::int32_t>(i),
                .arm_W = R_WO * contact.on_tool_O + objects_W_[i].position - pose_W_.position,
                .normal_W = find_felt_normal_W(i, contact, R_WO),
                .true_W = R_WO * contact.normal_O,
                .on_object_O = contact.on_object_O,
                .least_m = std::min(settings_.gap_m - contact.gap_m, 0.0),
                .friction = find_friction(i, contact),
                .share = find_press_share(contact)};
        }
    }
}

}  // namespace fulcrum
