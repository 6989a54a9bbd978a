// A kite in the wind on a line that a hand holds: all of it, one step at a time.
//
//   gusts -> line's first half -> kite: air, weight, line, ground -> line's second half -> does it snap? -> what the hand feels
// Kite and line move in one implicit step (line.h): backward Euler by Newton for the kite (integrator.h), linearised once for the
// line: stable in any wind in steps of 2 ms on lines of 10 N to 1 MN of stretch, in steps of 50 ms on lines up to 500 N. The kite's corners push off the ground as springs (loads.h) that hold it up and nothing
// sideways.
//
// Thread: that of the step. Cost: 10 us with 16 segments (`fulcrum bench kite`). No allocation after construction.
// Source: the parts' headers.
#pragma once

#include "haptics/base/error.h"
#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/loads.h"
#include "haptics/flight/kite.h"
#include "haptics/flight/line.h"
#include "haptics/flight/wind.h"

#include <cstdint>
#include <vector>

namespace fulcrum {

/// Fixed at load.
struct KiteFlightSettings {
    KiteSettings kite{};
    LineSettings line{};
    WindSettings wind{};
    double gravity_m_per_s2 = 9.81;  ///< downwards, 0 to 100
    double ground_N_per_m = 300.0;   ///< under each corner, 10 to 1e4
    int steps_a_gust = 1;            ///< gusts change once in so many steps, 1 to 100
};

/// How a flight stands after a step. World frame, newtons.
struct KiteReport {
    Pose pose_W{};                      ///< of the design frame K (kite.h)
    Vector3 centre_W{Vector3::Zero()};  ///< of mass: where the weight acts
    Vector3 pressure_W{
        Vector3::
            Zero()};  ///< centre of pressure: where the air's push acts, on a line along the spine
    Vector3 knot_W{Vector3::Zero()};
    Vector3 weight_W{Vector3::Zero()};
    Vector3 lift_W{Vector3::Zero()};        ///< the air's force across its stream ...
    Vector3 drag_W{Vector3::Zero()};        ///< ... and along it
    Vector3 tension_W{Vector3::Zero()};     ///< of the line on the kite
    Vector3 hand_force_W{Vector3::Zero()};  ///< of the line on the hand
    Vector3 wind_W{Vector3::Zero()};        ///< at the kite, m/s
    Vector3 velocity_W{Vector3::Zero()};    ///< of the centre of mass, m/s
    double air_way_m = 0.0;                 ///< how far the mean wind at 10 metres has gone by
    double angle_of_attack_rad = 0.0;       ///< between stream and spine, 0 to pi
    double line_m = 0.0;                    ///< unstretched
    bool is_snapped = false;
    std::uint32_t n_failed = 0;  ///< steps that could not be made; the kite stood still in them
};

/// Refuses what a part's `validate` refuses, and numbers outside the ranges above.
[[nodiscard]] Expected<void> validate(const KiteFlightSettings& settings);

class KiteFlight {
  public:
    /// Takes settings that `validate` accepted. The kite stands at the end of its line, up the wind's slope by 40 degrees.
    explicit KiteFlight(const KiteFlightSettings& settings);

    /// Begins anew: the hand there, the kite at the end of a straight line that rises by `elevation_rad` downwind, at rest,
    /// its spine leaning into the wind by `lean_rad` from the upright. Gusts go on. Numbers that are none launch nothing.
    void launch(const Vector3& hand_W, double elevation_rad, double lean_rad) noexcept;
    /// Moves all on by `dt_s` with the hand there now. A dt that is not above 0 and finite, or a hand that is nowhere, moves nothing.
    void step(double dt_s, const Vector3& hand_W) noexcept;
    /// Lets line out or takes it in.
    void set_line_length_m(double length_m) noexcept { line_.set_length_m(length_m); }
    /// The wind's mean at 10 metres, kept within its range.
    void set_wind_speed_m_per_s(double speed_m_per_s) noexcept;
    void snap_line() noexcept { line_.snap(); }

    [[nodiscard]] const KiteReport& report() const noexcept { return report_; }
    [[nodiscard]] const RigidState& state() const noexcept { return state_; }
    [[nodiscard]] const Kite& kite() const noexcept { return kite_; }
    [[nodiscard]] const KiteLine& line() const noexcept { return line_; }

  private:
    void move_kite(double dt_s, const LinePull& pull, const Vector3& wind_W) noexcept;
    void describe(const Vector3& wind_W) noexcept;

    KiteFlightSettings settings_;
    Kite kite_;
    KiteLine line_;
    IntegratorSettings integrator_{};
    std::vector<PlaneContact> corners_;
    GustState gusts_{};
    int n_steps_ = 0;  // since the gusts changed
    RigidState state_{};
    KiteReport report_{};
};

}  // namespace fulcrum
