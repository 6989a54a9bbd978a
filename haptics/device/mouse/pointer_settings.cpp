// The load-path half of pointer_device.h.
#include "haptics/base/range.h"
#include "haptics/device/mouse/pointer_device.h"

namespace fulcrum {

PointerSettings make_yielding(double times) {
    constexpr double kSag_m_per_N = 0.004;
    constexpr double kSlow_per_N = 0.2;
    PointerSettings settings;
    settings.sag_m_per_N = times * kSag_m_per_N;
    settings.slow_per_N = times * kSlow_per_N;
    return settings;
}

Expected<void> validate(const PointerSettings& s) {
    const Range ranges[] = {
        {"natural_rad_per_s", s.natural_rad_per_s, 5.0, 500.0},
        {"max_speed_m_per_s", s.max_speed_m_per_s, 0.1, 100.0},
        {"sag_m_per_N", s.sag_m_per_N, 0.0, 0.05},
        {"slow_per_N", s.slow_per_N, 0.0, 2.0},
        {"half_extent_D.x", s.half_extent_D.x(), 0.001, 10.0},
        {"half_extent_D.y", s.half_extent_D.y(), 0.001, 10.0},
        {"half_extent_D.z", s.half_extent_D.z(), 0.001, 10.0},
    };
    return check_ranges("the pointer's", ranges);
}

PointerDevice::PointerDevice(const PointerSettings& settings, LatestValue<PointerTarget>& target)
    : settings_(settings), target_(target) {
    traits_.name = "mouse";
    traits_.renders_force = false;
}

PointerDevice::~PointerDevice() = default;

}  // namespace fulcrum
