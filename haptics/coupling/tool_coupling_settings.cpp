// The load-path half of tool_coupling.h.
#include "haptics/base/range.h"
#include "haptics/coupling/tool_coupling.h"
#include "haptics/coupling/virtual_coupling.h"

#include <array>
#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

Expected<void> validate_turn(const TurnCouplingSettings& turn) {
    const std::array<Range, 4> ranges{
        {{"stiffness_Nm_per_rad", turn.stiffness_Nm_per_rad, 0.0, 1.0e3},
         {"damping_Nms_per_rad.x", turn.damping_Nms_per_rad.x(), 0.0, 100.0},
         {"damping_Nms_per_rad.y", turn.damping_Nms_per_rad.y(), 0.0, 100.0},
         {"damping_Nms_per_rad.z", turn.damping_Nms_per_rad.z(), 0.0, 100.0}}};
    if (auto checked = check_ranges("the coupling's turn:", ranges); !checked) {
        return checked;
    }
    if (turn.linear_range_rad == 0.0 && turn.saturation_range_rad == 0.0 &&
        turn.saturation_torque_Nm == 0.0) {
        return {};
    }
    const double width_rad = turn.saturation_range_rad - turn.linear_range_rad;
    const double rise_Nm =
        turn.saturation_torque_Nm - turn.stiffness_Nm_per_rad * turn.linear_range_rad;
    if (!(turn.linear_range_rad >= 0.0) || !(width_rad > 0.0) || !std::isfinite(width_rad)) {
        return fail("the coupling's saturation range of turn does not lie above its linear range",
                    {}, "give 0 <= linear_range_rad < saturation_range_rad");
    }
    if (!(kSteepestStart * rise_Nm >= turn.stiffness_Nm_per_rad * width_rad) ||
        !std::isfinite(rise_Nm)) {
        return fail("the coupling's torque would fall before it saturates", {},
                    "raise saturation_torque_Nm or narrow the range of the blend");
    }
    return {};
}

}  // namespace

Expected<void> validate(const ToolCouplingSettings& settings) {
    if (auto checked = validate(settings.shift); !checked) {
        return checked;
    }
    if (auto checked = validate_turn(settings.turn); !checked) {
        return checked;
    }
    const std::array<Range, 2> ranges{{{"clamp_m", settings.clamp_m, 0.0, 1.0},
                                       {"clamp_rad", settings.clamp_rad, 0.0, std::numbers::pi}}};
    if (auto checked = check_ranges("the coupling's", ranges); !checked) {
        return checked;
    }
    if (settings.clamp_m > 0.0 && settings.shift.saturation_range_m > 0.0) {
        return fail("the coupling has a clamp and a saturating spring", {},
                    "keep one of clamp_m and saturation_range_m");
    }
    if (settings.clamp_rad > 0.0 && settings.turn.saturation_range_rad > 0.0) {
        return fail("the coupling's turn has a clamp and a saturating spring", {},
                    "keep one of clamp_rad and saturation_range_rad");
    }
    return {};
}

}  // namespace fulcrum
