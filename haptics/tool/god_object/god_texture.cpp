// The step path of god_texture.h.
#include "haptics/tool/god_object/god_texture.h"

#include "haptics/math/length.h"
#include "haptics/surface/triplanar.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kEvenedOver = 4.0;  // rounds, as a point's stroke (loop/touch_motion.h)
constexpr double kSteeper = 2.0;     // than the samples show, at most
constexpr double kNoRelief_N =
    1.0e-9;  // of a relief that is level everywhere rounding leaves slopes

// From one length towards another place, by so much at most.
Vector3 follow(const Vector3& from, const Vector3& to, double most) noexcept {
    return from + shorten(Vector3(to - from), most);
}

}  // namespace

void GodTexture::forget() noexcept {
    touched_ = false;
    depth_m_ = 0.0;
    depth_before_m_ = 0.0;
    felt_O_ = {};
}

void GodTexture::begin(const Pose& from_OT, const Pose& to_OT, double force_N) noexcept {
    way_O_ << to_OT.position - from_OT.position,
        compute_log((to_OT.orientation * from_OT.orientation.conjugate()).normalized());
    stroke_O_ = touched_ ? Vector6(stroke_O_ + (way_O_ - stroke_O_) / kEvenedOver) : way_O_;
    centre_O_ = to_OT.position;
    depth_before_m_ = depth_m_;
    depth_m_ = force_N > 0.0 && way_O_.allFinite() ? force_N / settings_.stiffness_N_per_m : 0.0;
    touched_ = depth_m_ > 0.0;
    sum_O_ = {};
}

void GodTexture::add(const Vector3& place_O, const Vector3& normal_O, double force_N) noexcept {
    if (!(depth_m_ > 0.0) || !(force_N > 0.0) || !place_O.allFinite()) {
        return;
    }
    const Vector3 arm_O = place_O - centre_O_;
    const Vector3 stroke_O = stroke_O_.head<3>() + stroke_O_.tail<3>().cross(arm_O);
    const BodyOffset offset = feel_on_body(*texture_, place_O, stroke_O, normal_O, depth_m_);
    add_point_force(arm_O, (force_N / depth_m_) * offset.offset_B_m, sum_O_);
}

GodTexture::Bounds GodTexture::find_bounds() const noexcept {
    const TextureSettings& law = texture_->settings();
    const double slope = steepness_.slope;
    const double curvature = kSteeper * steepness_.curvature_per_m;
    const double height_m = law.gain * law.height_m;
    switch (law.law) {
        case TextureLaw::perturbed_normal: {
            const double lean_m = std::min(depth_m_, height_m);
            return {lean_m * slope, lean_m * curvature + law.gain * slope * slope, slope};
        }
        case TextureLaw::lateral:
            return {law.gain * depth_m_ * slope, law.gain * depth_m_ * curvature, law.gain * slope};
        case TextureLaw::height_offset:
            break;
    }
    const double lost_m = std::min(depth_m_, height_m);
    const double lean_m = law.gain * depth_m_;
    return {lost_m + lean_m * slope,
            law.gain * slope + lean_m * curvature + law.gain * law.gain * slope * slope,
            1.0 + law.gain * slope};
}

const Wrench& GodTexture::finish(double dt_s) noexcept {
    const double stiffness = settings_.stiffness_N_per_m;
    const double reach_m = settings_.reach_m;
    const Bounds bounds = find_bounds();
    const double most_N = stiffness * bounds.most_m;
    // Nothing of it is left of a push that is gone.
    if (!(most_N > kNoRelief_N)) {
        felt_O_ = {};
        return felt_O_;
    }
    if (settings_.fade_s > 0.0) {
        const double way_m =
            std::max(way_O_.head<3>().norm() + reach_m * way_O_.tail<3>().norm(),
                     stroke_O_.head<3>().norm() + reach_m * stroke_O_.tail<3>().norm());
        const double change_N =
            most_N * (dt_s / settings_.fade_s + way_m / reach_m) +
            stiffness *
                (bounds.per_m * way_m + bounds.per_deep * std::abs(depth_m_ - depth_before_m_));
        felt_O_.force = follow(felt_O_.force, sum_O_.force, change_N);
        felt_O_.torque = follow(felt_O_.torque, sum_O_.torque, reach_m * change_N);
    } else {
        felt_O_ = sum_O_;
    }
    felt_O_.force = limit_length(felt_O_.force, most_N);
    felt_O_.torque = limit_length(felt_O_.torque, reach_m * most_N);
    return felt_O_;
}

}  // namespace fulcrum
