// The hand: where it works, what it touches with, and the lesson's own force on it.
#include "runtime/effect/hand/hand_fields.h"
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"
#include "runtime/lua/api/take_fields.h"
#include "runtime/scene/shape_models.h"

#include <algorithm>
#include <iterator>

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
    if (shape == "hull") {
        return HullShape{};  // of the model that is named; the plan has it
    }
    return std::monostate{};
}

// Of a hull its model is said, and of no other cursor.
void check_cursor(lua_State* lua, const Arguments& arguments) {
    const bool is_hull = arguments["cursor"].text == "hull";
    const Argument& model = arguments["cursor_model"];
    if (is_hull != model.given) {
        raise_in_lesson(lua, is_hull ? "cursor = \"hull\" is the hull of a model; give "
                                       "cursor_model, such as \"banana\""
                                     : "cursor_model is of no use without cursor = \"hull\"; "
                                       "leave it out");
    }
    if (is_hull && arguments["cursor_size"].given) {
        raise_in_lesson(lua, "a hull has the size of its model; leave out cursor_size");
    }
    if (is_hull && is_shape_model(model.text)) {
        raise_in_lesson(
            lua, "the model \"" + model.text + "\" has no size of its own; take cursor = \"" +
                     (is_ball_model(model.text) ? "ball" : "box") + "\" or another model");
    }
}

// What would not be looked at is a mistake.
void check_structure(lua_State* lua, const Arguments& arguments) {
    const bool is_point = arguments["cursor"].text == "point" && !arguments["tool"].given;
    const bool is_god = arguments["proxy"].given && arguments["proxy"].text == "god_object";
    if (arguments["structure"].given && !(is_point && is_god)) {
        raise_in_lesson(lua,
                        "structure is of proxy = \"god_object\" with a point; add that, or leave "
                        "structure out");
    }
}

ProxyKind proxy_of(std::string_view name) {
    return name == "virtual_proxy"   ? ProxyKind::virtual_proxy
           : name == "friction_cone" ? ProxyKind::friction_cone
                                     : ProxyKind::god_object;
}

CursorShape shape_of(std::string_view name, double radius_m, double length_m) {
    if (name == "ball") {
        return SphereShape{radius_m};
    }
    if (name == "box") {
        return BoxShape{Vector3(radius_m, 0.5 * length_m, radius_m)};
    }
    if (name == "capsule") {
        return CapsuleShape{radius_m, 0.5 * length_m - radius_m};
    }
    return CylinderShape{radius_m, 0.5 * length_m};
}

// What is said of a tool and would not be looked at is a mistake.
struct Clash {
    const char* given;
    bool clashes;
    const char* because;
};

void check_tool_size(lua_State* lua, const Arguments& arguments) {
    const std::string& shape = arguments["shape"].text;
    const std::string& model = arguments["model"].text;
    const bool has_model = arguments["model"].given;
    const double radius_m = arguments["radius"].number;
    const double length_m = arguments["length"].number;
    if (has_model && arguments["shape"].given) {
        raise_in_lesson(lua, "the tool has a shape and a model; leave out one of them");
    }
    if (model == kOrbitModel) {
        raise_in_lesson(lua,
                        "an orbit is a thin line, seen and not felt; give the tool a shape or "
                        "another model");
    }
    const bool has_levels = arguments["contact"].text == "levels";
    const bool is_penalty = arguments["method"].text == "implicit_penalty";
    const Clash clashes[] = {
        {"contact", !is_penalty, "implicit_penalty alone has a choice of contacts"},
        {"detail", !has_levels, "contact = \"levels\" alone has one"},
        {"budget", !has_levels, "contact = \"levels\" alone has one"},
        {"voxel", has_levels, "contact levels know no voxels"},
        {"points", has_levels, "contact levels know triangles alone"},
        {"radius", has_model && !is_shape_model(model), "a model has its own size"},
        {"length", has_model, "a model has its own size"},
        {"length", !has_model && shape == "ball", "a ball has none"},
        {"mass", arguments["massless"].flag, "it is massless"},
        {"integrator", arguments["massless"].flag, "it is massless, and rests where all balances"},
        {"integrator", is_penalty, "implicit_penalty is moved on by backward_euler"},
        {"massless", is_penalty, "implicit_penalty moves a mass"},
        {"contact_model", !is_penalty, "implicit_penalty alone has a choice of them"},
        {"rounded", arguments["method"].text != "god_object",
         "of all methods god_object alone feels facets"},
        {"crease", !arguments["rounded"].flag, "it is not rounded"}};
    for (const auto& [given, is_clash, because] : clashes) {
        if (is_clash && arguments[given].given) {
            raise_in_lesson(lua, std::string("the tool's ") + given + " is of no use: " + because +
                                     "; leave it out");
        }
    }
    if (!has_model && shape == "capsule" && length_m <= 2.0 * radius_m) {
        raise_in_lesson(lua,
                        "a capsule is longer than twice its radius; give it more length, or take "
                        "shape = \"ball\"");
    }
}

ToolDescription take_tool(lua_State* lua, const Arguments& arguments) {
    check_tool_size(lua, arguments);
    ToolDescription tool;
    take_fields(fields::kTool, arguments, tool);
    const double radius_m = arguments["radius"].number;
    if (tool.model == kBoxModel) {
        tool.shape = BoxShape{Vector3::Constant(radius_m)};
    } else if (is_ball_model(tool.model)) {
        tool.shape = SphereShape{radius_m};
    } else if (arguments["model"].given) {
        tool.shape = std::monostate{};
    } else {
        tool.shape = shape_of(arguments["shape"].text, radius_m, arguments["length"].number);
    }
    const bool is_by_time = arguments["budget"].given && !arguments["detail"].given;
    tool.detail = is_by_time ? 0.0 : tool.detail;
    return tool;
}

