// What a lesson means when it names a material.
//
// Thread: that of the lesson's process.
#pragma once

#include "runtime/lua/api/lesson_context.h"

#include <cstdint>

namespace fulcrum::runtime {

/// The index of the material that an argument of that type gives; one of the program's own joins the description when it
/// is first named. kNoMaterial when none was given; raises when there is none of that name.
[[nodiscard]] std::int32_t find_or_add_material(lua_State* lua, LessonContext& context,
                                                const Argument& given);

}  // namespace fulcrum::runtime
