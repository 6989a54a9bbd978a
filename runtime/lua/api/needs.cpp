#include "runtime/lua/api/needs.h"

#include <algorithm>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kMostNoted = 16;  // more than one is never told
constexpr const char* kNothingCatches =
    "nothing can be caught without world:bucket; put a bucket on the tool in L:start";

}  // namespace

bool is_met(const LessonDescription& description, Need need) {
    if (need == Need::bucket) {
        return description.bucket.present;
    }
    if (need == Need::kite) {
        return description.kite.has_value();
    }
    if (need == Need::hands) {
        return !description.more_hands.empty();
    }
    return std::any_of(description.bodies.begin(), description.bodies.end(),
                       [](const BodyDescription& body) { return body.movable; });
}

void require_need(lua_State* lua, LessonContext& context, Need need, const std::string& message) {
    if (is_met(context.description, need)) {
        return;
    }
    if (context.phase != LessonPhase::starting) {
        raise_in_lesson(lua, message);
    }
    if (context.needs.size() < kMostNoted) {
        ScriptError error = place_in_lesson(lua);
        error.message = message;
        context.needs.emplace_back(need, std::move(error));
    }
}

void require_event(lua_State* lua, LessonContext& context, std::string_view event) {
    if (event == "caught") {
        require_need(lua, context, Need::bucket, kNothingCatches);
    }
}

std::optional<ScriptError> find_unmet(lua_State* lua, const LessonContext& context) {
    for (const auto& [need, error] : context.needs) {
        if (!is_met(context.description, need)) {
            return error;
        }
    }
    if (is_met(context.description, Need::bucket)) {
        return std::nullopt;
    }
    std::optional<ScriptError> unmet;
    lua_rawgeti(lua, LUA_REGISTRYINDEX, context.lesson_ref);
    lua_pushliteral(lua, "caught");
    lua_Debug about{};
    if (lua_rawget(lua, -2) == LUA_TFUNCTION) {
        lua_getinfo(lua, ">S", &about);
        unmet = ScriptError{std::string("L:caught is never called: ") + kNothingCatches,
                            about.short_src, std::max(about.linedefined, 0)};
    } else {
        lua_pop(lua, 1);
    }
    lua_pop(lua, 1);
    return unmet;
}

}  // namespace fulcrum::runtime
