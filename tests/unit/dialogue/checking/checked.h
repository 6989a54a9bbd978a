// A checker for tests: the words alone decide, or a judge whose verdicts a test names.
#pragma once

#include "dialogue/checking/checker.h"
#include "dialogue/checking/reading.h"
#include "tests/unit/dialogue/rig.h"

namespace fulcrum::dialogue {

/// Knows the sentences that it was told, each with its misfits; of others it can't tell.
class ToldJudge final : public SentenceJudge {
  public:
    explicit ToldJudge(std::map<std::string, int, std::less<>> told) : told_(std::move(told)) {}
    std::optional<int> misfits(std::string_view sentence) override {
        const auto found = told_.find(sentence);
        return found == told_.end() ? std::nullopt : std::optional<int>(found->second);
    }

  private:
    std::map<std::string, int, std::less<>> told_;
};

inline Lexicon opened_lexicon() {
    auto lexicon = Lexicon::open();
    if (!lexicon) {
        throw std::runtime_error(lexicon.error().message);
    }
    return std::move(*lexicon);
}

/// The sentence that a text of one sentence has, as the words alone tell.
inline FreeSentence only_sentence(const std::string& text) {
    static const Lexicon lexicon = opened_lexicon();
    auto sentences = read_sentences(lexicon, text);
    REQUIRE(sentences.size() == 1);
    return std::move(sentences.front());
}

inline EnglishChecker words_alone() {
    return {opened_lexicon(), std::make_unique<NullJudge>()};
}

}  // namespace fulcrum::dialogue
