#include "dialogue/checking/proposal.h"

#include "dialogue/english/letters.h"

namespace fulcrum::dialogue {

void Proposals::replace(int first, int last, ErrorCode code, std::string_view right,
                        Certainty certainty) {
    const FreeSentence& sentence = *sentence_;
    std::size_t end = sentence[last - 1].end;
    if (right.empty() && last < sentence.size()) {
        end = sentence[last].begin;
    }
    std::string text(right);
    const bool at_start = first == 0 || sentence[first].written == "I";
    if (!text.empty() && at_start && sentence[first].capital) {
        text = sentence_case(text);
    }
    if (sentence[first].written.starts_with('\'')) {
        text.insert(0, " ");  // "there's" -> "there are"
    }
    list_.push_back({code, sentence[first].begin, end, std::move(text), certainty});
}

void Proposals::insert(int i, ErrorCode code, std::string_view missing, Certainty certainty) {
    const FreeWord& word = (*sentence_)[i];
    // At the start the capital goes over to what was missing, unless the word has one of its own.
    if (i == 0 && word.capital && word.written != "I" && word.written.size() > 1 &&
        (word.closed || word.noun_count + word.adjective_count >= kPlainWord)) {
        list_.push_back({code, word.begin, word.end,
                         sentence_case(missing) + " " + lower_case(word.written), certainty});
        return;
    }
    const std::size_t at = word.begin;
    list_.push_back({code, at, at, std::string(missing) + " ", certainty});
}

}  // namespace fulcrum::dialogue
