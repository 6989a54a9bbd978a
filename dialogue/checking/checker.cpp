#include "dialogue/checking/checker.h"

#include "dialogue/checking/author_slips.h"
#include "dialogue/checking/corrections.h"
#include "dialogue/checking/doubts.h"
#include "dialogue/checking/proposal.h"
#include "dialogue/checking/unread.h"
#include "dialogue/english/letters.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace fulcrum::dialogue {
namespace {

constexpr int kMostRounds = 4;  // of mending; what isn't right then never will be

/// Two that change the same place, or stand at the same place.
bool meet(const Proposal& a, const Proposal& b) {
    return a.begin <= b.end && b.begin <= a.end &&
           (a.begin < b.end || b.begin < a.end || a.begin == b.begin);
}

bool meets_any(const std::vector<Proposal>& list, const Proposal& proposal) {
    return std::any_of(list.begin(), list.end(),
                       [&](const Proposal& other) { return meet(other, proposal); });
}

std::vector<Proposal> propose(const Lexicon& lexicon, const FreeSentence& sentence) {
    Proposals proposals(sentence);
    find_comparison_errors(lexicon, sentence, proposals);
    find_order_errors(sentence, proposals);
    find_missing_words(sentence, proposals);
    find_verbless_clauses(sentence, proposals);
    find_making_errors(sentence, proposals);
    find_agreement_errors(sentence, proposals);
    find_verb_form_errors(sentence, proposals);
    find_number_errors(lexicon, sentence, proposals);
    find_article_errors(sentence, proposals);
    find_place_errors(sentence, proposals);
    return proposals.take();
}

/// One sentence, before its judge.
class Trial {
  public:
    Trial(SentenceJudge& judge, const FreeSentence& sentence, std::string_view text)
        : judge_(judge), sentence_(sentence), text_(text) {}

    /// The misfits of the sentence with these carried out.
    std::optional<int> misfits(const std::vector<Proposal>& proposals) {
        return judge_.misfits(
            for_judge(sentence_, 0,
                      carried_out(text_, sentence_[0].begin, sentence_[sentence_.size() - 1].end,
                                  proposals)));
    }

  private:
    SentenceJudge& judge_;
    const FreeSentence& sentence_;
    std::string_view text_;
};

/// Of `asked` the one that makes all of it fit, or several that do so together, and `taken`; `taken` alone where none do.
std::vector<Proposal> ask(Trial& trial, const std::vector<Proposal>& taken,
                          const std::vector<Proposal>& asked) {
    const auto misfits = asked.empty() ? std::nullopt : trial.misfits(taken);
    if (!misfits || *misfits == 0) {
        return taken;  // it can't tell, or all is well
    }
    std::vector<Proposal> better;
    for (const Proposal& proposal : asked) {
        std::vector<Proposal> with = taken;
        with.push_back(proposal);
        const auto then = trial.misfits(with);
        if (then && *then == 0) {
            return with;  // now all of it fits
        }
        if (then && *then < *misfits) {
            better.push_back(proposal);
        }
    }
    // "I put apple on table" fits only when both are mended.
    std::vector<Proposal> together = taken;
    for (const Proposal& proposal : better) {
        if (!meets_any(together, proposal)) {
            together.push_back(proposal);
        }
    }
    return better.size() > 1 && trial.misfits(together) == 0 ? together : taken;
}

/// The proposals that hold, none over another.
std::vector<Proposal> decide(const Lexicon& lexicon, SentenceJudge& judge,
                             const FreeSentence& sentence, std::string_view text) {
    std::vector<Proposal> taken;
    std::vector<Proposal> asked;
    for (Proposal& proposal : propose(lexicon, sentence)) {
        const bool sure = proposal.certainty == Certainty::sure;
        if (!sure || !meets_any(taken, proposal)) {
            (sure ? taken : asked).push_back(std::move(proposal));
        }
    }
    std::erase_if(asked, [&](const Proposal& proposal) { return meets_any(taken, proposal); });
    Trial trial(judge, sentence, text);
    return ask(trial, taken, asked);
}

/// What is wrong in `text` as it stands, in its order.
std::vector<Proposal> find_once(const Lexicon& lexicon, SentenceJudge& judge, std::string_view text,
                                const std::vector<std::string>& things) {
    std::vector<Proposal> all;
    for (const FreeSentence& sentence : read_sentences(lexicon, text, things)) {
        if (sentence.size() > kMostFreeWords) {
            continue;
        }
        for (Proposal& proposal : decide(lexicon, judge, sentence, text)) {
            all.push_back(std::move(proposal));
        }
    }
    return all;
}

/// Whether `proposal` is right can be told though the rest of `sentences` may be none: a verb and a pronoun are missing in a sentence
/// only, and an article before a noun.
bool stands_alone(const Proposal& proposal, const std::vector<FreeSentence>& sentences) {
    switch (proposal.code) {
        case ErrorCode::missing_verb:
        case ErrorCode::missing_pronoun:
        case ErrorCode::extra_pronoun:
        case ErrorCode::word_order:
            return false;
        case ErrorCode::missing_determiner:
            break;
        default:
            return true;
    }
    for (const FreeSentence& sentence : sentences) {
        for (int i = 0; i < sentence.size(); ++i) {
            if (sentence[i].begin >= proposal.begin) {
                return sentence[i].thing || sentence[i].mainly_noun();
            }
        }
    }
    return false;
}

/// Nobody doubts a sentence of `text`: no rule, not even one that a judge overruled, and the judge of all of it.
bool is_sound(const Lexicon& lexicon, SentenceJudge& judge, std::string_view text,
              const std::vector<std::string>& things) {
    const std::vector<FreeSentence> sentences = read_sentences(lexicon, text, things);
    return std::all_of(sentences.begin(), sentences.end(), [&](const FreeSentence& sentence) {
        return sentence.size() <= kMostFreeWords && !is_doubtful(sentence) &&
               propose(lexicon, sentence).empty() && Trial(judge, sentence, text).misfits({}) == 0;
    });
}

}  // namespace

