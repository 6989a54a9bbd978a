#include "dialogue/checking/author_slips.h"
#include "dialogue/checking/checker.h"
#include "dialogue/checking/corrections.h"
#include "dialogue/checking/noun_phrases.h"
#include "dialogue/checking/proposal.h"
#include "dialogue/checking/reading.h"
#include "dialogue/checking/unread.h"
#include "tests/unit/dialogue/checking/checked.h"
#include "tests/unit/dialogue/rig.h"

#include <rapidcheck.h>

using namespace fulcrum::dialogue;

namespace {

void require_whole(std::string_view text, const CheckedText& result) {
    std::size_t at = 0;
    for (const FreeError& error : result.errors) {
        RC_ASSERT(error.code != ErrorCode::none);
        RC_ASSERT(error.begin <= error.end);
        RC_ASSERT(error.end <= text.size());
        RC_ASSERT(at <= error.begin);
        RC_ASSERT(error.said == text.substr(error.begin, error.end - error.begin));
        at = error.end;
    }
}

Proposal put(std::size_t begin, std::size_t end, const char* right,
             ErrorCode code = ErrorCode::agreement) {
    return {code, begin, end, right};
}

std::string mended(std::string_view text, const std::vector<Proposal>& proposals) {
    return carried_out(text, 0, text.size(), proposals);
}

// Finds no place for a word of what has "zig" in it, and keeps what it was asked.
class ZigJudge final : public SentenceJudge {
  public:
    std::optional<int> misfits(std::string_view sentence) override {
        asked.emplace_back(sentence);
        return sentence.find("zig") == std::string_view::npos ? 0 : 1;
    }
    std::vector<std::string> asked;
};

std::string unread(SentenceJudge& judge, std::string_view text) {
    const auto lexicon = Lexicon::open();
    REQUIRE(lexicon);
    return find_unread(judge, read_sentences(*lexicon, text), text);
}

}  // namespace

TEST_CASE("checker: a word that is missing stands alone where its noun follows, and no verb does") {
    EnglishChecker checker = words_alone();
    checker.set_things({"tail"});
    const auto alone = [&](std::string_view text) {
        const CheckedText checked = checker.check(text);
        return !checked.errors.empty() && checked.errors.front().alone;
    };
    CHECK(alone("It have wings."));
    CHECK(alone("It needs tail."));
    CHECK_FALSE(alone("It needs longer tail."));
    CHECK_FALSE(alone("It heavy."));
    CHECK_FALSE(alone("Is very heavy."));
}

TEST_CASE("checker: several errors of a text, each at its place") {
    EnglishChecker checker = words_alone();
    const CheckedText result = checker.check("It have a moon.");
    REQUIRE(result.errors.size() == 1);
    CHECK(result.errors[0].begin == 3);
    CHECK(result.errors[0].end == 7);
    CHECK(result.errors[0].said == "have");
    CHECK(result.errors[0].right == "has");
    CHECK(result.corrected == "It has a moon.");
}

TEST_CASE("checker: what one error hides is found when that one is mended") {
    EnglishChecker checker = words_alone();
    checker.set_things({"tail", "kite"});
    const CheckedText result = checker.check("it need more longer tail");
    CHECK(result.marked == "it *needs* *a* *longer* tail");
    CHECK(result.settled);
    REQUIRE(result.errors.size() == 3);
    CHECK(result.errors[1].begin == 8);
    CHECK(result.errors[2].said == "more longer");
    CHECK_FALSE(result.proven);
}

TEST_CASE("checker: nobody proves what no judge can tell") {
    EnglishChecker checker = words_alone();
    CHECK(checker.advise("It have a moon.").errors.size() == 1);
    CHECK_FALSE(checker.advise("It have a moon.").proven);
}

TEST_CASE("checker: two that only a judge can tell are found together") {
    EnglishChecker checker(opened_lexicon(),
                           std::make_unique<ToldJudge>(std::map<std::string, int, std::less<>>{
                               {"I saw moon near planet.", 2},
                               {"I saw a moon near planet.", 1},
                               {"I saw moon near a planet.", 1},
                               {"I saw a moon near a planet.", 0}}));
    const CheckedText result = checker.advise("I saw moon near planet.");
    CHECK(result.corrected == "I saw a moon near a planet.");
    CHECK(result.proven);
}

TEST_CASE(
    "checker: a missing article is marked where the judge finds the sentence better with it") {
    const auto judged = [](int without, int with) {
        EnglishChecker checker(opened_lexicon(),
                               std::make_unique<ToldJudge>(std::map<std::string, int, std::less<>>{
                                   {"I saw moon.", without}, {"I saw a moon.", with}}));
        return checker.check("I saw moon.").corrected;
    };
    CHECK(judged(1, 0) == "I saw a moon.");
    CHECK(judged(0, 0) == "I saw moon.");
    CHECK(judged(2, 1) == "I saw moon.");
    // The words alone do not tell.
    CHECK(words_alone().check("I saw moon.").errors.empty());
}

