#include "runtime/effect/tool/tool_springs.h"

#include "haptics/coupling/tool_coupling.h"
#include "haptics/coupling/virtual_coupling.h"
#include "runtime/text/amounts.h"

#include <array>
#include <cstdio>
#include <string>

namespace fulcrum::runtime {
namespace {

constexpr double kLongestStretch_m = 1.0;  // of the spring, before the hand feels all that it may
constexpr double kFarthestGrip_m = 10.0;
constexpr const char* kNearerScale = "world:hand a scale nearer to 1";

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return text.data();
}

}  // namespace

Expected<void> check_tool_springs(const HandDescription& hand, const ToolOrder& order,
                                  double reach_m) {
    const ToolDescription& tool = *hand.tool;
    const std::string where = at_line(hand.line);
    const ToolCouplingSettings& coupling = order.settings.coupling;
    const std::string spring = "the tool's stiffness of " + number(tool.stiffness_N_per_m) +
                               " N/m in a hand at scale " + number(hand.scale);
    if (!validate(coupling.shift)) {
        return fail(spring + " is too stiff", where,
                    std::string("give it less stiffness, or ") + kNearerScale);
    }
    if (coupling.shift.stiffness_N_per_m * kLongestStretch_m < order.most_force_N) {
        return fail(spring + " is too soft: it would be pulled " +
                        metres_text(order.most_force_N / coupling.shift.stiffness_N_per_m) +
                        " before it is felt",
                    where, std::string("give it more stiffness, or ") + kNearerScale);
    }
    if (!validate(ToolCouplingSettings{.turn = coupling.turn})) {
        return fail("the tool reaches " + metres_text(reach_m) +
                        " from its middle, and would be turned by a spring of " +
                        number(coupling.turn.stiffness_Nm_per_rad / hand.scale) + " Nm/rad",
                    where, "give it a turn_stiffness of at most 10, or make it smaller");
    }
    if (!(order.settings.grip_T.cwiseAbs().maxCoeff() <= kFarthestGrip_m)) {
        return fail("the middle of the tool's model lies " +
                        metres_text(order.settings.grip_T.norm()) +
                        " from the model's origin, where the hand holds it",
                    where, "move it there in the program that made it");
    }
    const ToolCouplingSettings damped = make_critically_damped(
        coupling, order.settings.inertia.mass_kg, order.settings.inertia.moments_kg_m2);
    if (!tool.massless && !validate(damped)) {
        return fail("a tool of " + number(tool.mass_kg) + " kg on a spring of " +
                        number(tool.stiffness_N_per_m) +
                        " N/m cannot be calmed in a hand at scale " + number(hand.scale),
                    where, std::string("give it less mass or stiffness, or ") + kNearerScale);
    }
    return {};
}

}  // namespace fulcrum::runtime
