// Events as Lua tables.
#include "runtime/lua/api/nouns.h"
#include "runtime/lua/api/reference_sections.h"
#include "runtime/lua/host/lesson_host.h"

#include <algorithm>
#include <string>
#include <vector>

namespace fulcrum::runtime {
namespace {

constexpr std::uint64_t kWorkASlot = 20;

void set_text(lua_State* lua, const char* field, const std::string& text) {
    lua_pushlstring(lua, text.data(), text.size());
    lua_setfield(lua, -2, field);
}

void set_flag(lua_State* lua, const char* field, bool value) {
    lua_pushboolean(lua, value ? 1 : 0);
    lua_setfield(lua, -2, field);
}

void set_slots(lua_State* lua, const std::vector<std::pair<std::string, std::string>>& slots) {
    for (const auto& [name, value] : slots) {
        set_text(lua, name.c_str(), value);
    }
}

/// `bodies`: of each slot that speaks of one body of the scene, that body.
void set_bodies(lua_State* lua, const LessonContext& context,
                const std::vector<std::pair<std::string, std::string>>& slots) {
    lua_newtable(lua);
    for (const auto& [name, value] : slots) {
        if (const std::int32_t body = body_with_noun(context.description, value); body != kNoBody) {
            push_handle(lua, Handle::Kind::body, body);
            lua_setfield(lua, -2, name.c_str());
        }
    }
    lua_setfield(lua, -2, "bodies");
}

/// Adds what stands in a template's braces: "{thing}" and "{thing:other}" give thing and other.
void add_slots(const std::string& sentence, std::vector<std::string>& slots) {
    for (std::size_t at = sentence.find('{'); at != std::string::npos;
         at = sentence.find('{', at + 1)) {
        const std::string inside = sentence.substr(at + 1, sentence.find('}', at) - at - 1);
        slots.push_back(inside.substr(inside.find(':') + 1));
    }
}

/// The slots that the question's sentences may fill, those in its rules too.
std::vector<std::string> slots_of(const QuestionDescription& question) {
    std::vector<std::string> slots;
    for (const auto* templates : {&question.answers, &question.nearly}) {
        for (const std::string& sentence : *templates) {
            add_slots(sentence, slots);
        }
    }
    for (const auto& [name, rule] : question.rules) {
        add_slots(rule, slots);
    }
    return slots;
}

/// __index of an answer. Upvalues: the lesson's context, the question's name.
int read_unfilled(lua_State* lua) {
    const auto* context =
        static_cast<const LessonContext*>(lua_touserdata(lua, lua_upvalueindex(1)));
    const std::string question = lua_tostring(lua, lua_upvalueindex(2));
    const std::string name = lua_type(lua, 2) == LUA_TSTRING ? lua_tostring(lua, 2) : "";
    const auto& all = context->description.questions;
    const auto asked = std::find_if(
        all.begin(), all.end(), [&](const QuestionDescription& one) { return one.id == question; });
    const std::vector<std::string> slots =
        asked == all.end() ? std::vector{name} : slots_of(*asked);
    ScriptState::of(lua).charge(lua, 100 + kWorkASlot * slots.size());
    if (std::ranges::find(answer_fields(), name, &FieldText::name) != answer_fields().end()) {
        raise_in_lesson(lua, "answer." + name + " is known when `right` has judged, not yet in it");
    }
    if (!name.empty() && std::ranges::find(slots, name) == slots.end()) {
        std::vector<std::string> meant = slots;
        for (const FieldText& field : answer_fields()) {
            meant.emplace_back(field.name);
        }
        const std::string near = nearest_word(name, meant);
        raise_in_lesson(
            lua, "no sentence of the question \"" + question + "\" has {" + clean_text(name, 40) +
                     "}; " +
                     (near.empty() ? "is it spelt right?" : "did you mean answer." + near + "?"));
    }
    lua_pushnil(lua);
    return 1;
}

/// What the answer's sentence left out is nil; what none of the question's sentences has is a slip of the pen.
void guard_slots(lua_State* lua, const LessonContext& context, const std::string& question) {
    lua_newtable(lua);
    lua_pushlightuserdata(lua, const_cast<LessonContext*>(&context));
    lua_pushlstring(lua, question.data(), question.size());
    lua_pushcclosure(lua, &read_unfilled, 2);
    lua_setfield(lua, -2, "__index");
    lua_pushboolean(lua, 0);
    lua_setfield(lua, -2, "__metatable");
    lua_setmetatable(lua, -2);
}

const char* name_of(BodyEvent::Kind kind) {
    constexpr const char* kNames[] = {"caught", "landed", "touched", "released"};
    return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace

void push_answer(lua_State* lua, const LessonContext& context, const AnsweredEvent& answer) {
    lua_newtable(lua);
    set_slots(lua, answer.slots);
    set_bodies(lua, context, answer.slots);
    set_text(lua, "question", answer.question);
    set_text(lua, "said", answer.said);
    set_flag(lua, "understood", answer.understood);
    set_flag(lua, "right", answer.right);
    set_flag(lua, "form_right", answer.form_right);
    set_flag(lua, "form_known", answer.form_known);
    set_flag(lua, "over", answer.over);
    set_flag(lua, "turned_round", answer.turned_round);
    set_flag(lua, "replay", answer.replay);
    lua_pushinteger(lua, answer.attempt);
    lua_setfield(lua, -2, "attempt");
    guard_slots(lua, context, answer.question);
}

void push_event(lua_State* lua, const LessonContext& context, const LessonEvent& event) {
    if (const auto* body = std::get_if<BodyEvent>(&event)) {
        lua_newtable(lua);
        set_text(lua, "name", name_of(body->kind));
        push_handle(lua, Handle::Kind::body, body->body);
        lua_setfield(lua, -2, "body");
        lua_pushnumber(lua, body->speed_m_per_s);
        lua_setfield(lua, -2, "speed");
    } else if (const auto* key = std::get_if<KeyEvent>(&event)) {
        lua_newtable(lua);
        set_text(lua, "name", "key");
        set_text(lua, "key", key->key);
    } else if (const auto* answer = std::get_if<AnsweredEvent>(&event)) {
        push_answer(lua, context, *answer);
        set_text(lua, "name", "answered");
    } else if (const auto* asked = std::get_if<AskedEvent>(&event)) {
        lua_newtable(lua);
        set_slots(lua, asked->slots);
        set_bodies(lua, context, asked->slots);
    } else if (const auto* judge = std::get_if<JudgeEvent>(&event)) {
        lua_newtable(lua);
        set_slots(lua, judge->slots);
        set_bodies(lua, context, judge->slots);
        set_text(lua, "question", judge->question);
        guard_slots(lua, context, judge->question);
    } else {
        lua_newtable(lua);
        set_text(lua, "name", "ready");
    }
}

}  // namespace fulcrum::runtime
