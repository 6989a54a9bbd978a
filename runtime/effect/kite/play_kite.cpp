#include "runtime/effect/kite/play_kite.h"

#include "runtime/lesson/undeclared.h"

#include <algorithm>
#include <utility>

namespace fulcrum::runtime {

PlayedKite::PlayedKite(const LessonDescription& lesson) : lesson_(lesson) {
    if (lesson.kite) {
        orders_.elevation_rad = lesson.kite->elevation_rad;
        orders_.line_m = lesson.kite->flight.line.length_m;
        orders_.wind_m_per_s = lesson.wind.speed_m_per_s;
        seen_.design = lesson.kite->flight.kite;
    }
}

// The reel turns by the wheel, by the first button out and by the second one in.
void PlayedKite::take(const SessionInput& input, LessonFrame& frame) {
    if (!lesson_.kite) {
        return;
    }
    constexpr std::uint32_t kOut = 1U;
    constexpr std::uint32_t kIn = 2U;
    const double turning = ((input.hand.buttons & kOut) != 0 ? 1.0 : 0.0) -
                           ((input.hand.buttons & kIn) != 0 ? 1.0 : 0.0);
    orders_.line_m = std::clamp(
        orders_.line_m + kReelByNotch_m * input.wheel +
            kReelByButton_m_per_s * turning * input.dt_s,
        kShortestReel_m,
        std::min(kLongestReel_m, kLongestLineShare * lesson_.kite->flight.line.length_m));
    if (input.kite == nullptr) {
        return;
    }
    const KiteReport& report = input.kite->report;
    frame.kite = KiteState{report.centre_W,     report.velocity_W, report.weight_W,
                           report.lift_W,       report.drag_W,     report.tension_W,
                           report.hand_force_W, report.wind_W,     report.angle_of_attack_rad,
                           report.line_m,       report.is_snapped};
}

Expected<void> PlayedKite::carry_out(const KiteCommand& command) {
    if (!lesson_.kite) {
        return undeclared();
    }
    if (command.design) {
        if (auto fits = validate(*command.design); !fits) {
            return fits;
        }
        seen_.design = command.design;
        is_built_anew_ = true;
    }
    if (command.launch_elevation_rad) {
        orders_.elevation_rad = *command.launch_elevation_rad;
        ++orders_.n_launches;
    }
    orders_.line_m =
        std::clamp(command.line_m.value_or(orders_.line_m), kShortestReel_m, kLongestReel_m);
    orders_.n_cuts += command.cut ? 1U : 0U;
    seen_.shows_forces = command.shows_forces.value_or(seen_.shows_forces);
    return {};
}

Expected<void> PlayedKite::carry_out(const WindCommand& command) {
    if (!lesson_.kite) {
        return undeclared();
    }
    orders_.wind_m_per_s = command.speed_m_per_s;
    return {};
}

void PlayedKite::order(EffectOrders& orders) {
    orders.kite = orders_;
    if (std::exchange(is_built_anew_, false)) {
        orders.kite_design = seen_.design;
    }
}

}  // namespace fulcrum::runtime
