#include "runtime/lua/lesson_host.h"

#include <algorithm>

#include <cmath>

namespace fulcrum::runtime {
namespace {

/// The lesson's force with the tool as the context has it now.
Vector3 evaluate(lua_State* lua, int function_ref) {
    lua_rawgeti(lua, LUA_REGISTRYINDEX, function_ref);
    push_handle(lua, Handle::Kind::tool, 0);
    ScriptState::of(lua).call(lua, 1, 3);
    Vector3 force;
    for (int i = 0; i < 3; ++i) {
        const double component = lua_tonumber(lua, i - 3);
        if (lua_type(lua, i - 3) != LUA_TNUMBER || !std::isfinite(component)) {
            raise_in_lesson(lua,
                            "the force function gives three finite numbers, in newtons; number " +
                                std::to_string(i + 1) + " is " +
                                (lua_type(lua, i - 3) == LUA_TNUMBER ? "infinite or undefined"
                                                                     : luaL_typename(lua, i - 3)));
        }
        force[i] = component;
    }
    lua_pop(lua, 3);
    return force;
}

/// Column `axis` of the slope: what moves is one component of `moved`.
Vector3 slope(lua_State* lua, int function_ref, double& moved, double step, double limit) {
    const double at = moved;
    moved = at + step;
    const Vector3 ahead = evaluate(lua, function_ref);
    moved = at - step;
    const Vector3 behind = evaluate(lua, function_ref);
    moved = at;
    return ((ahead - behind) / (2.0 * step)).cwiseMax(-limit).cwiseMin(limit);
}

}  // namespace

LinearisedWrench linearise_force(lua_State* lua, LessonContext& context, int function_ref) {
    Vector3& position = context.frame.tool_pose_W.position;
    Vector3& velocity = context.frame.tool_twist_W.linear;
    LinearisedWrench result;
    result.stamp_s = context.frame.time_s;
    result.at_position_W = position;
    result.at_velocity_W = velocity;
    result.force_W = evaluate(lua, function_ref);
    // A longer vector keeps its direction.
    if (const double length = result.force_W.norm(); length > kMaxLessonForce_N) {
        result.force_W *= kMaxLessonForce_N / length;
    }
    for (int axis = 0; axis < 3; ++axis) {
        result.stiffness_N_per_m.col(axis) =
            slope(lua, function_ref, position[axis], kForceStep_m, kMaxLessonStiffness_N_per_m);
        result.damping_Ns_per_m.col(axis) = slope(lua, function_ref, velocity[axis],
                                                  kForceStep_m_per_s, kMaxLessonDamping_Ns_per_m);
    }
    return result;
}

}  // namespace fulcrum::runtime
