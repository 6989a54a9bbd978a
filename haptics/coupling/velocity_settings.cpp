// The load-path half of velocity_estimator.h.
#include "haptics/base/range.h"
#include "haptics/coupling/velocity_estimator.h"

#include <array>
#include <cstddef>

namespace fulcrum {

std::string_view name_of(VelocityMethod method) noexcept {
    constexpr std::array<std::string_view, 4> kNames{"filtered_difference", "adaptive_window",
                                                     "finite_difference", "kalman"};
    return kNames[static_cast<std::size_t>(method)];
}

Expected<void> validate(const VelocitySettings& settings) {
    const Range ranges[] = {
        {"cut-off in hertz", settings.cutoff_Hz, 1.0, 1000.0},
        {"noise bound in metres", settings.noise_bound_m, 1e-9, 0.1},
        {"longest window in seconds", settings.longest_window_s, 0.0002, kLongestWindow_s},
        {"acceleration density in m^2/s^3", settings.acceleration_density, 1e-12, 1e6},
    };
    return check_ranges("the velocity estimator's", ranges);
}

}  // namespace fulcrum
