// A body on a hinge: how a lesson turns it, and reads how it stands.
#include "runtime/effect/hinge/declare_hinge.h"
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"
#include "runtime/lua/wire/wire_limits.h"

#include <string>

namespace fulcrum::runtime {
namespace {

const AxleSettings& hinge_of(lua_State* lua, const LessonContext& context, std::int32_t index,
                             const char* asked) {
    const BodyDescription& body = context.description.bodies[static_cast<std::size_t>(index)];
    if (!body.hinge) {
        raise_in_lesson(lua, std::string("only a body on a hinge has ") + asked + "; declare " +
                                 body.name + " with hinge = { axis = …, inertia = … }");
    }
    return *body.hinge;
}

/// How its hinge stands now; at rest before the first frame.
HingeState hinge_state_of(const LessonContext& context, std::int32_t index) {
    std::size_t before = 0;
    for (std::int32_t i = 0; i < index; ++i) {
        before += context.description.bodies[static_cast<std::size_t>(i)].hinge ? 1U : 0U;
    }
    return before < context.frame.hinges.size() ? context.frame.hinges[before] : HingeState{};
}

int turn(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    TurnCommand command;
    command.body = to_handle(lua, 1)->index;
    (void)hinge_of(lua, context, command.body, "a turn");
    if (arguments["angle"].given) {
        command.angle_rad = arguments["angle"].number / kDegrees;
    }
    if (arguments["spin"].given) {
        command.spin_rad_per_s = arguments["spin"].number / kDegrees;
    }
    if (arguments["at"].given) {
        command.pivot_W = arguments["at"].vector;
        (void)place_on_hinge(lua,
                             context.description.bodies[static_cast<std::size_t>(command.body)],
                             "hinge", *command.pivot_W);
    }
    if (arguments["load"].given) {
        command.load_N = arguments["load"].number;
    }
    add_command(lua, command);
    return 0;
}

/// A number of how a hinge stands, in the unit that lessons see.
struct HingeNumber {
    const char* asked;
    double HingeState::*value;
    double unit;
};
constexpr HingeNumber kAngle{"an angle", &HingeState::angle_rad, kDegrees};
constexpr HingeNumber kSpin{"a spin", &HingeState::spin_rad_per_s, kDegrees};
constexpr HingeNumber kTorque{"a torque", &HingeState::torque_Nm, 1.0};
constexpr HingeNumber kLoadTorque{"a load", &HingeState::load_torque_Nm, 1.0};
constexpr HingeNumber kArm{"a lever arm", &HingeState::arm_m, 1.0};

template <const HingeNumber& kNumber>
int get_of_hinge(lua_State* lua, LessonContext& context, std::int32_t index) {
    (void)hinge_of(lua, context, index, kNumber.asked);
    lua_pushnumber(lua, hinge_state_of(context, index).*kNumber.value * kNumber.unit);
    return 1;
}
int get_inertia(lua_State* lua, LessonContext& context, std::int32_t index) {
    const AxleSettings& declared = hinge_of(lua, context, index, "an inertia");
    const double now_kg_m2 = hinge_state_of(context, index).inertia_kg_m2;
    lua_pushnumber(lua, now_kg_m2 > 0.0 ? now_kg_m2 : declared.inertia_kg_m2);
    return 1;
}

}  // namespace

void add_hinge_api(ApiTable& table) {
    using enum ParameterType;
    table.functions.push_back(
        {"body",
         "turn",
         CallShape::record,
         CallTime::acting,
         {{"angle", number, "degrees", -kMostTurn_deg, kMostTurn_deg, "nil", "it is there at once"},
          {"spin", number, "degrees per second", -5000, 5000, "nil",
           "it turns so fast from now on, until something brakes it"},
          {"at", vector, "metres", -kMaxCoordinate_m, kMaxCoordinate_m, "nil",
           "a place that its axis passes through from now on, for a body where it was declared; at "
           "most 100 m from there"},
          {"load", number, "newtons", 0, kMostAxleLoad_N, "nil",
           "the weight that hangs on it from now on"}},
         "",
         "Sets how a body on a hinge stands. When its axis points at you, angles grow "
         "counter-clockwise; they stay between its lowest and highest.",
         &turn});
    table.properties.push_back({"body", "angle", "number", "degrees",
                                "of a body on a hinge: how far it is turned",
                                &get_of_hinge<kAngle>});
    table.properties.push_back({"body", "spin", "number", "degrees per second",
                                "of a body on a hinge", &get_of_hinge<kSpin>});
    table.properties.push_back({"body", "inertia", "number", "kilogram square metres",
                                "of a body on a hinge, about its axis where that lies now",
                                &get_inertia});
    table.properties.push_back(
        {"body", "torque", "number", "newton metres",
         "of the hand about a hinge: lever arm × force, counter-clockwise above 0",
         &get_of_hinge<kTorque>});
    table.properties.push_back(
        {"body", "arm", "number", "metres",
         "how far the hand's force passes from the hinge; 0 when nothing presses",
         &get_of_hinge<kArm>});
    table.properties.push_back({"body", "load_torque", "number", "newton metres",
                                "of what hangs on a body about its hinge",
                                &get_of_hinge<kLoadTorque>});
}

}  // namespace fulcrum::runtime
