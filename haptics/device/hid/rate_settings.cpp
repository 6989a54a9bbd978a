// The load-path half of rate_control.h.
#include "haptics/base/range.h"
#include "haptics/device/hid/rate_control.h"

namespace fulcrum::hid {

Expected<void> validate(const RateSettings& s) {
    const Range ranges[] = {
        {"max_speed_m_per_s", s.max_speed_m_per_s, 0.01, 2.0},
        {"max_turn_rad_per_s", s.max_turn_rad_per_s, 0.0, 10.0},
        {"dead_zone", s.dead_zone, 0.0, 0.5},
        {"exponent", s.exponent, 1.0, 4.0},
        {"full_push_N", s.full_push_N, 0.5, 50.0},
        {"half_extent_m", s.half_extent_m, 0.001, 10.0},
    };
    return check_ranges("the rate control's", ranges);
}

}  // namespace fulcrum::hid
