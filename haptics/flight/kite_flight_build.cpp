// The load path of kite_flight.h.
#include "haptics/base/range.h"
#include "haptics/flight/kite_flight.h"

namespace fulcrum {

Expected<void> validate(const KiteFlightSettings& settings) {
    const Range ranges[] = {
        {"gravity in metres per second squared", settings.gravity_m_per_s2, 0.0, 100.0},
        {"ground's stiffness in newtons a metre", settings.ground_N_per_m, 10.0, 1.0e4},
        {"steps in which gusts change", static_cast<double>(settings.steps_a_gust), 1.0, 100.0},
    };
    for (auto checked : {validate(settings.kite), validate(settings.line), validate(settings.wind),
                         check_ranges("a kite's", ranges)}) {
        if (!checked) {
            return checked;
        }
    }
    return {};
}

KiteFlight::KiteFlight(const KiteFlightSettings& settings)
    : settings_(settings), kite_(make_kite(settings.kite)), line_(settings.line) {
    constexpr double kElevation_rad = 0.7;
    constexpr double kLean_rad = 1.1;
    corners_.reserve(kite_.corners_B.size());
    for (const Vector3& corner_B : kite_.corners_B) {
        corners_.push_back({.point_B = corner_B,
                            .plane_point_W = Vector3(0.0, settings.wind.ground_m, 0.0),
                            .normal_W = Vector3::UnitY(),
                            .stiffness_N_per_m = settings.ground_N_per_m,
                            .damping_Ns_per_m = 0.02 * settings.ground_N_per_m,
                            .damping_ramp_m = 0.02});
    }
    launch(Vector3(0.0, settings.wind.ground_m + 1.0, 0.0), kElevation_rad, kLean_rad);
}

}  // namespace fulcrum
