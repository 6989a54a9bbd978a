// The load path of wind.h.
#include "haptics/base/range.h"
#include "haptics/flight/wind.h"

#include <cmath>

namespace fulcrum {

Expected<void> validate(const WindSettings& settings) {
    constexpr double kRounding = 1.0e-9;
    const Range ranges[] = {
        {"speed in metres per second", settings.speed_m_per_s, 0.0, kFastestWind_m_per_s},
        {"direction's length", settings.downwind_W.norm(), 1.0 - kRounding, 1.0 + kRounding},
        {"direction's rise", settings.downwind_W.y(), -kRounding, kRounding},
        {"roughness of the ground in metres", settings.roughness_m, 1.0e-5, 5.0},
        {"gustiness", settings.gustiness, 0.0, 4.0},
        {"ground height in metres", settings.ground_m, -1000.0, 1000.0},
    };
    return check_ranges("a wind's", ranges);
}

}  // namespace fulcrum
