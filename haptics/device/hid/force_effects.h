// Forces on a force-feedback joystick: one constant force for each axis that it has, in a fixed direction, whose signed magnitude
// follows what is to be felt. So no force ever turns, and each order is one small report.
//
//   begin   reset, actuators on, device gain; for each axis: create, block load, set effect, magnitude 0, start
//   set     magnitude = -F / F_full, of the effect that comes from the right (bearing 90 degrees) and from ahead (0 degrees);
//           only where the number that the device takes has changed
//   renew   start again, well before an effect's duration is over: it is short, so that a force whose program has died ends by itself
//   end     magnitudes 0, stop each, stop all, free
// An effect's direction says where its force comes from. The device answers `create` in Block Load, and may take a while.
//
// Thread: one that may be held up. Cost: a transfer each, up to the device's polling interval.
// Source: PID 1.0, 4.2.1 to 4.12 (effects are created, loaded, set, operated), 5.3 (Direction: polar, clockwise from straight ahead).
#pragma once

#include "haptics/base/error.h"
#include "haptics/device/hid/force_layout.h"
#include "haptics/device/hid/hid_link.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace fulcrum::hid {

struct ForceEffectSettings {
    double device_gain = 1.0;  ///< of what the motors have, 0.05 to 1
    double duration_s = 0.2;   ///< how long a force outlives its program, 0.1 to 1
    double load_pause_s =
        0.005;  ///< between two questions where the device put an effect, 0 to 0.1
};

/// Refuses settings outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const ForceEffectSettings& settings);

class ForceEffects {
  public:
    /// Takes settings that `validate` accepted. `descriptor` is that of `layout`.
    ForceEffects(const ReportDescriptor& descriptor, const ForceLayout& layout,
                 const ForceEffectSettings& settings);

    /// Makes the effects and starts them with no force. Says which step the device refused; what it had made is ended.
    [[nodiscard]] Expected<void> begin(HidLink& link);
    /// Shares of the full force to the right and away from the user, each held to -1 to 1, NaN is 0. False when a report was not taken.
    [[nodiscard]] bool set(HidLink& link, double x, double y);
    /// Lets the effects go on for another duration.
    [[nodiscard]] bool renew(HidLink& link);
    /// Nothing is felt any more, as far as the device still listens.
    void end(HidLink& link) noexcept;

    /// How often `renew` is due.
    [[nodiscard]] double renew_every_s() const noexcept { return settings_.duration_s / 3.0; }

  private:
    struct Effect {
        bool along_x = false;
        std::int64_t index = 0;
        std::optional<std::int64_t> magnitude;  // as the device was told last
    };

    [[nodiscard]] std::vector<std::uint8_t> start_report(const ReportField& field) const;
    void put(std::vector<std::uint8_t>& report, const ReportField& field,
             std::int64_t value) const noexcept;
    [[nodiscard]] static bool send(HidLink& link, ReportType type,
                                   const std::vector<std::uint8_t>& report);
    [[nodiscard]] bool order(HidLink& link, const ForceOrder& what) const;
    [[nodiscard]] bool operate(HidLink& link, const Effect& effect, const ForceOrder& what) const;
    [[nodiscard]] bool set_magnitude(HidLink& link, Effect& effect, double share);

    [[nodiscard]] Expected<void> make(HidLink& link, bool along_x);
    [[nodiscard]] Expected<std::int64_t> load(HidLink& link) const;
    [[nodiscard]] bool describe(HidLink& link, const Effect& effect) const;

    const ReportDescriptor& descriptor_;
    ForceLayout layout_;
    ForceEffectSettings settings_;
    std::vector<Effect> effects_;  // that the device has now
};

}  // namespace fulcrum::hid
