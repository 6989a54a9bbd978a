#include "dialogue/checking/checker.h"

#include "dialogue/checking/proposal.h"
#include "dialogue/english/letters.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace fulcrum::dialogue {
namespace {

/// Two that change the same place, or stand at the same place.
bool meet(const Proposal& a, const Proposal& b) {
    return a.begin <= b.end && b.begin <= a.end &&
           (a.begin < b.end || b.begin < a.end || a.begin == b.begin);
}

bool meets_any(const std::vector<Proposal>& list, const Proposal& proposal) {
    return std::any_of(list.begin(), list.end(),
                       [&](const Proposal& other) { return meet(other, proposal); });
}

/// Bytes [begin, end) of `text` with the proposals in it carried out, each between two `mark`s.
std::string carried_out(std::string_view text, std::size_t begin, std::size_t end,
                        std::vector<Proposal> proposals, std::string_view mark = {}) {
    std::sort(proposals.begin(), proposals.end(),
              [](const Proposal& a, const Proposal& b) { return a.begin < b.begin; });
    std::string result;
    std::size_t at = begin;
    for (const Proposal& proposal : proposals) {
        result.append(text.substr(at, proposal.begin - at));
        // Blanks stand outside the marks.
        std::string_view right = proposal.right;
        const bool apart = right.starts_with(' ');
        right.remove_prefix(apart ? 1 : 0);
        const bool spaced = right.ends_with(' ');
        right.remove_suffix(spaced ? 1 : 0);
        result.append(apart ? " " : "");
        if (!right.empty()) {
            result.append(mark).append(right).append(mark);
        }
        result.append(spaced ? " " : "");
        at = proposal.end;
    }
    return result.append(text.substr(at, end - at));
}

/// The sentence as a judge reads it: one that begins with a common word begins small, and has a stop.
std::string for_judge(const FreeSentence& sentence, std::string text) {
    const FreeWord& first = sentence[0];
    if (first.capital && first.text != "i" && (first.closed || first.known) && !text.empty() &&
        text[0] >= 'A' && text[0] <= 'Z') {
        text[0] = static_cast<char>(text[0] - 'A' + 'a');
    }
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text + (sentence.asks() ? "?" : ".");
}

std::vector<Proposal> propose(const Lexicon& lexicon, const FreeSentence& sentence) {
    Proposals proposals(sentence);
    find_comparison_errors(lexicon, sentence, proposals);
    find_order_errors(sentence, proposals);
    find_missing_words(sentence, proposals);
    find_making_errors(sentence, proposals);
    find_agreement_errors(sentence, proposals);
    find_number_errors(lexicon, sentence, proposals);
    find_article_errors(sentence, proposals);
    return proposals.take();
}

/// The proposals that hold, none over another.
std::vector<Proposal> decide(const Lexicon& lexicon, SentenceJudge& judge,
                             const FreeSentence& sentence, std::string_view text) {
    const std::vector<Proposal> proposals = propose(lexicon, sentence);
    std::vector<Proposal> taken;
    for (const Proposal& proposal : proposals) {
        if (proposal.certainty == Certainty::sure && !meets_any(taken, proposal)) {
            taken.push_back(proposal);
        }
    }
    const std::size_t begin = sentence[0].begin;
    const std::size_t end = sentence[sentence.size() - 1].end;
    std::optional<int> misfits;
    for (const Proposal& proposal : proposals) {
        if (proposal.certainty != Certainty::asked || meets_any(taken, proposal)) {
            continue;
        }
        if (!misfits) {
            misfits = judge.misfits(for_judge(sentence, carried_out(text, begin, end, taken)));
        }
        if (!misfits || *misfits == 0) {
            break;  // it can't tell, or all is well
        }
        std::vector<Proposal> with = taken;
        with.push_back(proposal);
        const auto then = judge.misfits(for_judge(sentence, carried_out(text, begin, end, with)));
        if (then && *then == 0) {
            return with;  // now all of it fits
        }
    }
    return taken;
}

}  // namespace

CheckedText EnglishChecker::check(std::string_view text) {
    CheckedText checked;
    std::vector<Proposal> all;
    for (const FreeSentence& sentence : read_sentences(lexicon_, text, things_)) {
        if (sentence.size() > kMostFreeWords) {
            continue;
        }
        for (Proposal& proposal : decide(lexicon_, *judge_, sentence, text)) {
            all.push_back(std::move(proposal));
        }
    }
    std::sort(all.begin(), all.end(),
              [](const Proposal& a, const Proposal& b) { return a.begin < b.begin; });
    for (const Proposal& proposal : all) {
        const std::string_view said = text.substr(proposal.begin, proposal.end - proposal.begin);
        checked.errors.push_back(
            {proposal.code, proposal.begin, proposal.end, std::string(said), proposal.right});
    }
    checked.corrected = carried_out(text, 0, text.size(), all);
    checked.marked = carried_out(text, 0, text.size(), all, "*");
    return checked;
}

}  // namespace fulcrum::dialogue
