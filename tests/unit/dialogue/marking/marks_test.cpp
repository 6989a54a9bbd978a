#include "dialogue/marking/mark_answer.h"
#include "dialogue/marking/mark_sentence.h"
#include "dialogue/marking/meanings.h"
#include "dialogue/marking/readings.h"
#include "dialogue/marking/said_parts.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/rig.h"
#include "tests/unit/dialogue/wrong_sentences.h"

using namespace fulcrum::dialogue;

namespace {

Question moons_of_earth() {
    return compiled({"moons",
                     "How many moons does the Earth have?",
                     {"the Earth has {number} <plural:moon>"},
                     {{"number", {"no|none", "one|a|an", "two"}}}});
}

Meanings of(const std::vector<std::string>& answers, const NamedLists& lists,
            std::size_t most = 100) {
    return meanings_of(compiled({"q", "Which one?", answers, lists}), most);
}

bool has(const Meanings& meanings, const std::string& said) {
    return std::ranges::any_of(meanings.some,
                               [&](const Meaning& meaning) { return meaning.said == said; });
}

const NamedLists kTwo{{"thing", {"egg", "rock"}}, {"kind", {"big", "small", "red"}}};

}  // namespace

TEST_CASE("mark: an error has its place, its words and what belongs there") {
    const std::string said = "So, a apple is most heavy";
    const Mark mark = mark_answer(heaviest(), said);
    REQUIRE(mark.form_errors.size() == 3);
    const FormError& article = mark.form_errors[0];
    CHECK(said.substr(article.begin, article.end - article.begin) == "a");
    CHECK(article.said == "a");
    CHECK(article.right == "an");
    CHECK(article.phrase == "an apple");
    CHECK_FALSE(article.target);
    const FormError& missing = mark.form_errors[1];
    CHECK(missing.said.empty());
    CHECK(missing.begin == missing.end);
    CHECK(said.substr(missing.begin, 4) == "most");
    CHECK(missing.target);
    const FormError& adjective = mark.form_errors[2];
    CHECK(said.substr(adjective.begin, adjective.end - adjective.begin) == "most heavy");
    CHECK(adjective.right == "heaviest");
    CHECK(adjective.phrase == "the heaviest");
    CHECK(adjective.base == "heavy");
    CHECK(mark.main_error() == &adjective);
    CHECK_FALSE(mark.target_right());
    CHECK(mark.other_errors() == 1);
    CHECK(mark.emphasis == "the heaviest");
    CHECK(mark.gapped == "An apple is …");
}

TEST_CASE("mark: a confidence is kept and decides nothing here") {
    CHECK(mark_answer(heaviest(), "watermelon", 0.1).confidence == 0.1);
    CHECK(mark_answer(heaviest(), "watermelon", 0.1).understood);
}

TEST_CASE("mark: an overlong answer is not understood and not kept whole") {
    const Mark mark = mark_answer(heaviest(), std::string(10'000'000, 'a'));
    CHECK_FALSE(mark.understood);
    CHECK(mark.said.size() <= 1000);
}

TEST_CASE("determiners: no way through a question's graphs has two side by side") {
    std::vector<Question> questions = all_questions();
    questions.push_back(moons_of_earth());
    for (const Question& question : questions) {
        for (const Graph& graph : question.templates->graphs) {
            CHECK(right_doubled_determiner(*question.templates, graph).empty());
        }
    }
}

TEST_CASE("determiners: one or two labelled errors are said back in a right sentence") {
    int n_tried = 0;
    std::vector<Question> questions = all_questions();
    questions.push_back(moons_of_earth());
    for (const Question& question : questions) {
        INFO(question.id);
        CHECK(wrong_recasts(question, n_tried) == "");
    }
    CHECK(n_tried > 2000);
}

