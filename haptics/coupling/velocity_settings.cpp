// The load-path half of velocity_estimator.h.
#include "haptics/coupling/velocity_estimator.h"

#include <sstream>

namespace fulcrum {

Expected<void> validate(const VelocitySettings& settings) {
    std::ostringstream message;
    if (!(settings.cutoff_Hz >= 1.0 && settings.cutoff_Hz <= 1000.0)) {
        message << "the velocity estimator's cut-off is " << settings.cutoff_Hz
                << " Hz, outside the range 1 to 1000";
        return fail(message.str(), {}, "set it within that range");
    }
    if (!(settings.noise_bound_m >= 1e-9 && settings.noise_bound_m <= 0.1)) {
        message << "the velocity estimator's noise bound is " << settings.noise_bound_m
                << " m, outside the range 1e-9 to 0.1";
        return fail(message.str(), {}, "set it to the device's resolution");
    }
    return {};
}

}  // namespace fulcrum
