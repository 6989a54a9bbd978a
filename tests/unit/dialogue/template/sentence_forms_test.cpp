#include "dialogue/marking/mark_answer.h"
#include "dialogue/template/matcher.h"
#include "dialogue/template/sentence_parts.h"
#include "dialogue/template/sentences.h"
#include "dialogue/template/short_answers.h"
#include "dialogue/template/syntax.h"
#include "dialogue/template/tokens.h"
#include "dialogue/template/word_order.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/rig.h"
#include "tests/unit/dialogue/wrong_sentences.h"

#include <rapidcheck.h>

using namespace fulcrum::dialogue;

namespace {

std::string canonical(const Question& question,
                      const std::vector<std::pair<std::string, std::string>>& slots,
                      int graph = 0) {
    return render(canonical_pieces(*question.templates, graph, slots));
}

bool has_order(const Mark& mark) {
    return std::any_of(mark.form_errors.begin(), mark.form_errors.end(),
                       [](const FormError& error) { return error.code == ErrorCode::word_order; });
}

std::size_t arcs_of(const Question& question) {
    return question.templates->graphs.front().arcs.size();
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

TEST_CASE("sentence parts: where the verb stands, what is compared, and with what") {
    const TemplateSet set = compiled_templates(
        {{"[the] {thing} is <comparative:heavy>"}, {{"thing", {"red block", "blue block"}}}, {}});
    const std::string text = "[the] {thing} (is|looks) <comparative:heavy> from here [than that]";
    const auto syntax = parse_template(text);
    REQUIRE(syntax);
    const ParsedRules rules;
    const SentenceParts parts(set, rules, text, *syntax);
    REQUIRE(parts.size() == 7);
    CHECK(parts.text(0, 2) == "[the] {thing}");
    CHECK(parts.is_be(2));
    CHECK(parts.be(2) == "is");
    CHECK(parts.form(3) == "comparative");
    CHECK(parts.adjectives(3, "comparative") == std::vector<std::string>{"heavy"});
    CHECK(parts.adjectives(3, "superlative").empty());
    CHECK(parts.than_at(3) == 6);
    CHECK(parts.begins_with(6, "than"));
    CHECK(parts.slots(0, 7) == std::vector<std::string>{"thing"});
    CHECK(parts.head_of("thing") == "block");
    CHECK(parts.same_words("thing", "thing"));
    CHECK(parts.list_of("other") == nullptr);
    CHECK(parts.is_plain_statement());
}

TEST_CASE("short answers: what is turned round comes last and is taken for nothing else") {
    const Question question = made_of_what();
    const TemplateSet& set = *question.templates;
    const auto turned = match(set, "wood is made of a table");
    REQUIRE(turned);
    const Graph& graph = set.graphs[static_cast<std::size_t>(turned->graph)];
    CHECK(graph.turned_round);
    CHECK_FALSE(graph.short_answer);
    const auto behind = set.graphs.begin() + turned->graph + 1;
    CHECK(std::none_of(behind, set.graphs.end(), [](const Graph& other) {
        return other.short_answer && other.claim == Claim::same;
    }));
    CHECK(turned->slots == std::vector<std::pair<std::string, std::string>>{{"thing", "wood"},
                                                                            {"material", "table"}});
    // The thing is what stands before, whatever follows.
    const TemplateSet more =
        compiled_templates({{"{thing} <made_of:{material}> like {thing:other}"}, textures(), {}});
    REQUIRE(match(more, "wood is made of a table"));
    CHECK(match(more, "wood is made of a table")->slots[0].first == "thing");
    // Where the thing isn't asked for, or both come from one list, there is nothing to turn round.
    const Question spaceship = spaceship_of_what();
    for (const Graph& one : spaceship.templates->graphs) {
        CHECK_FALSE(one.turned_round);
    }
    const TemplateSet same =
        compiled_templates({{"{material:thing} <made_of:{material}>"}, textures(), {}});
    CHECK_FALSE(same.graphs.back().turned_round);
    CHECK(match(same, "paper is made of wood"));
}

TEST_CASE("syntax: hostile depth and length are refused") {
    CHECK(parse_template(std::string(24, '[') + "a" + std::string(24, ']')));
    CHECK_FALSE(parse_template(std::string(25, '[') + "a" + std::string(25, ']')));
    CHECK_FALSE(parse_template(std::string(4000, '(')));
    CHECK_FALSE(parse_template(std::string(5000, 'a')));
    CHECK_FALSE(parse_template(std::string(1 << 20, '[')));
}

TEST_CASE("tokens: each knows the bytes it came from") {
    const std::string text = "So, it’s THE 21st isn’t";
    const auto tokens = tokenise(text);
    const std::vector<std::pair<std::string, std::string>> expected = {
        {"so", "So"},  {"it", "it"}, {"is", "’s"}, {"the", "THE"}, {"twenty", "21"},
        {"one", "21"}, {"st", "st"}, {"is", "is"}, {"not", "n’t"}};
    REQUIRE(tokens.size() == expected.size());
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        CHECK(tokens[i].text == expected[i].first);
        INFO(tokens[i].text);
        CHECK(text.substr(tokens[i].begin, tokens[i].end - tokens[i].begin) == expected[i].second);
    }
}

TEST_CASE("tokens: any bytes give words inside the text, in order") {
    CHECK(rc::check([](const std::string& text) {
        std::size_t last = 0;
        for (const Token& token : tokenise(text)) {
            RC_ASSERT(!token.text.empty());
            RC_ASSERT(token.begin <= token.end);
            RC_ASSERT(token.end <= text.size());
            RC_ASSERT(token.begin >= last || token.begin + 6 >= last);
            last = token.begin;
        }
    }));
}

TEST_CASE("word order: no sentence with other errors is told as one out of order") {
    for (const Question& question : all_questions()) {
        const TemplateSet& set = *question.templates;
        for (const Graph& graph : set.graphs) {
            if (graph.nearly) {
                continue;  // out of order, whatever else is wrong
            }
            each_wrong_sentence(
                set, graph,
                [&](const std::string& said) {
                    INFO(question.id << ": " << said);
                    CHECK_FALSE(has_order(mark_answer(question, said)));
                },
                ErrorCode::word_order);
        }
    }
}

TEST_CASE("word order: the graph grows by less than itself for each verb, and a full one stays") {
    const Question one = compiled({"one", "?", {"an egg is the <superlative:heavy>"}, {}});
    const Question none = compiled({"none", "?", {"an egg the <superlative:heavy>"}, {}});
    CHECK(arcs_of(one) < 3 * arcs_of(none));
    TemplateSet set;
    ArcWriter writer(set, 8);
    const int start = writer.add_node();
    const int verb = writer.add_node();
    const int behind = writer.add_node();
    const int end = writer.add_node();
    const int word = writer.add_element({Role::word});
    Element is{Role::verb};
    is.verb = {"is", "are", true};
    writer.add_arc(start, verb, word, {"egg", "egg", ErrorCode::none, 0, true});
    writer.add_arc(verb, behind, writer.add_element(std::move(is)),
                   {"is", "is", ErrorCode::none, 0, true});
    writer.add_arc(behind, end, word, {"here", "here", ErrorCode::none, 0, true});
    add_verb_last(writer, start, end);
    CHECK(writer.arcs().size() == 3);
}