TEST_CASE("meanings: each word of each list, with and without what may be left out") {
    const Meanings all = of({"the {thing} is [very] {kind}"}, kTwo);
    CHECK(all.all);
    CHECK(all.some.size() == 6);
    CHECK(has(all, "The rock is red."));
    const Meanings may = of({"the {thing} is here [and {kind}]"}, kTwo);
    CHECK(may.all);
    CHECK(may.some.size() == 8);
    CHECK(has(may, "The rock is here."));
    CHECK(has(may, "The rock is here and red."));
}

TEST_CASE(
    "meanings: what two answers both mean comes once, and an answer without slots means one") {
    CHECK(
        of({"the {thing} is big", "it is the {thing}"}, {{"thing", {"egg", "rock"}}}).some.size() ==
        2);
    const Meanings plain = of({"it is big"}, {});
    REQUIRE(plain.some.size() == 1);
    CHECK(plain.some[0].slots.empty());
    CHECK(plain.some[0].said == "It is big.");
    CHECK(plain.all);
}

TEST_CASE("meanings: where there are too many each word comes at least") {
    NamedLists many{{"one", {}}, {"two", {}}};
    for (int i = 0; i < 40; ++i) {
        many[0].second.push_back("a" + std::string(1, static_cast<char>('a' + i % 26)) +
                                 std::to_string(i));
        many[1].second.push_back("b" + std::to_string(i));
    }
    const Meanings some = of({"{one} and {two}"}, many, 10);
    CHECK_FALSE(some.all);
    CHECK(some.some.size() == 79);
}

TEST_CASE("readings: most answers have one, which is what they say") {
    Mark mark = mark_answer(heaviest(), "the egg is the heaviest");
    REQUIRE(readings_of(mark).size() == 1);
    CHECK(readings_of(mark)[0] == mark.slots);
    CHECK(settle(mark, {true}));
    CHECK_FALSE(settle(mark, {false}));
    CHECK_FALSE(settle(mark, {}));
}

TEST_CASE("readings: what is denied is true where the same is wrong") {
    Mark mark = mark_answer(heaviest(), "the egg is not the heaviest");
    REQUIRE(readings_of(mark).size() == 1);
    CHECK(settle(mark, {false}));
    CHECK_FALSE(settle(mark, {true}));
    CHECK(mark.slot("thing") == "egg");
    // "Rock is not soft" where metal is asked for: nothing that can be said of rock is right.
    Mark feels = mark_answer(feels_how(), "metal is not hard");
    const std::size_t n = readings_of(feels).size();
    REQUIRE(n > 2);
    CHECK(readings_of(feels)[0] == feels.slots);
    std::vector<bool> verdicts(n, false);
    CHECK_FALSE(settle(feels, verdicts));
    verdicts[1] = true;
    CHECK(settle(feels, verdicts));
    verdicts[0] = true;
    CHECK_FALSE(settle(feels, verdicts));
}

TEST_CASE("readings: that there is no difference is true where nothing is right") {
    Mark mark = mark_answer(heaviest(), "they weigh the same");
    REQUIRE(readings_of(mark).size() == 4);
    CHECK(settle(mark, {false, false, false, false}));
    CHECK_FALSE(settle(mark, {true, false, false, false}));
    CHECK(mark.slot("thing") == "apple");  // one that is not right, for the lesson
}

TEST_CASE(
    "readings: no difference of two that are named is no answer whichever of them comes first") {
    // By weight: the lesson's verdict, as a lesson gives it.
    const std::vector<std::string> by_weight{"egg", "banana", "apple", "watermelon"};
    const auto at = [&](std::string_view thing) {
        return std::ranges::find(by_weight, thing) - by_weight.begin();
    };
    const auto is_true = [&](const std::string& said) {
        INFO(said);
        Mark mark = mark_answer(heavier(), said);
        REQUIRE(mark.understood);
        std::vector<bool> verdicts;
        for (const Slots& reading : readings_of(mark)) {
            Mark asked;
            asked.slots = reading;
            verdicts.push_back(at(asked.slot("thing")) > at(asked.slot("other")));
        }
        return settle(mark, verdicts);
    };
    for (const char* said :
         {"the egg is as heavy as the apple", "the apple is as heavy as the egg",
          "the egg is just as heavy as the apple", "the egg weighs the same as the apple",
          "the egg weighs as much as the apple", "the egg and the apple weigh the same",
          "the egg has the same weight as the apple", "the egg and the apple have the same weight",
          "the egg and the apple are equally heavy", "the apple and the egg are the same weight"}) {
        CHECK_FALSE(is_true(said));
    }
    CHECK(is_true("the egg is not as heavy as the apple"));
}

