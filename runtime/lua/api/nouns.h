// Which body a learner speaks of: a noun, not a name, comes out of an answer.
//
// Thread: pure functions. Cost: linear in the bodies.
#pragma once

#include "runtime/scene/description.h"

#include <cstdint>
#include <string_view>

namespace fulcrum::runtime {

/// A noun as answers give it: of "the Moon|moon" the first, without an article: "Moon".
[[nodiscard]] std::string_view spoken_noun(std::string_view noun);

/// The index of the one body with that noun; kNoBody when there is none, or several.
[[nodiscard]] std::int32_t body_with_noun(const LessonDescription& lesson, std::string_view noun);

/// How many bodies have that noun.
[[nodiscard]] int count_noun(const LessonDescription& lesson, std::string_view noun);

}  // namespace fulcrum::runtime