// What a further hand cannot choose for itself.
void check_further_hand(lua_State* lua, const LessonContext& context, const Arguments& arguments) {
    if (context.n_hands == context.most_hands && context.most_hands == 1) {
        raise_in_lesson(lua,
                        "a lesson has one hand unless it says hands = 2 in lesson { … }; this is "
                        "the second world:hand { … }; keep what the first one gives");
    }
    if (context.n_hands == context.most_hands) {
        raise_in_lesson(lua, "a lesson has at most two hands; this is the third world:hand { … }");
    }
    if (context.n_hands == 0 && arguments["needed"].given) {
        raise_in_lesson(lua,
                        "the first hand is always there; give needed to the second world:hand "
                        "{ … }, or leave it out");
    }
    if (context.n_hands > 0 && arguments["rate"].given) {
        raise_in_lesson(lua,
                        "all hands are computed in one round; give rate to the first world:hand "
                        "{ … } alone");
    }
}

int set_hand(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    check_further_hand(lua, context, arguments);
    HandDescription hand;
    take_fields(fields::kHand, arguments, hand);
    check_cursor(lua, arguments);
    check_structure(lua, arguments);
    hand.cursor = cursor_of(arguments);
    if (arguments["proxy"].given) {
        hand.proxy = proxy_of(arguments["proxy"].text);
    }
    if (arguments["tool"].given) {
        for (const char* other : {"proxy", "cursor", "cursor_model", "cursor_size"}) {
            if (arguments[other].given) {
                raise_in_lesson(lua, std::string("the hand has a tool and a ") + other +
                                         "; leave out one of them");
            }
        }
        hand.tool = take_tool(lua, arguments.record("tool"));
    }
    hand.line = place_in_lesson(lua).line;
    const std::size_t index = context.n_hands++;  // of one that was refused there is none
    if (index == 0) {
        context.description.hand = std::move(hand);
    } else {
        context.description.more_hands.push_back(std::move(hand));
    }
    push_handle(lua, Handle::Kind::hand, static_cast<std::int32_t>(index));
    return 1;
}

// In L:start nobody knows yet.
void check_counted(lua_State* lua, const LessonContext& context, const char* what) {
    if (context.phase != LessonPhase::running) {
        raise_in_lesson(lua, std::string(what) +
                                 " is known once the lesson runs, in L:update and later, not in "
                                 "L:start");
    }
}

bool is_there(const LessonContext& context, std::int32_t hand) {
    return static_cast<std::size_t>(hand) < count_hands(context.frame);
}

int get_there(lua_State* lua, LessonContext& context, std::int32_t index) {
    check_counted(lua, context, "hand.there");
    lua_pushboolean(lua, is_there(context, index) ? 1 : 0);
    return 1;
}

int get_tool_of_hand(lua_State* lua, LessonContext& context, std::int32_t index) {
    check_counted(lua, context, "hand.tool");
    if (is_there(context, index)) {
        push_handle(lua, Handle::Kind::tool, index);
    } else {
        lua_pushnil(lua);
    }
    return 1;
}

int get_hands(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    check_counted(lua, context, "world.hands");
    lua_pushinteger(lua, static_cast<lua_Integer>(count_hands(context.frame)));
    return 1;
}

int set_force_function(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    if (context.force_function_ref != LUA_NOREF) {
        raise_in_lesson(lua, "a lesson has one force function; this is the second hand:force(…)");
    }
    lua_pushvalue(lua, arguments["function"].stack_index);
    if (check_handle(lua, 1, Handle::Kind::hand, "hand:force").index > 0) {
        raise_in_lesson(lua,
                        "the lesson's own force is the first hand's; call force of what the first "
                        "world:hand { … } gave");
    }
    context.force_function_ref = luaL_ref(lua, LUA_REGISTRYINDEX);
    context.description.hand.lesson_force = true;
    context.description.hand.force_line = place_in_lesson(lua).line;
    return 0;
}

}  // namespace

void add_hand_api(ApiTable& table) {
    using enum ParameterType;
    table.functions.push_back(
        {"world", "hand", CallShape::record, CallTime::declaring, rows_of(fields::kHand), "Hand",
         "Says where the hand works in the scene. With hands = 2 in lesson { … } a second call "
         "declares another hand, with a "
         "place, cursor and loop of its own: two fingers, or both hands of a learner. Where there "
         "is one device the second one is not there (hand.there), unless it is needed. Two hands "
         "go with solid and rigid bodies and declared forces; bucket, kite, hinges, movable bodies "
         "and the lesson's own force are for one. What is touched is heard of the first.",
         &set_hand});
    table.properties.push_back({"hand", "there", "boolean", "",
                                "whether somebody moves it; the first always, a second one where "
                                "there is a device for it; known once the lesson runs",
                                &get_there});
    table.properties.push_back({"hand", "tool", "Tool", "",
                                "where it is and what it feels; nil where it is not there",
                                &get_tool_of_hand});
    table.properties.push_back({"world", "hands", "number", "",
                                "how many hands are there; known once the lesson runs",
                                &get_hands});
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
