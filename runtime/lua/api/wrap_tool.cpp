// What a lesson can look up of what a hand holds.
#include "haptics/math/rotation.h"
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"

namespace fulcrum::runtime {
namespace {

// The hand that holds this tool.
HandFrame frame_of(const LessonContext& context, std::int32_t tool) {
    const LessonFrame& frame = context.frame;
    const auto i = static_cast<std::size_t>(tool);
    return i > 0 && i <= frame.more_hands.size()
               ? frame.more_hands[i - 1]
               : HandFrame{frame.tool_pose_W, frame.tool_twist_W, frame.applied_W, frame.buttons};
}

template <int kAxis>
int get_tool_position(lua_State* lua, LessonContext& context, std::int32_t index) {
    lua_pushnumber(lua, frame_of(context, index).tool_pose_W.position[kAxis]);
    return 1;
}

template <int kAxis>
int get_tool_velocity(lua_State* lua, LessonContext& context, std::int32_t index) {
    lua_pushnumber(lua, frame_of(context, index).tool_twist_W.linear[kAxis]);
    return 1;
}

int get_tool_place(lua_State* lua, LessonContext& context, std::int32_t index) {
    push_vector(lua, frame_of(context, index).tool_pose_W.position);
    return 1;
}

int get_tool_force(lua_State* lua, LessonContext& context, std::int32_t index) {
    lua_pushnumber(lua, frame_of(context, index).applied_W.force.norm());
    return 1;
}

int get_tool_pressed(lua_State* lua, LessonContext& context, std::int32_t index) {
    lua_pushboolean(lua, (frame_of(context, index).buttons & 1U) != 0);
    return 1;
}

int get_tool_torque(lua_State* lua, LessonContext& context, std::int32_t index) {
    lua_pushnumber(lua, frame_of(context, index).applied_W.torque.norm());
    return 1;
}

int get_tool_turn(lua_State* lua, LessonContext& context, std::int32_t index) {
    push_vector(lua, kDegrees * compute_log(frame_of(context, index).tool_pose_W.orientation));
    return 1;
}

}  // namespace

void add_tool_api(ApiTable& table) {
    table.properties.push_back(
        {"tool", "x", "number", "metres", "to the right", &get_tool_position<0>});
    table.properties.push_back({"tool", "y", "number", "metres", "up", &get_tool_position<1>});
    table.properties.push_back(
        {"tool", "z", "number", "metres", "towards the viewer", &get_tool_position<2>});
    table.properties.push_back(
        {"tool", "vx", "number", "metres per second", "", &get_tool_velocity<0>});
    table.properties.push_back(
        {"tool", "vy", "number", "metres per second", "", &get_tool_velocity<1>});
    table.properties.push_back(
        {"tool", "vz", "number", "metres per second", "", &get_tool_velocity<2>});
    table.properties.push_back(
        {"tool", "position", "Vector", "metres", "{x, y, z}", &get_tool_place});
    table.properties.push_back({"tool", "force", "number", "newtons",
                                "how strongly the hand is pushed or pulled", &get_tool_force});
    table.properties.push_back(
        {"tool", "turn", "Vector", "degrees",
         "how the hand is turned, not what it presses against a body: about this direction, by as "
         "much as it is long",
         &get_tool_turn});
    table.properties.push_back({"tool", "pressed", "boolean", "",
                                "its first button is held, the mouse's or Shift where keys move it",
                                &get_tool_pressed});
    table.properties.push_back({"tool", "torque", "number", "newton metres",
                                "how strongly the hand is turned, with a tool in it; at most 0.3",
                                &get_tool_torque});
}

}  // namespace fulcrum::runtime