CheckedText EnglishChecker::check(std::string_view text) {
    // What one error hides is found when that one is mended.
    const std::string_view head = text.substr(0, kLongestFreeText_bytes);
    std::vector<Proposal> all = find_once(lexicon_, *judge_, head, things_);
    bool settled = all.empty();
    for (int round = 1; round < kMostRounds && !settled; ++round) {
        const std::string so_far = carried_out(head, 0, head.size(), all);
        std::vector<Proposal> more = find_once(lexicon_, *judge_, so_far, things_);
        settled = more.empty();
        all = joined(head, std::move(all), std::move(more));
    }
    CheckedText checked;
    const std::vector<FreeSentence> sentences =
        all.empty() ? std::vector<FreeSentence>{} : read_sentences(lexicon_, head, things_);
    for (const Proposal& proposal : all) {
        const std::string_view said = head.substr(proposal.begin, proposal.end - proposal.begin);
        checked.errors.push_back({proposal.code, proposal.begin, proposal.end, std::string(said),
                                  proposal.right, stands_alone(proposal, sentences)});
    }
    checked.corrected = carried_out(text, 0, text.size(), all);
    checked.marked = carried_out(text, 0, text.size(), all, "*");
    checked.settled = settled;
    return checked;
}

CheckedText EnglishChecker::advise(std::string_view text) {
    CheckedText checked = check(text);
    checked.proven = checked.settled && text.size() <= kLongestFreeText_bytes &&
                     is_sound(lexicon_, *judge_, checked.corrected, things_);
    return checked;
}

CheckedText EnglishChecker::review(std::string_view text) {
    CheckedText checked = advise(text);
    if (!checked.errors.empty()) {
        return checked;
    }
    const std::string_view head = text.substr(0, kLongestFreeText_bytes);
    const std::vector<FreeSentence> sentences = read_sentences(lexicon_, head, things_);
    checked.errors = find_author_slips(sentences, head);
    if (!checked.errors.empty()) {
        checked.proven = false;  // the words that are to be others may fit in some other sentence
        return checked;
    }
    checked.unread = find_doubtful_question(sentences, head);
    if (!checked.proven && checked.unread.empty()) {
        checked.unread = find_unread(*judge_, sentences, head);
    }
    return checked;
}

}  // namespace fulcrum::dialogue
