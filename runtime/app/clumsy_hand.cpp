#include "runtime/app/clumsy_hand.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum::runtime {
namespace {

constexpr double kTremorTime_s = 0.15;
// From one to the next, and how long it lasts.
constexpr double kStraysAfter_s[] = {5.0, 9.0};
constexpr double kStaysAway_s[] = {0.7, 1.5};
constexpr double kSlipsAfter_s[] = {3.0, 8.0};
constexpr double kSlip_s[] = {0.1, 0.3};

}  // namespace

// By Box and Muller.
double ClumsyHand::draw_normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - chance_.draw_chance()));
    return radius * std::cos(2.0 * std::numbers::pi * chance_.draw_chance());
}

void ClumsyHand::wander(double now_s) {
    if (now_s < strays_s_) {
        return;
    }
    if (strays_s_ > 0.0) {
        back_s_ = now_s + draw(kStaysAway_s[0], kStaysAway_s[1]);
        elsewhere_px_ = {draw(0.0, picture_.width_px), draw(0.0, picture_.height_px)};
    }
    strays_s_ = std::max(now_s, back_s_) + draw(kStraysAfter_s[0], kStraysAfter_s[1]);
}

void ClumsyHand::slip(double now_s) {
    if (now_s < slips_s_) {
        return;
    }
    if (slips_s_ > 0.0) {
        slipped_s_ = now_s + draw(kSlip_s[0], kSlip_s[1]);
    }
    slips_s_ = std::max(now_s, slipped_s_) + draw(kSlipsAfter_s[0], kSlipsAfter_s[1]);
}

MousePlace ClumsyHand::step(double now_s, double dt_s, const MousePlace& meant) {
    meant_.push_back({now_s, meant});
    while (meant_.size() > 1 && meant_[1].at_s <= now_s - kLate_s) {
        meant_.pop_front();
    }
    const double kept = std::exp(-dt_s / kTremorTime_s);
    const double spread_px = kTremor_px * picture_.height_px / 720.0;
    const double fresh_px = spread_px * std::sqrt(1.0 - kept * kept);
    tremor_px_ = {kept * tremor_px_.x() + fresh_px * draw_normal(),
                  kept * tremor_px_.y() + fresh_px * draw_normal()};
    wander(now_s);
    slip(now_s);
    MousePlace place = meant_.front().place;
    place.pointer_px = (now_s < back_s_ ? elsewhere_px_ : place.pointer_px) + tremor_px_;
    place.pointer_px = {
        std::clamp(std::round(place.pointer_px.x()), 0.0, picture_.width_px - 1.0),
        std::clamp(std::round(place.pointer_px.y()), 0.0, picture_.height_px - 1.0)};
    place.buttons ^= now_s < slipped_s_ ? 1U : 0U;
    return place;
}

}  // namespace fulcrum::runtime
