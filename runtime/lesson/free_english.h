// The checker of free English for a lesson that calls for it: word lists, grammar and rules, opened together.
//
// Thread: one.  Cost: about 0.25 s and 16 MB to open; then up to some ten milliseconds an answer.
#pragma once

#include "dialogue/checking/link_grammar/link_judge.h"
#include "dialogue/conversation/conversation.h"
#include "haptics/base/error.h"
#include "runtime/scene/description.h"

#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Opens it for a lesson with these things in it (`checking/checker.h`); an error names the Debian package that is missing.
[[nodiscard]] Expected<dialogue::FormCheck> open_free_english(
    std::vector<std::string> things, dialogue::GrammarOpens when = dialogue::GrammarOpens::at_once);
/// The same for what a teacher writes (EnglishChecker::review).
[[nodiscard]] Expected<dialogue::FormCheck> open_english_review(std::vector<std::string> things);

/// What the bodies of a lesson are called, what its questions call {thing}, and the words of their lists that all answers say with an
/// article ("at the {place}"): each noun once; no names, nothing that is only measured.
[[nodiscard]] std::vector<std::string> things_of(const LessonDescription& lesson);

}  // namespace fulcrum::runtime
