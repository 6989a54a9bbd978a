#include "haptics/field/weight.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr double kShortestOnset_s = 0.02;
constexpr double kSameTarget_N =
    1.0e-9;  // a thousandth of what any device resolves, far above rounding

}  // namespace

WeightRamp::WeightRamp(double onset_s) noexcept
    : onset_s_(onset_s > kShortestOnset_s ? onset_s : kShortestOnset_s) {}

void WeightRamp::start(const Vector3& target_W) noexcept {
    const Vector3 way = target_W - force_W_;
    const Vector3 v = rate_W_ * onset_s_;
    const Vector3 a = acceleration_W_ * (onset_s_ * onset_s_);
    c_[0] = force_W_;
    c_[1] = v;
    c_[2] = 0.5 * a;
    c_[3] = 10.0 * way - 6.0 * v - 1.5 * a;
    c_[4] = -15.0 * way + 8.0 * v + 1.5 * a;
    c_[5] = 6.0 * way - 3.0 * v - 0.5 * a;
    target_W_ = target_W;
    age_s_ = 0.0;
    moving_ = true;
}

const Vector3& WeightRamp::step(const Vector3& target_W, double dt_s) noexcept {
    if (is_finite(target_W) && (target_W - target_W_).cwiseAbs().maxCoeff() > kSameTarget_N) {
        start(target_W);
    }
    if (!moving_ || !(dt_s > 0.0)) {
        return force_W_;
    }
    age_s_ += dt_s;
    if (age_s_ >= onset_s_) {
        force_W_ = target_W_;
        rate_W_.setZero();
        acceleration_W_.setZero();
        moving_ = false;
        return force_W_;
    }
    const double s = age_s_ / onset_s_;
    force_W_ = c_[0] + s * (c_[1] + s * (c_[2] + s * (c_[3] + s * (c_[4] + s * c_[5]))));
    rate_W_ =
        (c_[1] + s * (2.0 * c_[2] + s * (3.0 * c_[3] + s * (4.0 * c_[4] + s * 5.0 * c_[5])))) /
        onset_s_;
    acceleration_W_ = (2.0 * c_[2] + s * (6.0 * c_[3] + s * (12.0 * c_[4] + s * 20.0 * c_[5]))) /
                      (onset_s_ * onset_s_);
    return force_W_;
}

}  // namespace fulcrum
