// What a teacher should know of a lesson's questions, though none of it is a mistake: fulcrum check prints it.
//
// Thread: any.  Cost: some hundred matches a question, and one reading of the dictionary of sounds.
#pragma once

#include "runtime/scene/description.h"

#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Where Debian's pocketsphinx-en-us has the words that can be heard.
inline constexpr const char* kHeardWords = "/usr/share/pocketsphinx/model/en-us/cmudict-en-us.dict";

/// One sentence each, beginning with the question's line, "lesson.lua:12: question …": answers that are never taken, sentences
/// that mean two things, opposites that count alike, words without pronunciation, a question without `again`. Nothing of
/// sounds where `heard_words` cannot be read. Of what a learner may ask: ways that ask for something else, and such words too. The
/// questions compile.
[[nodiscard]] std::vector<std::string> question_notes(const LessonDescription& lesson,
                                                      const std::string& heard_words = kHeardWords);

}  // namespace fulcrum::runtime
