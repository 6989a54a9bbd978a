// The step path of kite_loop.h.
#include "haptics/flight/kite_loop.h"

#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kFarthestHand_m = 1.0e4;  // from the middle of the world

}  // namespace

void KiteLoop::step(double now_s) noexcept {
    if (!std::isfinite(now_s)) {
        return;
    }
    const double since_s = started_ ? now_s - now_s_ : period_s_;
    started_ = true;
    now_s_ = now_s;
    const double dt_s = std::clamp(since_s, 0.0, kLongestKiteStep_s);
    const bool had_hand = has_hand_;
    take_hand();
    take_kite();
    take_orders();
    if (has_hand_ && !had_hand) {
        launch();
    }
    if (has_hand_) {
        fly(dt_s);
        publish(now_s);
    }
}

// A hand that is nowhere, or where none goes, stays where it was.
void KiteLoop::take_hand() noexcept {
    if (!channels_.hand_W.take()) {
        return;
    }
    const Vector3& told_W = channels_.hand_W.value();
    if (!is_finite(told_W) || told_W.cwiseAbs().maxCoeff() > kFarthestHand_m) {
        return;
    }
    hand_aim_W_ = told_W;
    if (!has_hand_) {
        hand_W_ = hand_aim_W_;
        has_hand_ = true;
    }
}

// In parts as long as a round in time; the hand goes evenly meanwhile, and the reel turns.
void KiteLoop::fly(double dt_s) noexcept {
    const int n_parts = std::max(static_cast<int>(std::lround(dt_s / period_s_)), 1);
    const double part_s = dt_s / n_parts;
    const Vector3 way_W = hand_aim_W_ - hand_W_;
    const double way_m = compute_length(way_W);
    const double most_m = kFastestLineHand_m_per_s * dt_s;
    const Vector3 part_W = (way_m > most_m ? most_m / way_m : 1.0) / n_parts * way_W;
    for (int i = 0; i < n_parts; ++i) {
        // There to the bit in a round in time: a hand at rest rests.
        hand_W_ = i + 1 == n_parts && way_m <= most_m ? hand_aim_W_ : Vector3(hand_W_ + part_W);
        turn_reel(part_s);
        flight_->step(part_s, hand_W_);
    }
}

// Whatever the line did before has nothing to do with what comes.
void KiteLoop::launch() noexcept {
    flight_->launch(hand_W_, orders_.elevation_rad, orders_.lean_rad);
    ++n_launches_;
}

// Another kite on as much line, in the same wind.
void KiteLoop::take_kite() noexcept {
    KiteFlight* built = channels_.built.take(flight_);
    if (built == nullptr) {
        return;
    }
    built->set_line_length_m(flight_->line().length_m());
    flight_ = built;
    if (has_orders_) {
        flight_->set_wind_speed_m_per_s(orders_.wind_m_per_s);
    }
    if (has_hand_) {
        launch();
    }
}

void KiteLoop::take_orders() noexcept {
    if (channels_.orders.take()) {
        const KiteOrders& newest = channels_.orders.value();
        const bool is_launch = newest.n_launches != orders_.n_launches;
        const bool is_cut = newest.n_cuts != orders_.n_cuts;
        orders_ = newest;
        has_orders_ = true;
        flight_->set_wind_speed_m_per_s(orders_.wind_m_per_s);
        if (is_launch && has_hand_) {
            launch();
        }
        if (is_cut) {
            flight_->snap_line();
        }
    }
}

void KiteLoop::turn_reel(double dt_s) noexcept {
    if (has_orders_ && std::isfinite(orders_.line_m)) {
        const double length_m = flight_->line().length_m();
        const double most_m = kReel_m_per_s * dt_s;
        flight_->set_line_length_m(length_m +
                                   std::clamp(orders_.line_m - length_m, -most_m, most_m));
    }
}

void KiteLoop::publish(double now_s) noexcept {
    frame_.stamp_s = now_s;
    frame_.report = flight_->report();
    const auto nodes_W = flight_->line().nodes_W();
    frame_.n_nodes = static_cast<std::int32_t>(nodes_W.size());
    std::copy(nodes_W.begin(), nodes_W.end(), frame_.line_W.begin());
    channels_.frame.publish(frame_);
    LineState line = make_line_state(flight_->line(), hand_W_, now_s);
    line.n_launches = n_launches_;
    channels_.line.publish(line);
}

void KiteLoop::silence(double now_s) noexcept {
    LineState slack;
    slack.stamp_s = now_s;
    slack.hand_W = hand_W_;
    slack.n_launches = n_launches_;
    channels_.line.publish(slack);
}

}  // namespace fulcrum