TEST_CASE(
    "readings: of several sentences each is to be right, and what is ruled out is to be wrong") {
    Mark mark = mark_answer(heaviest(), "the egg, not the apple");
    REQUIRE(readings_of(mark).size() == 2);
    CHECK(settle(mark, {true, false}));
    CHECK_FALSE(settle(mark, {true, true}));
    CHECK_FALSE(settle(mark, {false, false}));
    CHECK_FALSE(settle(mark, {true}));
    CHECK(mark.understood);
    // What is told of something else beside the answer need not be wrong.
    Mark both = mark_answer(heavier(), "The egg is heavier, the apple is heavier.");
    REQUIRE(readings_of(both).size() == 2);
    CHECK_FALSE(settle(both, {true, false}));
    CHECK_FALSE(both.understood);
    both = mark_answer(heavier(), "The egg is heavier, the apple is heavier.");
    CHECK_FALSE(settle(both, {false, false}));
    CHECK(both.understood);
}

TEST_CASE("reasons: of an answer whose reason is not true the lesson is told what is wrong of it") {
    Mark both = mark_answer(heavier(), "the apple because the egg is heavier");
    CHECK_FALSE(settle(both, {true, false}));
    CHECK(both.understood);
    CHECK(both.slots == Slots{{"thing", "egg"}});
}

TEST_CASE("said parts: each sentence has its own mark, its errors where they stand in the whole") {
    const std::string_view said = "The apple. It is more heavy.";
    const auto parts = read_parts(heavier(), said, said_sentences(said, false));
    REQUIRE(parts);
    REQUIRE(parts->size() == 2);
    CHECK(parts->front().mark.form_errors.empty());
    REQUIRE(!parts->back().mark.form_errors.empty());
    const FormError& error = parts->back().mark.form_errors.front();
    CHECK(said.substr(error.begin, error.end - error.begin).find("more") == 0);
    CHECK(parts->back().mark.slots == Slots{{"thing", "apple"}});
}

TEST_CASE("said parts: what says nothing is left out, what nobody understands spoils all") {
    const auto parts_of = [](std::string_view said) {
        return read_parts(heavier(), said, said_sentences(said, true));
    };
    CHECK(parts_of("I think so. The apple.")->size() == 1);
    CHECK(parts_of("No, the apple!")->size() == 1);
    CHECK(!parts_of("The apple. Bananas sing."));
    CHECK(!parts_of("The apple. Then the egg."));
    CHECK(read_parts(heavier(), "", {})->empty());
}

TEST_CASE("said parts: what is ruled out is claimed to be wrong, and alone it is no answer") {
    const Mark apple = mark_sentence(heavier(), "the apple");
    const Mark egg = mark_sentence(heavier(), "the egg");
    const auto joined = joined_mark({{apple, false}, {egg, true}}, apple);
    REQUIRE(joined);
    CHECK(joined->claim == Claim::every);
    CHECK(joined->readings == std::vector<Slots>{apple.slots, egg.slots});
    CHECK(joined->denied == std::vector<bool>{false, true});
    CHECK(joined_mark({{apple, false}, {apple, false}}, apple)->claim == Claim::same);
    CHECK(!joined_mark({{egg, true}}, apple));
}
