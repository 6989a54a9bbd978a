// What a teacher should know of the nouns of a lesson's bodies and the words in its lists: a common noun that is written as a name, "Apple", gets no article.
//
// Thread: any.  Cost: a look-up in WordNet for each word with a capital.
#pragma once

#include "runtime/scene/description.h"

#include <string>
#include <vector>

namespace fulcrum::runtime {

/// A sentence for each such word, once, beginning with the line of the body, the question or what is known that has it first; none for planets
/// and other names, and none where WordNet is not installed.
[[nodiscard]] std::vector<std::string> list_notes(const LessonDescription& lesson);

/// The lesson as it is meant where the noun of a body is such a word, "Wooden block": with a small letter. Else as it is.
[[nodiscard]] LessonDescription with_small_nouns(LessonDescription lesson);

}  // namespace fulcrum::runtime
