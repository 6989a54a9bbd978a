#include "dialogue/template/sentences.h"

#include "dialogue/marking/mark.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

std::string canonical(const Question& question,
                      const std::vector<std::pair<std::string, std::string>>& slots,
                      int graph = 0) {
    return render(canonical_pieces(*question.templates, graph, slots));
}

}  // namespace

TEST_CASE("sentences: forms of a word are alike, other words are not") {
    for (const auto& [word, other] : {std::pair{"turn", "turning"},
                                      {"stop", "stopped"},
                                      {"stops", "stopped"},
                                      {"hard", "harder"},
                                      {"make", "making"},
                                      {"go", "go"}}) {
        INFO(word << " " << other);
        CHECK(alike(word, other));
    }
    CHECK_FALSE(alike("than", "that"));
    CHECK_FALSE(alike("is", "it"));
    CHECK_FALSE(alike("lift", "light"));
}

TEST_CASE("sentences: n't is shown with its verb") {
    const Question question =
        compiled({"why", "Why?", {"it doesn't have {nothing}"}, {{"nothing", {"wind"}}}});
    const Mark mark = mark_answer(question, "it don't have wind");
    CHECK(mark.emphasised == "It *doesn't* have wind.");
    CHECK(mark.gapped == "It … have wind.");
}

TEST_CASE("sentences: the canonical one has the right article and verb, and nothing optional") {
    CHECK(canonical(heaviest(), {{"thing", "egg"}}) == "An egg is the heaviest.");
    CHECK(canonical(heaviest(), {{"thing", "watermelon"}}) == "A watermelon is the heaviest.");
    CHECK(canonical(heaviest(), {{"thing", "apple"}}, 1) == "The heaviest is an apple.");
    CHECK(canonical(heavier(), {{"thing", "egg"}}) == "An egg is heavier.");
    CHECK(canonical(heavier(), {{"thing", "egg"}, {"other", "apple"}}) ==
          "An egg is heavier than an apple.");
    CHECK(canonical(made_of(), {{"thing", "scissors"}, {"material", "metal"}}) ==
          "The scissors are made of metal.");
    CHECK(canonical(biggest(), {{"body", "Moon"}}) == "The Moon is the biggest.");
    CHECK(canonical(biggest(), {{"body", "Mars"}}) == "Mars is the biggest.");
    // Unknown names and values fall back on the first entry.
    CHECK(canonical(heaviest(), {{"thing", "pear"}, {"no slot", "x"}}) ==
          "A watermelon is the heaviest.");
}

TEST_CASE(
    "sentences: adjectives side by side are a list with commas, in and beside what is emphasised") {
    const Question three =
        compiled({"feel",
                  "?",
                  {"{material} is <adjective:{feel}> [and] <adjective:{feel:also}> and "
                   "<adjective:{feel:third}>"},
                  {{"material", {"metal"}}, {"feel", {"hard", "smooth", "slippery"}}}});
    CHECK(canonical(three, {{"feel", "hard"}, {"also", "smooth"}, {"third", "slippery"}}) ==
          "Metal is hard, smooth and slippery.");
    const Mark slip = mark_answer(three, "metal is hard smoth and slippery");
    CHECK(slip.corrected == "Metal is hard, smooth and slippery.");
    CHECK(slip.emphasised == "Metal is hard, *smooth* and slippery.");
    CHECK(mark_answer(three, "metal is hrd, smooth and slippery").emphasised ==
          "Metal is *hard*, smooth and slippery.");
    CHECK(mark_answer(three, "metal is hard and smooth and slippery").corrected ==
          "Metal is hard and smooth and slippery.");
}

TEST_CASE("sentences: who speaks is I, however a template writes it") {
    const Question think =
        compiled({"think", "?", {"now i think it is {thing}"}, {{"thing", {"Mars"}}}});
    CHECK(canonical(think, {{"thing", "Mars"}}) == "Now I think it is Mars.");
}

TEST_CASE("sentences: phrases, emphasis and gaps") {
    const auto pieces = canonical_pieces(*heaviest().templates, 0, {{"thing", "egg"}});
    REQUIRE(pieces.size() == 5);
    const PieceRange noun = phrase_around(pieces, 1);
    CHECK(render_phrase(pieces, noun) == "an egg");
    CHECK(render_phrase(pieces, phrase_around(pieces, 0)) == "an egg");
    const PieceRange verb = phrase_around(pieces, 2);
    CHECK(render_phrase(pieces, verb) == "is");
    const PieceRange adjective = phrase_around(pieces, 3);
    CHECK(render_phrase(pieces, adjective) == "the heaviest");
    CHECK(render_phrase(pieces, phrase_around(pieces, 4)) == "the heaviest");
    CHECK(render(pieces, noun) == "*An egg* is the heaviest.");
    CHECK(render(pieces, verb) == "An egg *is* the heaviest.");
    CHECK(render(pieces, adjective) == "An egg is *the heaviest*.");
    CHECK(render(pieces, adjective, true) == "An egg is …");
    CHECK(render(pieces, noun, true) == "… is the heaviest.");
}

TEST_CASE("sentences: a walk takes the ways that are chosen") {
    const Question question = heaviest();
    const Sample first = walk(*question.templates, 0, false, [](std::size_t) { return 0; });
    CHECK(first.slots.size() == 1);
    CHECK(first.said.find("heaviest") != std::string::npos);
    const Sample last =
        walk(*question.templates, 0, true, [](std::size_t ways) { return ways - 1; });
    CHECK(last.said != first.said);
}

TEST_CASE("sentences: the passive around each of its parts") {
    const Question question = made_of_what();
    const auto pieces =
        canonical_pieces(*question.templates, 0, {{"thing", "scissors"}, {"material", "glass"}});
    CHECK(render(pieces) == "Scissors are made of glass.");
    for (int i = 0; i < static_cast<int>(pieces.size()); ++i) {
        if (pieces[static_cast<std::size_t>(i)].element.passive) {
            CHECK(render_phrase(pieces, passive_around(pieces, i)) == "are made of");
        }
    }
}
