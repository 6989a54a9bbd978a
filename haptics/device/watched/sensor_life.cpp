#include "haptics/base/range.h"
#include "haptics/device/watched/sensor_guard.h"

namespace fulcrum {

Expected<void> validate(const SensorLife& s) {
    const Range ranges[] = {
        {"trembles_within_s", s.trembles_within_s, 0.0, 1.0},
        {"moves_at_N", s.moves_at_N, 0.0, 10.0},
        {"most_m_per_s2", s.most_m_per_s2, 0.0, 1.0e4},
    };
    return check_ranges("the arm's sensor setting", ranges);
}

}  // namespace fulcrum
