// Finds errors of form in a free English sentence, which no template foresees: "I felt a rock hard", "it have two moon".
//
//   text -> sentences with their words (reading) -> rules propose (proposal) -> a judge of whole sentences decides
//           where the words alone can't -> put right and read again, until nothing more is found
//        -> errors with ERRANT's codes, and the corrected text
//
// It rather says nothing than something wrong: what it marks is an error in 199 of 200 sentences at least that are
// none. It doesn't know what was meant.
//
// Thread: one.  Cost: about 0.1 ms a sentence, and some parses where a judge is asked (link_grammar/link_judge.h).
#pragma once

#include "dialogue/checking/checked_text.h"
#include "dialogue/checking/judge.h"
#include "dialogue/english/lexicon.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// Checks texts.
class EnglishChecker {
  public:
    /// `judge` isn't null.
    EnglishChecker(Lexicon lexicon, std::unique_ptr<SentenceJudge> judge)
        : lexicon_(std::move(lexicon)), judge_(std::move(judge)) {}

    /// What stands before the learner from now on: its nouns, in the singular and in small letters. In a kitchen egg may be heavier; of an
    /// egg on the screen that is said with an article.
    void set_things(std::vector<std::string> things) { things_ = std::move(things); }

    /// Only the first kLongestFreeText_bytes are looked at; what is behind is kept as it is.
    /// What is put right is checked again, so that one error hides no other.
    [[nodiscard]] CheckedText check(std::string_view text);

    /// The same for somebody who is to be told good English: whether the outcome is that is `proven`. What isn't must not be said as a
    /// sentence. Costs a parse more for each sentence.
    [[nodiscard]] CheckedText advise(std::string_view text);

    /// The same for somebody who writes for others: where nothing is wrong, what is `unread` too. Costs another parse where it isn't proven.
    [[nodiscard]] CheckedText review(std::string_view text);

  private:
    Lexicon lexicon_;
    std::unique_ptr<SentenceJudge> judge_;
    std::vector<std::string> things_;
};

}  // namespace fulcrum::dialogue
