#include "haptics/surface/transient_settings.h"

#include "haptics/base/range.h"

namespace fulcrum {

Expected<void> validate(const TransientSettings& settings) {
    const Range ranges[] = {
        {"force for each m/s in Ns/m", settings.force_Ns_per_m, 0.0, 100.0},
        {"acceleration for each m/s in 1/s", settings.acceleration_per_s, 0.0, 1.0e4},
        {"frequency in hertz", settings.frequency_Hz, 5.0, 1000.0},
        {"decay in 1/s", settings.decay_per_s, 5.0, 2000.0},
        {"pulse in seconds", settings.pulse_s, 0.001, 0.1},
        {"largest force in newtons", settings.max_force_N, 0.1, 10.0},
        {"share of the energy", settings.energy_share, 0.0, 1.0},
    };
    return check_ranges("the tap's", ranges);
}

}  // namespace fulcrum