TEST_CASE("checker: what isn't English, or no text at all, is left as it is") {
    for (const std::string& text :
         {std::string{}, std::string(" \n\t"), std::string("수박이 제일 무거워요"),
          std::string("\x00\x01\x7f\x1b[31m", 8), std::string("\xff\xfe\xc3"),
          std::string("Ça va très bien."), std::string("%s%n{}*…*")}) {
        CHECK(words_alone().check(text).errors.empty());
        CHECK(words_alone().check(text).corrected == text);
    }
}

TEST_CASE("checker: of ten megabytes the beginning is looked at and all is kept") {
    std::string text = "it have two moon. ";
    while (text.size() < 10'000'000) {
        text += "it have two moon ";
    }
    EnglishChecker checker = words_alone();
    const CheckedText result = checker.check(text);
    CHECK(result.errors.size() ==
          2);  // what has no end within the first thousand bytes is too long
    CHECK(result.corrected.size() == text.size() - 4 + 3 + 1);
    CHECK(result.corrected.ends_with("it have two moon "));
}

TEST_CASE("checker: any bytes give errors in order within them, and nothing between them is lost") {
    CHECK(rc::check([](const std::string& text) {
        static EnglishChecker checker = words_alone();
        const CheckedText result = checker.check(text);
        require_whole(text, result);
        RC_ASSERT(!result.errors.empty() || result.corrected == text);
    }));
}

TEST_CASE("checker: any words give errors in order within them") {
    static const std::vector<std::string> kWords = {
        "it",    "they",  "I",     "is",    "are",     "have", "has",  "the",  "a",      "an",
        "apple", "moons", "moon",  "heavy", "heavier", "most", "more", "than", "then",   "made",
        "of",    "metal", "two",   "there", "why",     "?",    ".",    ",",    "very",   "hardly",
        "this",  "these", "feels", "like",  "one",     "be",   "not",  "what", "Jupiter"};
    CHECK(rc::check([] {
        static EnglishChecker checker = words_alone();
        std::string text;
        const int n_words = *rc::gen::inRange(0, 14);
        for (int i = 0; i < n_words; ++i) {
            text += *rc::gen::elementOf(kWords) + " ";
        }
        require_whole(text, checker.check(text));
    }));
}

TEST_CASE("author slips: a review tells them, and what is said to learners does not") {
    EnglishChecker checker = words_alone();
    checker.set_things({"block", "ball", "apple"});
    const CheckedText review = checker.review("The wooden block float.");
    REQUIRE(review.errors.size() == 1);
    CHECK(review.errors[0].right == "floats");
    CHECK_FALSE(review.proven);
    CHECK(checker.advise("The wooden block float.").errors.empty());
    CHECK(checker.review("Why float the block?").unread == "Why float the block");
}

TEST_CASE("corrections: carried out in the text's order, with blanks outside the marks") {
    const std::vector<Proposal> two = {put(8, 8, "a "), put(3, 7, "has")};
    CHECK(mended("it have tail", two) == "it has a tail");
    CHECK(carried_out("it have tail", 0, 12, two, "*") == "it *has* *a* tail");
    CHECK(carried_out("it have tail", 3, 7, {two[1]}) == "has");
}

TEST_CASE("corrections: what is mended in the outcome is told of the text") {
    // "it needs tail" got its article behind the verb that was mended.
    const std::string text = "it need tail";
    const auto both = joined(text, {put(3, 7, "needs")}, {put(9, 9, "a ")});
    REQUIRE(both.size() == 2);
    CHECK(both[1].begin == 8);
    CHECK(both[1].end == 8);
    CHECK(mended(text, both) == "it needs a tail");
    // Before a place that was mended, and a verb in front of another correction.
    const auto in_front = joined("it more heavy", {put(3, 13, "heavier")}, {put(3, 3, "is ")});
    CHECK(mended("it more heavy", in_front) == "it is heavier");
    CHECK(in_front.size() == 2);
}

TEST_CASE("corrections: two at one place are one, of the first one's kind") {
    const std::string text = "it is push";
    const auto one = joined(text, {put(3, 6, "", ErrorCode::verb_form)},
                            {put(3, 7, "pushes", ErrorCode::agreement)});
    REQUIRE(one.size() == 1);
    CHECK(one[0].code == ErrorCode::verb_form);
    CHECK(one[0].begin == 3);
    CHECK(one[0].end == 10);
    CHECK(one[0].right == "pushes");
    // Two rules that undo each other say nothing.
    CHECK(joined("a b", {put(2, 3, "c")}, {put(2, 3, "b")}).empty());
}

