// The simulated hands of lesson_host.h, each a script of its own.
#include "haptics/math/length.h"
#include "haptics/math/rotation.h"
#include "runtime/lua/host/lesson_host.h"

#include <cmath>
#include <utility>

namespace fulcrum::runtime {
namespace {

/// A coordinate of the hand's target.
double check_target(lua_State* lua, int index) {
    const double value = lua_tonumber(lua, index);
    if (lua_type(lua, index) != LUA_TNUMBER || !(std::abs(value) <= kFarthestAim_m)) {
        raise_in_lesson(lua,
                        "a simulated hand gives x, y and z in metres, -10100 to 10100, and buttons "
                        "if it presses any");
    }
    return value;
}

/// How the hand's target is turned: degrees about a direction, by as much as it is long.
Quaternion check_turn(lua_State* lua, int index) {
    constexpr double kMostTurn_deg = 3600.0;
    Vector3 turn_deg = Vector3::Constant(std::nan(""));
    const int turn = lua_absindex(lua, index);
    for (int axis = 0; lua_istable(lua, turn) && axis < 3; ++axis) {
        if (lua_rawgeti(lua, turn, axis + 1) == LUA_TNUMBER) {
            turn_deg[axis] = lua_tonumber(lua, -1);
        }
        lua_pop(lua, 1);
    }
    if (!(compute_length(turn_deg) <= kMostTurn_deg)) {
        raise_in_lesson(lua,
                        "a simulated hand gives its turn as { x, y, z } in degrees, a direction "
                        "that it turns about "
                        "by as much as it is long, at most 3600");
    }
    return compute_exp(turn_deg / kDegrees);
}

/// The key that a simulated hand presses.
std::string check_key(lua_State* lua, int index) {
    const char* key = lua_type(lua, index) == LUA_TSTRING ? lua_tostring(lua, index) : "";
    if (!is_name(key)) {
        raise_in_lesson(lua,
                        "a simulated hand gives the name of a key, such as \"left\" or \"space\"");
    }
    return key;
}

}  // namespace

const LuaSource& source_of_hand(const LoadMessage& message, std::size_t index) {
    static_assert(kMostHands == 2);
    return index == 0 ? message.hand : message.second_hand;
}

std::optional<ScriptError> LessonHost::load_hand(std::size_t index) {
    SimulatedHand& hand = hands_[index];
    const LuaSource& source = source_of_hand(message_, index);
    ScriptState& script = *hand.script;
    hand.context.description = lesson_.description;
    hand.context.phase = LessonPhase::running;
    script.begin_budget(message_.load_instructions);
    return script.protect([&](lua_State* lua) {
        register_api(lua);
        script.load_text(lua, source);
        script.call(lua, 0, 1);
        if (!lua_isfunction(lua, -1) && !lua_istable(lua, -1)) {
            raise_at(lua, source.name, 1,
                     "a simulated hand ends with return function(hand, t, world) … end");
        }
        hand.ref = luaL_ref(lua, LUA_REGISTRYINDEX);
    });
}

std::optional<ScriptError> LessonHost::run_hand(std::size_t index, const LessonFrame& frame,
                                                LessonReply& reply) {
    LessonContext& context = hands_[index].context;
    context.frame = frame;
    context.felt_weight_N = lesson_.felt_weight_N;
    context.grades = lesson_.grades;
    context.n_prints = 0;
    hands_[index].script->begin_budget(message_.frame_instructions);
    auto error =
        hands_[index].script->protect([&](lua_State* lua) { call_hand(lua, index, reply); });
    const LessonReply prints = std::exchange(lesson_.reply, {});
    for (const LessonCommand& print : prints.commands) {  // the hand's join the lesson's
        if (reply.commands.size() < kMaxCommands) {
            reply.commands.push_back(print);
        }
    }
    return error;
}

void LessonHost::call_hand(lua_State* lua, std::size_t index, LessonReply& reply) {
    const SimulatedHand& hand = hands_[index];
    lua_rawgeti(lua, LUA_REGISTRYINDEX, hand.ref);
    int n_arguments = 3;
    if (lua_istable(lua, -1)) {
        lua_getfield(lua, -1, "update");
        lua_insert(lua, -2);
        ++n_arguments;
    }
    push_handle(lua, Handle::Kind::tool, static_cast<std::int32_t>(index));
    lua_pushnumber(lua, hand.context.frame.time_s);
    push_handle(lua, Handle::Kind::world, 0);
    hand.script->call(lua, n_arguments, 6);
    if (!lua_isnil(lua, -1)) {
        reply.hand_key = check_key(lua, -1);
    }
    lua_pop(lua, 1);
    if (lua_isnil(lua, -5)) {
        return;  // no target: the hand stays where it was
    }
    HandAim aim{.is_given = true};
    aim.target_W.position =
        Vector3(check_target(lua, -5), check_target(lua, -4), check_target(lua, -3));
    if (!lua_isnil(lua, -1)) {
        aim.target_W.orientation = check_turn(lua, -1);
    }
    if (lua_type(lua, -2) == LUA_TBOOLEAN) {
        aim.buttons = lua_toboolean(lua, -2) != 0 ? 1U : 0U;
    } else if (!lua_isnil(lua, -2)) {
        const double buttons = check_target(lua, -2);
        aim.buttons = buttons >= 0.0 ? static_cast<std::uint32_t>(buttons) : 0U;
    }
    if (index == 0) {
        reply.has_hand_target = true;
        reply.hand_target_W = aim.target_W;
        reply.hand_buttons = aim.buttons;
    } else {
        reply.more_aims.resize(index);
        reply.more_aims[index - 1] = aim;
    }
}

}  // namespace fulcrum::runtime
