#include "dialogue/checking/unread.h"

#include <algorithm>
#include <cstddef>

namespace fulcrum::dialogue {
namespace {

constexpr int kFewWords = 3;  // a title, a call

/// Some word of [first, last) is a verb that may be finite.
bool has_verb(const FreeSentence& sentence, int first, int last) {
    for (int i = first; i < last; ++i) {
        const FreeWord& word = sentence[i];
        const bool helps = sentence.be_at(i) || sentence.is(i, {"do", "does", "did", "have", "has",
                                                                "can", "must", "will", "may"});
        if (helps ||
            (!word.closed && word.verb_count > word.adjective_count && !word.mainly_noun())) {
            return true;
        }
    }
    return false;
}

/// The word at `i` stands behind a colon.
bool is_behind_colon(const FreeSentence& sentence, int i, std::string_view text) {
    return text.substr(sentence[i - 1].end, sentence[i].begin - sentence[i - 1].end).find(':') !=
           std::string_view::npos;
}

}  // namespace

std::string for_judge(const FreeSentence& sentence, int first, std::string text) {
    const FreeWord& word = sentence[first];
    if (word.capital && word.text != "i" && (word.closed || word.known) && !text.empty() &&
        text[0] >= 'A' && text[0] <= 'Z') {
        text[0] = static_cast<char>(text[0] - 'A' + 'a');
    }
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text + (sentence.asks() ? "?" : ".");
}

std::string find_unread(SentenceJudge& judge, const std::vector<FreeSentence>& sentences,
                        std::string_view text) {
    for (const FreeSentence& sentence : sentences) {
        for (int first = 0, last = 0; first < sentence.size(); first = last) {
            last = first + 1;
            while (last < sentence.size() && !is_behind_colon(sentence, last, text)) {
                ++last;
            }
            if (last - first <= kFewWords || !has_verb(sentence, first, last)) {
                continue;
            }
            const std::size_t begin = sentence[first].begin;
            std::string clause(text.substr(begin, sentence[last - 1].end - begin));
            // "Mars" is a known word too, of which a judge with a small letter knows nothing.
            const bool is_read = judge.misfits(for_judge(sentence, first, clause)).value_or(0) == 0;
            if (!is_read && judge.misfits(clause + (sentence.asks() ? "?" : ".")).value_or(0) > 0) {
                return clause;
            }
        }
    }
    return {};
}

}  // namespace fulcrum::dialogue