TEST_CASE("corrections: joined, they make of the text what they made of it one after the other") {
    CHECK(rc::check([] {
        const auto text = *rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab ")));
        const auto any = [](std::string_view of) {
            std::vector<Proposal> list;
            std::size_t at = 0;
            while (at <= of.size() && list.size() < 4) {
                const std::size_t begin = at + *rc::gen::inRange<std::size_t>(0, 4);
                const std::size_t end = begin + *rc::gen::inRange<std::size_t>(0, 4);
                if (end > of.size()) {
                    break;
                }
                list.push_back(put(begin, end, *rc::gen::element("", "x", "yz ", "a")));
                at = end + 1;
            }
            return list;
        };
        const std::vector<Proposal> first = any(text);
        const std::string outcome = mended(text, first);
        const std::vector<Proposal> then = any(outcome);
        const std::vector<Proposal> both = joined(text, first, then);
        RC_ASSERT(mended(text, both) == mended(outcome, then));
        for (std::size_t i = 1; i < both.size(); ++i) {
            RC_ASSERT(both[i - 1].end <= both[i].begin);
        }
    }));
}

TEST_CASE("noun phrases: a noun phrase ends with its head") {
    const FreeSentence sentence = only_sentence("the big red apples are here");
    const NounPhrase phrase = noun_phrase_at(sentence, 0);
    CHECK(phrase.head == 3);
    CHECK(phrase.last == 4);
    CHECK(phrase.determined);
    CHECK(phrase.number == Number::plural);
    const NounPhrase none = noun_phrase_at(sentence, 4);
    CHECK(none.first == none.last);
    CHECK(noun_phrase_at(only_sentence("this feels rough"), 0).last == 0);
}

TEST_CASE("noun phrases: a planet ends with its name, whatever stands behind it") {
    CHECK(name_end(only_sentence("Jupiter moons are many"), 0) == 1);
    CHECK(name_end(only_sentence("the two planets turn"), 0) == 3);
    CHECK(name_end(only_sentence("is it heavy"), 0) == 0);
    CHECK(name_end(only_sentence("the egg"), 2) == 2);
}

TEST_CASE("proposal: capitals and blanks go with the words") {
    static const Lexicon lexicon = opened_lexicon();
    const auto sentences = read_sentences(lexicon, "These rock's it there's.");
    Proposals proposals(sentences.front());
    proposals.replace(0, ErrorCode::wrong_determiner, "this");
    proposals.replace(1, ErrorCode::extra_determiner, "");
    proposals.insert(1, ErrorCode::missing_determiner, "the");
    const auto list = proposals.take();
    REQUIRE(list.size() == 3);
    CHECK(list[0].right == "This");
    CHECK(list[0].begin == 0);
    CHECK(list[0].end == 5);
    CHECK(list[1].right.empty());
    CHECK(list[2].right == "the ");
    CHECK(list[2].begin == list[2].end);
}

TEST_CASE("reading: what each word can be") {
    const FreeSentence sentence = only_sentence("The mice feel heavier things here");
    CHECK(sentence[0].closed);
    CHECK(sentence[1].plural_noun());
    CHECK(sentence[1].singular == "mouse");
    CHECK(sentence[2].verb == "feel");
    CHECK(sentence[2].verb_plain);
    CHECK(sentence[3].adjective == "heavy");
    CHECK(sentence[3].degree == Degree::comparative);
    CHECK(sentence[4].singular == "thing");
    CHECK_FALSE(sentence[4].can_be_singular);
    CHECK(sentence[9].text.empty());
    CHECK(sentence[-1].text.empty());
}

TEST_CASE("reading: sentences, clauses and stops") {
    static const Lexicon lexicon = opened_lexicon();
    const auto sentences = read_sentences(lexicon, "Is it? No, but I think that it moves!");
    REQUIRE(sentences.size() == 2);
    CHECK(sentences[0].asks());
    CHECK_FALSE(sentences[1].asks());
    CHECK(sentences[1][0].before_stop);
    CHECK(sentences[1].clause_begins(2));
    CHECK(sentences[1].clause_begins(5));
    CHECK_FALSE(sentences[1].clause_begins(3));
    CHECK(read_sentences(lexicon, "").empty());
    CHECK(read_sentences(lexicon, " .?! ").empty());
}

TEST_CASE("reading: an apostrophe s is a verb behind a pronoun and an owner's behind a noun") {
    CHECK_FALSE(only_sentence("it's big")[1].possessive);
    CHECK(only_sentence("the moon's side")[2].possessive);
}

TEST_CASE("unread: the first clause that the judge has no place for, as it stands there") {
    ZigJudge judge;
    CHECK(unread(judge, "It is heavy. Lift it: it goes zig with you! Here it is zig too.") ==
          "it goes zig with you");
    CHECK(judge.asked ==
          std::vector<std::string>{"it goes zig with you.", "it goes zig with you."});
    CHECK(unread(judge, "It is heavy here.").empty());
    CHECK(unread(judge, "").empty());
}

TEST_CASE("unread: a title, a call and what has no verb are no clauses") {
    ZigJudge judge;
    CHECK(unread(judge, "Lift the zig! The long and narrow zig for the Earth. Which zig?").empty());
    CHECK(judge.asked.empty());
}
