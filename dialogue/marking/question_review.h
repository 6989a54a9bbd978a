// What an author hardly meant: an answer that is never taken, a sentence that means two things, an opposite that counts as
// the same answer, a word that nobody can hear.
//
// A question is tried with sentences of its own templates, as a pupil says them: what is told was seen in a sentence, which is
// named. What is seen in none of them is not told. Which words are opposites is told by who calls: a table, or WordNet's (antonyms.h).
//
// Thread: pure.  Cost: some hundred matches a question; for whoever checks a lesson.
#pragma once

#include "dialogue/marking/question.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// The opposites of a word in lower case, in its form: "heavier" {"lighter"}.
using Opposites = std::function<std::vector<std::string>(std::string_view)>;

/// What the review found, one sentence each, without a place.
///   answer 2 is never taken: answer 1 has "The egg is heavy." and all else of it
///   "The egg is the rock." means thing = egg, and thing = rock as well
///   "The egg is lighter." counts as "The egg is heavier."
/// A word that stands in `meant`, sentences that the author calls right, is not told as an opposite.
[[nodiscard]] std::vector<std::string> review_question(const Question& question,
                                                       const Opposites& opposites,
                                                       const std::vector<std::string>& meant = {});

/// What is said back for the question's answers, a few sentences of each: what a recast or a typed answer's echo shows.
struct SaidBack {
    int answer = 0;
    std::string sentence;
};
[[nodiscard]] std::vector<SaidBack> said_back(const Question& question);

/// The words of right answers of which `can_be_heard` says no, each once, in the order of the templates.
[[nodiscard]] std::vector<std::string> unheard_words(
    const Question& question, const std::function<bool(std::string_view)>& can_be_heard);

}  // namespace fulcrum::dialogue
