// Events as Lua tables.
#include "runtime/lua/lesson_host.h"

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

const char* name_of(BodyEvent::Kind kind) {
    constexpr const char* kNames[] = {"caught", "landed", "touched", "released"};
    return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace

void push_answer(lua_State* lua, const AnsweredEvent& answer) {
    lua_newtable(lua);
    set_slots(lua, answer.slots);
    set_text(lua, "question", answer.question);
    set_text(lua, "said", answer.said);
    set_flag(lua, "understood", answer.understood);
    set_flag(lua, "right", answer.right);
    set_flag(lua, "form_right", answer.form_right);
    set_flag(lua, "over", answer.over);
    lua_pushinteger(lua, answer.attempt);
    lua_setfield(lua, -2, "attempt");
}

void push_event(lua_State* lua, LessonContext& /*context*/, const LessonEvent& event) {
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
        push_answer(lua, *answer);
        set_text(lua, "name", "answered");
    } else if (const auto* judge = std::get_if<JudgeEvent>(&event)) {
        lua_newtable(lua);
        set_slots(lua, judge->slots);
        set_text(lua, "question", judge->question);
    } else {
        lua_newtable(lua);
        set_text(lua, "name", "ready");
    }
}

std::vector<std::string> find_sounds(std::string_view text) {
    constexpr std::string_view kCall = ":sound";
    std::vector<std::string> sounds;
    for (std::size_t at = text.find(kCall); at != std::string_view::npos;
         at = text.find(kCall, at + 1)) {
        std::size_t i = text.find_first_not_of(" \t(", at + kCall.size());
        if (i == std::string_view::npos || (text[i] != '"' && text[i] != '\'')) {
            continue;
        }
        const std::size_t end = text.find(text[i], i + 1);
        const std::string name(text.substr(i + 1, end == std::string_view::npos ? 0 : end - i - 1));
        const bool is_new = std::find(sounds.begin(), sounds.end(), name) == sounds.end();
        if (is_name(name) && is_new && sounds.size() < kMaxListItems) {
            sounds.push_back(name);
        }
    }
    return sounds;
}

}  // namespace fulcrum::runtime
