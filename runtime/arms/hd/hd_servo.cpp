#include "runtime/arms/hd/hd_servo.h"

#include "runtime/arms/hd/hd_trouble.h"
#include "runtime/arms/maker_values.h"

#include <array>
#include <limits>

namespace fulcrum::runtime {
namespace {

constexpr double kMillimetre_m = 1.0e-3;
// What the library leaves as it was is no number.
constexpr double kUntold = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void HdServo::tick(double now_s) noexcept {
    is_inside_.store(true, std::memory_order_release);
    const std::uint64_t n = ticks_.load(std::memory_order_relaxed);
    begun_s_ = n == 0 ? now_s : begun_s_;
    use_.begin_frame(arm_);
    ArmSample newest = read(now_s);
    if (n % kHdCalibrationEvery == 0) {
        look_at_calibration();
    }
    const std::uint32_t trouble = judge(now_s);
    newest.is_there = trouble == hd_no_error;
    Wrench wanted;
    (void)door_.pass([&] { wanted = side_->exchange(newest); });
    give(newest.is_there ? bounded(wanted, traits_).force : Vector3{Vector3::Zero()});
    use_.end_frame(arm_);
    take_errors(now_s);
    trouble_.store(trouble, std::memory_order_release);
    ticks_.store(n + 1, std::memory_order_release);
    is_inside_.store(false, std::memory_order_release);
}

ArmSample HdServo::read(double now_s) noexcept {
    ArmSample sample;
    sample.stamp_s = now_s;
    std::array<double, 3> position_mm{kUntold, kUntold, kUntold};
    std::array<double, 16> transform{};
    transform.fill(kUntold);
    std::int32_t buttons = 0;
    use_.get_doubles(hd_position, position_mm.data());
    use_.get_doubles(hd_transform, transform.data());
    use_.get_integers(hd_buttons, &buttons);
    const Vector3 position =
        kMillimetre_m * Vector3{position_mm[0], position_mm[1], position_mm[2]};
    Matrix3 R;
    for (std::size_t column = 0; column < 3; ++column) {
        for (std::size_t row = 0; row < 3; ++row) {
            R(static_cast<int>(row), static_cast<int>(column)) = transform[4 * column + row];
        }
    }
    const auto turn = turn_of(R);
    is_pose_ = is_place(position) && turn.has_value();
    if (is_pose_) {
        sample.pose_D = {position, *turn};
        sample.buttons = static_cast<std::uint32_t>(buttons);
    }
    return sample;
}

void HdServo::look_at_calibration() noexcept {
    calibration_ = use_.check_calibration();
    if (calibration_ == hd_needs_update) {
        // There is no force now; whether it has helped the next look tells.
        use_.update_calibration(style_);
    }
}

// Why there is no force in this tick.
std::uint32_t HdServo::judge(double now_s) noexcept {
    if (error_ != hd_no_error && now_s >= rests_until_s_) {
        error_ = hd_no_error;
        // Some errors take the force away for good.
        if (use_.is_enabled(hd_force_output) == 0) {
            use_.enable(hd_force_output);
        }
    }
    return error_ != hd_no_error           ? error_
           : calibration_ != hd_calibrated ? calibration_
           : !is_pose_                     ? kHdNoNumber
                                           : std::uint32_t{hd_no_error};
}

void HdServo::give(const Vector3& force) noexcept {
    const std::array<double, 3> force_N{force.x(), force.y(), force.z()};
    use_.set_doubles(hd_force, force_N.data());
}

void HdServo::take_errors(double now_s) noexcept {
    const bool begins = now_s - begun_s_ < kHdBegin_s;
    const std::uint32_t newest = take_hd_errors(use_, begins ? hd_timer : hd_no_error);
    if (newest != hd_no_error) {
        error_ = newest;
        rests_until_s_ = now_s + rest_after_s(newest);
    }
}

}  // namespace fulcrum::runtime
