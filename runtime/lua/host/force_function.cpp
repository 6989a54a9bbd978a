#include "haptics/math/length.h"
#include "runtime/lua/host/lesson_host.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::runtime {
namespace {

constexpr int kMostNumbers = 6;  // newtons, then newton metres

/// The number at stack index `index`, the lesson's `which`th.
double number_at(lua_State* lua, int index, int which) {
    const double value = lua_tonumber(lua, index);
    if (lua_type(lua, index) != LUA_TNUMBER || !std::isfinite(value)) {
        raise_in_lesson(
            lua,
            "the force function gives three finite numbers, in newtons, or six, the last three in "
            "newton metres; number " +
                std::to_string(which) + " is " +
                (lua_type(lua, index) == LUA_TNUMBER ? "infinite or undefined"
                                                     : luaL_typename(lua, index)));
    }
    return value;
}

/// The lesson's force and torque with the tool as the context has it now.
Wrench evaluate(lua_State* lua, int function_ref) {
    const int top = lua_gettop(lua);
    lua_rawgeti(lua, LUA_REGISTRYINDEX, function_ref);
    push_handle(lua, Handle::Kind::tool, 0);
    // One more is asked for than there may be; what is not given is nil.
    ScriptState::of(lua).call(lua, 1, kMostNumbers + 1);
    if (!lua_isnil(lua, top + kMostNumbers + 1)) {
        raise_in_lesson(lua, "the force function gives three numbers or six; it gave more");
    }
    bool has_torque = false;
    for (int i = 4; i <= kMostNumbers; ++i) {
        has_torque = has_torque || !lua_isnil(lua, top + i);
    }
    Wrench wrench;
    for (int i = 0; i < 3; ++i) {
        wrench.force[i] = number_at(lua, top + 1 + i, 1 + i);
    }
    for (int i = 0; has_torque && i < 3; ++i) {
        wrench.torque[i] = number_at(lua, top + 4 + i, 4 + i);
    }
    lua_settop(lua, top);
    return wrench;
}

/// Column `axis` of the slopes of force and torque: what moves is one component of `moved`.
Wrench slope(lua_State* lua, int function_ref, double& moved, double step) {
    const double at = moved;
    moved = at + step;
    const Wrench ahead = evaluate(lua, function_ref);
    moved = at - step;
    const Wrench behind = evaluate(lua, function_ref);
    moved = at;
    return {(ahead.force - behind.force) / (2.0 * step),
            (ahead.torque - behind.torque) / (2.0 * step)};
}

Vector3 limited(const Vector3& column, double limit) {
    return column.cwiseMax(-limit).cwiseMin(limit);
}

/// A longer vector keeps its direction; no number of it is beyond the limit, as rounding might have it.
Vector3 shortened(const Vector3& v, double limit) {
    return limited(limit_length(v, limit), limit);
}

}  // namespace

LinearisedWrench linearise_force(lua_State* lua, LessonContext& context, int function_ref) {
    Vector3& position = context.frame.tool_pose_W.position;
    Vector3& velocity = context.frame.tool_twist_W.linear;
    LinearisedWrench result;
    result.stamp_s = context.frame.time_s;
    result.at_position_W = position;
    result.at_velocity_W = velocity;
    const Wrench here = evaluate(lua, function_ref);
    result.force_W = shortened(here.force, kMaxLessonForce_N);
    result.torque_W = shortened(here.torque, kMaxLessonTorque_Nm);
    for (int axis = 0; axis < 3; ++axis) {
        const Wrench moved = slope(lua, function_ref, position[axis], kForceStep_m);
        result.stiffness_N_per_m.col(axis) = limited(moved.force, kMaxLessonStiffness_N_per_m);
        result.torque_stiffness_Nm_per_m.col(axis) =
            limited(moved.torque, kMaxLessonTorqueStiffness_Nm_per_m);
        const Wrench sped = slope(lua, function_ref, velocity[axis], kForceStep_m_per_s);
        result.damping_Ns_per_m.col(axis) = limited(sped.force, kMaxLessonDamping_Ns_per_m);
    }
    return result;
}

}  // namespace fulcrum::runtime
