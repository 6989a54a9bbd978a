#include "dialogue/checking/proposal.h"

#include "dialogue/english/letters.h"

#include <algorithm>
#include <array>

namespace fulcrum::dialogue {
namespace {

/// Word `i` is the n't of the word before it.
bool is_contracted(const FreeSentence& sentence, int i) {
    return sentence.is(i, {"not"}) && sentence[i].begin == sentence[i - 1].end;
}

/// "it is" -> "it isn't", "am" -> "am not"; false where no verb that takes it stands in `text`.
bool with_contraction(std::string& text) {
    constexpr std::array<std::string_view, 9> kVerbs = {"is", "are", "was", "were", "does",
                                                        "do", "did", "has", "have"};
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        if (text.compare(at, end - at, "am") == 0) {
            text.insert(end, " not");
            return true;
        }
        if (std::find(kVerbs.begin(), kVerbs.end(), lower_case(text.substr(at, end - at))) !=
            kVerbs.end()) {
            text.insert(end, "n't");
            return true;
        }
        at = end + 1;
    }
    return false;
}

}  // namespace

void Proposals::replace(int first, int last, ErrorCode code, std::string_view right,
                        Certainty certainty) {
    const FreeSentence& sentence = *sentence_;
    std::size_t end = sentence[last - 1].end;
    if (right.empty() && last < sentence.size()) {
        end = sentence[last].begin;
    }
    std::string text(right);
    if (is_contracted(sentence, last)) {
        end = with_contraction(text) ? sentence[last].end : end;
    }
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
