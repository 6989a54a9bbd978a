// Events as Lua tables.
#include "runtime/lua/api/nouns.h"
#include "runtime/lua/host/lesson_host.h"

namespace fulcrum::runtime {
namespace {

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
    set_flag(lua, "over", answer.over);
    set_flag(lua, "turned_round", answer.turned_round);
    lua_pushinteger(lua, answer.attempt);
    lua_setfield(lua, -2, "attempt");
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
    } else if (const auto* judge = std::get_if<JudgeEvent>(&event)) {
        lua_newtable(lua);
        set_slots(lua, judge->slots);
        set_bodies(lua, context, judge->slots);
        set_text(lua, "question", judge->question);
    } else {
        lua_newtable(lua);
        set_text(lua, "name", "ready");
    }
}

}  // namespace fulcrum::runtime
