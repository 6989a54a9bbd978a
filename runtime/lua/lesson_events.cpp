// Events as Lua tables.
#include "runtime/lua/lesson_host.h"

namespace fulcrum::runtime {
namespace {

void set_text(lua_State* L, const char* field, const std::string& text) {
    lua_pushlstring(L, text.data(), text.size());
    lua_setfield(L, -2, field);
}

void set_flag(lua_State* L, const char* field, bool value) {
    lua_pushboolean(L, value ? 1 : 0);
    lua_setfield(L, -2, field);
}

void set_slots(lua_State* L, const std::vector<std::pair<std::string, std::string>>& slots) {
    for (const auto& [name, value] : slots) {
        set_text(L, name.c_str(), value);
    }
}

const char* name_of(BodyEvent::Kind kind) {
    constexpr const char* kNames[] = {"caught", "landed", "touched", "released"};
    return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace

void push_answer(lua_State* L, const AnsweredEvent& answer) {
    lua_newtable(L);
    set_slots(L, answer.slots);
    set_text(L, "question", answer.question);
    set_text(L, "said", answer.said);
    set_flag(L, "understood", answer.understood);
    set_flag(L, "right", answer.right);
    set_flag(L, "form_right", answer.form_right);
    set_flag(L, "over", answer.over);
    lua_pushinteger(L, answer.attempt);
    lua_setfield(L, -2, "attempt");
}

void push_event(lua_State* L, LessonContext& /*context*/, const LessonEvent& event) {
    if (const auto* body = std::get_if<BodyEvent>(&event)) {
        lua_newtable(L);
        set_text(L, "name", name_of(body->kind));
        push_handle(L, Handle::Kind::body, body->body);
        lua_setfield(L, -2, "body");
        lua_pushnumber(L, body->speed_m_per_s);
        lua_setfield(L, -2, "speed");
    } else if (const auto* key = std::get_if<KeyEvent>(&event)) {
        lua_newtable(L);
        set_text(L, "name", "key");
        set_text(L, "key", key->key);
    } else if (const auto* answer = std::get_if<AnsweredEvent>(&event)) {
        push_answer(L, *answer);
        set_text(L, "name", "answered");
    } else if (const auto* judge = std::get_if<JudgeEvent>(&event)) {
        lua_newtable(L);
        set_slots(L, judge->slots);
        set_text(L, "question", judge->question);
    } else {
        lua_newtable(L);
        set_text(L, "name", "ready");
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
