// What a lesson does to the world and to the learner while it runs, and what it can look up.
#include "haptics/math/rotation.h"
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"
#include "runtime/lua/api/nouns.h"
#include "runtime/lua/api/sound_names.h"

#include <algorithm>

namespace fulcrum::runtime {
namespace {

int release_all(lua_State* lua, LessonContext& /*context*/, const Arguments& /*arguments*/) {
    WorldCommand move;
    move.kind = WorldCommand::Kind::release;
    add_command(lua, MoveCommand{move});
    return 0;
}

int show_caption(lua_State* lua, LessonContext& /*context*/, const Arguments& arguments) {
    add_command(lua, CaptionCommand{arguments["text"].text});
    return 0;
}

int ask_question(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    const std::string& id = arguments["question"].text;
    std::vector<std::string> known;
    for (const QuestionDescription& question : context.description.questions) {
        known.push_back(question.id);
    }
    if (std::find(known.begin(), known.end(), id) == known.end()) {
        const std::string near = nearest_word(id, known);
        raise_in_lesson(lua, "there is no question \"" + clean_text(id, 40) + '"' +
                                 (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
    }
    add_command(lua, AskCommand{id});
    return 0;
}

int set_score(lua_State* lua, LessonContext& /*context*/, const Arguments& arguments) {
    add_command(lua, ScoreCommand{static_cast<std::int32_t>(arguments["score"].number)});
    return 0;
}

int set_level(lua_State* lua, LessonContext& /*context*/, const Arguments& arguments) {
    add_command(lua, LevelCommand{static_cast<std::int32_t>(arguments["level"].number),
                                  arguments["title"].text});
    return 0;
}

int play_sound(lua_State* lua, LessonContext& /*context*/, const Arguments& arguments) {
    if (const std::string problem = sound_problem(arguments["name"].text); !problem.empty()) {
        raise_in_lesson(lua, problem);
    }
    add_command(lua, SoundCommand{arguments["name"].text});
    return 0;
}

int show_hand(lua_State* lua, LessonContext& /*context*/, const Arguments& arguments) {
    add_command(lua, ShowHandCommand{arguments["at"].vector});
    return 0;
}

int hide_hand(lua_State* lua, LessonContext& /*context*/, const Arguments& /*arguments*/) {
    add_command(lua, ShowHandCommand{});
    return 0;
}

int finish(lua_State* lua, LessonContext& /*context*/, const Arguments& arguments) {
    add_command(lua, FinishCommand{static_cast<std::int32_t>(arguments["stars"].number)});
    return 0;
}

int list_bodies(lua_State* lua, LessonContext& context, const Arguments& /*arguments*/) {
    lua_newtable(lua);
    for (std::size_t i = 0; i < context.description.bodies.size(); ++i) {
        push_handle(lua, Handle::Kind::body, static_cast<std::int32_t>(i));
        lua_rawseti(lua, -2, static_cast<lua_Integer>(i) + 1);
    }
    return 1;
}

int find_body(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    const std::string& wanted = arguments["name"].text;
    std::vector<std::string> known;
    for (std::size_t i = 0; i < context.description.bodies.size(); ++i) {
        known.push_back(context.description.bodies[i].name);
        if (known.back() == wanted) {
            push_handle(lua, Handle::Kind::body, static_cast<std::int32_t>(i));
            return 1;
        }
    }
    if (const std::int32_t body = body_with_noun(context.description, wanted); body != kNoBody) {
        push_handle(lua, Handle::Kind::body, body);
        return 1;
    }
    if (count_noun(context.description, wanted) > 1) {
        raise_in_lesson(lua, "several bodies have the noun \"" + clean_text(wanted, 40) +
                                 "\"; find one by its name");
    }
    for (const BodyDescription& body : context.description.bodies) {
        known.push_back(body.noun);
    }
    const std::string near = nearest_word(wanted, known);
    raise_in_lesson(lua, "there is no body \"" + clean_text(wanted, 40) + '"' +
                             (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
}

int get_tool(lua_State* lua, LessonContext& /*context*/, const Arguments& /*arguments*/) {
    push_handle(lua, Handle::Kind::tool, 0);
    return 1;
}

int get_time(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    lua_pushnumber(lua, context.frame.time_s);
    return 1;
}

int get_day(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    if (!context.day) {
        raise_in_lesson(
            lua, "world.day is known once the lesson runs, in L:update and later, not in L:start");
    }
    lua_pushnumber(lua, *context.day);
    return 1;
}

void set_number(lua_State* lua, const char* field, lua_Integer value) {
    lua_pushinteger(lua, value);
    lua_setfield(lua, -2, field);
}

int get_past(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    if (!context.description.wants_past || !context.day) {
        raise_in_lesson(lua,
                        context.description.wants_past
                            ? "world.past is known once the lesson runs, in L:update and later, "
                              "not in L:start"
                            : "world.past is only known to a lesson that asks for it; write "
                              "world:recall() in L:start");
    }
    lua_newtable(lua);
    for (std::size_t i = 0; i < context.past.size(); ++i) {
        const PastAnswers& past = context.past[i];
        lua_newtable(lua);
        push_text(lua, past.lesson);
        lua_setfield(lua, -2, "lesson");
        push_text(lua, past.question);
        lua_setfield(lua, -2, "question");
        set_number(lua, "asked", past.asked);
        set_number(lua, "right", past.right);
        set_number(lua, "wrong_now", past.wrong_now);
        lua_pushnumber(lua, past.days);
        lua_setfield(lua, -2, "days");
        lua_newtable(lua);
        for (const auto& [point, n_errors] : past.points) {
            set_number(lua, point.c_str(), n_errors);
        }
        lua_setfield(lua, -2, "points");
        lua_rawseti(lua, -2, static_cast<lua_Integer>(i) + 1);
    }
    return 1;
}

int get_touched(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    if (context.touched == kNoBody) {
        lua_pushnil(lua);
    } else {
        push_handle(lua, Handle::Kind::body, context.touched);
    }
    return 1;
}

void add_world_properties(ApiTable& table) {
    table.properties.push_back(
        {"world", "time", "number", "seconds", "since the lesson began", &get_time});
    table.properties.push_back({"world", "day", "number", "days",
                                "today, since noon of 1 January 2000, as planets.day counts; tests "
                                "and simulated hands have 22 June 2026",
                                &get_day});
    table.properties.push_back(
        {"world", "past", "table[]", "",
         "what this learner has answered before, where L:start calls world:recall(); see bank",
         &get_past});
    table.properties.push_back({"world", "touched", "Body", "",
                                "the solid body that the tool touches or touched last; nil before",
                                &get_touched});
}

}  // namespace

void add_action_api(ApiTable& table) {
    using enum ParameterType;
    constexpr auto kPositional = CallShape::positional;
    constexpr auto kActing = CallTime::acting;
    constexpr auto kLooking = CallTime::looking;
    table.functions.push_back({"world",
                               "release",
                               kPositional,
                               kActing,
                               {},
                               "",
                               "Takes everything out of the bucket.",
                               &release_all});
    table.functions.push_back(
        {"world",
         "caption",
         kPositional,
         kActing,
         {{"text", text, "", 0, 1000, kRequired, "one instruction; \"\" clears it"}},
         "",
         "Shows an instruction.",
         &show_caption});
    table.functions.push_back(
        {"world",
         "ask",
         kPositional,
         kActing,
         {{"question", text, "", 0, 1000, kRequired, "the name of a question"}},
         "",
         "Asks a question that L:question declared; L:answered tells the answer.",
         &ask_question});
    table.functions.push_back({"world",
                               "score",
                               kPositional,
                               kActing,
                               {{"score", integer, "", -kMostScore, kMostScore, kRequired, ""}},
                               "",
                               "Sets the score that is shown.",
                               &set_score});
    table.functions.push_back(
        {"world",
         "level",
         kPositional,
         kActing,
         {{"level", integer, "", 0, kMostLevel, kRequired, ""},
          {"title", text, "", 0, kMostTitleBytes, "", "what the level is called"}},
         "",
         "Begins a level.",
         &set_level});
    table.functions.push_back({"world",
                               "sound",
                               kPositional,
                               kActing,
                               {{"name", name, "", 0, 0, kRequired, "see Sounds; e.g. \"pop\""}},
                               "",
                               "Plays a sound.",
                               &play_sound});
    table.functions.push_back(
        {"world",
         "show_hand",
         CallShape::record,
         kActing,
         {{"at", vector, "metres", -kMaxCoordinate_m, kMaxCoordinate_m, kRequired,
           "where its first finger's tip is"}},
         "",
         "Shows the program's own hand there, a white glove: it shows what to do, and touches "
         "nothing.",
         &show_hand});
    table.functions.push_back({"world",
                               "hide_hand",
                               kPositional,
                               kActing,
                               {},
                               "",
                               "Takes the program's own hand away.",
                               &hide_hand});
    table.functions.push_back(
        {"world",
         "finish",
         CallShape::record,
         kActing,
         {{"stars", integer, "", 0, kMostStars, kRequired, "how well it went"}},
         "",
         "Ends the lesson.",
         &finish});
    table.functions.push_back({"world",
                               "bodies",
                               kPositional,
                               kLooking,
                               {},
                               "Body[]",
                               "All bodies, in the order they were declared.",
                               &list_bodies});
    table.functions.push_back({"world",
                               "find",
                               kPositional,
                               kLooking,
                               {{"name", text, "", 0, 1000, kRequired,
                                 "the body's name, or its noun when no other body has it"}},
                               "Body",
                               "The body of that name or noun.",
                               &find_body});
    table.functions.push_back(
        {"world", "tool", kPositional, kLooking, {}, "Tool", "What the hand holds.", &get_tool});
    add_world_properties(table);
}

}  // namespace fulcrum::runtime
