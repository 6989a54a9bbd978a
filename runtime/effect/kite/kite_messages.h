// What a lesson and a kite that flies say to each other.
#pragma once

#include "haptics/flight/kite.h"
#include "haptics/math/spatial.h"

#include <optional>

namespace fulcrum::runtime {

/// How the kite flies: newtons, world frame (haptics/flight/kite_flight.h).
struct KiteState {
    Vector3 centre_W{Vector3::Zero()};
    Vector3 velocity_W{Vector3::Zero()};
    Vector3 weight_W{Vector3::Zero()};
    Vector3 lift_W{Vector3::Zero()};
    Vector3 drag_W{Vector3::Zero()};
    Vector3 tension_W{Vector3::Zero()};
    Vector3 hand_force_W{Vector3::Zero()};
    Vector3 wind_W{Vector3::Zero()};  ///< at the kite
    double angle_of_attack_rad = 0.0;
    double line_m = 0.0;
    bool is_snapped = false;
};

/// Sets what is given of the kite. In this order: another design, which is launched; a launch; line; cut.
struct KiteCommand {
    std::optional<KiteSettings> design;
    std::optional<double> launch_elevation_rad;
    std::optional<double> line_m;
    bool cut = false;
    std::optional<bool> shows_forces;
};
/// Sets the wind's mean at 10 metres.
struct WindCommand {
    double speed_m_per_s = 0.0;
};
/// What of it is to be seen beside how it flies.
struct KiteSeen {
    std::optional<KiteSettings> design{};  ///< of the one that flies now, where one does
    bool shows_forces = false;
};

}  // namespace fulcrum::runtime
