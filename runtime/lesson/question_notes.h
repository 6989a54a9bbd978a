// What a teacher should know of a lesson's questions, though none of it is a mistake: fulcrum check prints it.
//
// Thread: any.  Cost: some hundred matches a question, and one reading of the dictionary of sounds.
#pragma once

#include "dialogue/conversation/conversation.h"
#include "runtime/scene/description.h"

#include <functional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Where Debian's pocketsphinx-en-us has the words that can be heard.
inline constexpr const char* kHeardWords = "/usr/share/pocketsphinx/model/en-us/cmudict-en-us.dict";

/// What is read beside the lesson's description.
struct NoteSources {
    std::vector<std::string>
        texts{};  ///< of the lesson's Lua files: they show how a question is asked
    std::string heard_words = kHeardWords;  ///< nothing of sounds is said where it cannot be read
    dialogue::FormCheck
        check{};  ///< of free English; nothing is said of what is good English where it is empty
    std::function<void(const std::string&)>
        begins{};  ///< told what is looked at from now on, "question heavy, lesson.lua:12"; may be empty
};

/// One sentence each, beginning with the question's line, "lesson.lua:12: question …": answers that are never taken, sentences
/// that mean two things, opposites that count alike, words without pronunciation, a question that is never asked, one without `again`
/// that is asked without a hint, sentences to be said back that are no good English. Of what a learner may ask: ways that ask for something else, and such words too. The questions compile.
[[nodiscard]] std::vector<std::string> question_notes(const LessonDescription& lesson,
                                                      const NoteSources& sources = {});

}  // namespace fulcrum::runtime
