// A declared force: switched, moved and weakened while the lesson runs.
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"

namespace fulcrum::runtime {
namespace {

/// How force `index` stands; what a lesson changes is sent whole.
FieldCommand& field_of(lua_State* lua, LessonContext& context) {
    return context.fields[static_cast<std::size_t>(to_handle(lua, 1)->index)];
}

int send(lua_State* lua, LessonContext& context) {
    add_command(lua, FieldChangeCommand{to_handle(lua, 1)->index, field_of(lua, context)});
    return 0;
}

int switch_on(lua_State* lua, LessonContext& context, const Arguments& /*arguments*/) {
    field_of(lua, context).on = true;
    return send(lua, context);
}
int switch_off(lua_State* lua, LessonContext& context, const Arguments& /*arguments*/) {
    field_of(lua, context).on = false;
    return send(lua, context);
}
int move(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    field_of(lua, context).anchor_W = arguments["at"].vector;
    return send(lua, context);
}
int set_strength(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    field_of(lua, context).strength = arguments["factor"].number;
    return send(lua, context);
}

int get_force_name(lua_State* lua, LessonContext& context, std::int32_t index) {
    return push_text(lua, context.description.forces[static_cast<std::size_t>(index)].name);
}

}  // namespace

void add_force_api(ApiTable& table) {
    using enum ParameterType;
    constexpr auto kActing = CallTime::acting;
    table.functions.push_back({"force",
                               "on",
                               CallShape::positional,
                               kActing,
                               {},
                               "",
                               "Switches it on, as it is when it is declared.",
                               &switch_on});
    table.functions.push_back({"force",
                               "off",
                               CallShape::positional,
                               kActing,
                               {},
                               "",
                               "Switches it off; it fades.",
                               &switch_off});
    table.functions.push_back({"force",
                               "move",
                               CallShape::record,
                               kActing,
                               {{"at", vector, "metres", -kMaxCoordinate_m, kMaxCoordinate_m,
                                 kRequired, "where it pulls to from now on"}},
                               "",
                               "Moves a spring or a magnet.",
                               &move});
    table.functions.push_back(
        {"force",
         "strength",
         CallShape::positional,
         kActing,
         {{"factor", number, "", 0, 1, kRequired, "1 as declared, 0 nothing"}},
         "",
         "Weakens it.",
         &set_strength});
    table.properties.push_back({"force", "name", "string", "", "", &get_force_name});
}

}  // namespace fulcrum::runtime
