// The hand: where it works, what it touches with, and the lesson's own force on it.
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"

namespace fulcrum::runtime {
namespace {

/// The cursor that world:hand { cursor = …, cursor_size = … } describes.
CursorShape cursor_of(const Arguments& arguments) {
    const std::string& shape = arguments["cursor"].text;
    const double size_m = arguments["cursor_size"].number;
    if (shape == "ball") {
        return SphereShape{size_m};
    }
    if (shape == "box") {
        return BoxShape{Vector3::Constant(size_m)};
    }
    if (shape == "capsule") {
        return CapsuleShape{size_m, size_m};
    }
    if (shape == "cylinder") {
        return CylinderShape{size_m, size_m};
    }
    return std::monostate{};
}

ProxyKind proxy_of(std::string_view name) {
    return name == "virtual_proxy"   ? ProxyKind::virtual_proxy
           : name == "friction_cone" ? ProxyKind::friction_cone
                                     : ProxyKind::god_object;
}

int set_hand(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    if (context.has_hand) {
        raise_in_lesson(lua,
                        "a lesson has one hand; this is the second world:hand { … }; keep what the "
                        "first one gives");
    }
    context.has_hand = true;
    context.description.hand.centre_W = arguments["centre"].vector;
    context.description.hand.scale = arguments["scale"].number;
    context.description.hand.rate_hz = arguments["rate"].number;
    context.description.hand.cursor = cursor_of(arguments);
    if (arguments["proxy"].given) {
        context.description.hand.proxy = proxy_of(arguments["proxy"].text);
    }
    context.description.hand.line = place_in_lesson(lua).line;
    push_handle(lua, Handle::Kind::hand, 0);
    return 1;
}

int set_force_function(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    if (context.force_function_ref != LUA_NOREF) {
        raise_in_lesson(lua, "a lesson has one force function; this is the second hand:force(…)");
    }
    lua_pushvalue(lua, arguments["function"].stack_index);
    context.force_function_ref = luaL_ref(lua, LUA_REGISTRYINDEX);
    context.description.hand.lesson_force = true;
    context.description.hand.force_line = place_in_lesson(lua).line;
    return 0;
}

}  // namespace

void add_hand_api(ApiTable& table) {
    using enum ParameterType;
    table.functions.push_back(
        {"world",
         "hand",
         CallShape::record,
         CallTime::declaring,
         {{"centre", vector, "metres", -10000, 10000, "{0, 0.3, 0}",
           "where the middle of the arm's reach lies"},
          {"scale", number, "", 0.01, 100, "1", "metres in the scene for one metre of the hand"},
          {"rate", number, "hertz", 1000, 5000, "1000", "how often forces are computed"},
          {"proxy", choice, "", 0, 0, "nil",
           "what solid bodies are touched with, by the name of its method; what the scene needs by "
           "default: friction_cone where something has friction",
           "god_object virtual_proxy friction_cone"},
          {"cursor", choice, "", 0, 0, "point",
           "the shape that touches; a ball is for virtual_proxy and friction_cone, the others for "
           "friction_cone alone",
           "point ball box capsule cylinder"},
          {"cursor_size", number, "metres", 0.0005, 1, "0.005",
           "its radius, or half its side; a capsule and a cylinder are so long to each side"}},
         "Hand",
         "Says where the hand works in the scene, once.",
         &set_hand});
    table.functions.push_back(
        {"hand",
         "force",
         CallShape::positional,
         CallTime::declaring,
         {{"function", function, "", 0, 0, kRequired,
           "function(tool): gives three newtons from tool.x, .y, .z, .vx, .vy, .vz; or six "
           "numbers, the last three a torque in newton metres"}},
         "",
         "Declares the lesson's own force on the hand, computed 60 times a second and carried on "
         "in between by its slope; a torque by its slope in place alone. It comes at 50 newtons a "
         "second at most, and more slowly when it is steeper than 2000 newtons per metre.",
         &set_force_function});
}

}  // namespace fulcrum::runtime
