// What the program's own check of English says of a sentence that a teacher wrote, in the words of a note.
//
// Thread: any.  Cost: one check (checking/checker.h).
#pragma once

#include "dialogue/conversation/conversation.h"

#include <string>

namespace fulcrum::runtime {

/// What is wrong with one or several English sentences, as a sentence's end: "is no good English; better is "It is red.""; empty for nothing,
/// and where `check` is empty.
[[nodiscard]] std::string tell_form(const dialogue::FormCheck& check, const std::string& text);

/// The same, of a text that has been checked.
[[nodiscard]] std::string tell_checked(const dialogue::CheckedText& checked,
                                       const std::string& text);

}  // namespace fulcrum::runtime
