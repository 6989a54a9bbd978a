// What one part of a lesson needs of another: a caught body needs a bucket, a body that is moved a world that moves it.
// What is missing while L:start still declares may come further down; it is judged when start() is over.
//
// Thread: that of the lesson's process.
#pragma once

#include "runtime/lua/api/lesson_context.h"

#include <optional>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

/// Is there what is needed, as far as it has been declared?
[[nodiscard]] bool is_met(const LessonDescription& description, Need need);

/// Raises `message` at the lesson's line when `need` is not met; while L:start runs it is noted instead.
void require_need(lua_State* lua, LessonContext& context, Need need, const std::string& message);

/// The same for a lesson that waits for events of that name, which is one that events have.
void require_event(lua_State* lua, LessonContext& context, std::string_view event);

/// After L:start: the first need that was noted and is still not met, or a callback that nothing can call.
[[nodiscard]] std::optional<ScriptError> find_unmet(lua_State* lua, const LessonContext& context);

}  // namespace fulcrum::runtime
