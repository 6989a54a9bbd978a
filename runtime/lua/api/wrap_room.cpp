// A room, from which other lessons are entered.
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"

#include <algorithm>

namespace fulcrum::runtime {
namespace {

int set_room(lua_State* /*lua*/, LessonContext& context, const Arguments& /*arguments*/) {
    context.description.is_room = true;
    return 0;
}

int enter(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    if (!context.description.is_room) {
        raise_in_lesson(
            lua, "only a room can be left for another lesson; write world:room() in L:start");
    }
    if (!context.day) {
        raise_in_lesson(
            lua,
            "a lesson can be entered once the room runs, in L:update and later, not in L:start");
    }
    const std::string& name = arguments["lesson"].text;
    const bool is_known =
        name.empty() || std::ranges::any_of(context.lessons, [&](const auto& lesson) {
            return lesson.name == name;
        });
    if (!is_known) {
        raise_in_lesson(lua, "there is no lesson \"" + name +
                                 "\" to enter; world.lessons has those that are here");
    }
    add_command(lua, EnterCommand{name});
    return 0;
}

int get_lessons(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    if (!context.description.is_room || !context.day) {
        raise_in_lesson(
            lua, context.description.is_room
                     ? "world.lessons is known once the room is entered, in L:update and later, "
                       "not in L:start"
                     : "world.lessons is only known to a room; write world:room() in L:start");
    }
    lua_newtable(lua);
    for (std::size_t i = 0; i < context.lessons.size(); ++i) {
        const KnownLesson& lesson = context.lessons[i];
        lua_newtable(lua);
        for (const auto& [field, text] :
             {std::pair("name", &lesson.name), std::pair("title", &lesson.title),
              std::pair("level", &lesson.level), std::pair("icon", &lesson.icon)}) {
            push_text(lua, *text);
            lua_setfield(lua, -2, field);
        }
        lua_pushinteger(lua, lesson.stars);
        lua_setfield(lua, -2, "stars");
        lua_rawseti(lua, -2, static_cast<lua_Integer>(i) + 1);
    }
    return 1;
}

}  // namespace

void add_room_api(ApiTable& table) {
    using enum ParameterType;
    table.functions.push_back(
        {"world",
         "room",
         CallShape::positional,
         CallTime::declaring,
         {},
         "",
         "Other lessons are entered from here: world.lessons has them, world:enter goes there, and "
         "who leaves one comes back. Nothing of a "
         "room itself is kept as progress.",
         &set_room});
    table.functions.push_back(
        {"world",
         "enter",
         CallShape::positional,
         CallTime::acting,
         {{"lesson", text, "", 0, 1000, "", "its name in world.lessons; \"\" is the list of all"}},
         "",
         "Leaves a room for another lesson.",
         &enter});
    table.properties.push_back({"world", "lessons", "table[]", "",
                                "of a room: the lessons that can be entered, in their order, each "
                                "with name, title, level, icon (a model) and stars, this learner's "
                                "best, -1 where it was never played to its end",
                                &get_lessons});
}

}  // namespace fulcrum::runtime
