#include "dialogue/template/matcher.h"
#include "dialogue/template/sentences.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

/// The codes found in "it is <said>" by a template with `article` before the list; "?" when not understood.
std::string codes_of(const std::string& article, const std::string& said) {
    const TemplateSet set = compiled_templates(
        {{"look at here " + article + " {thing}"},
         {{"thing",
           {"watermelon", "egg", "water", "scissors", "Jupiter", "the Moon", "Earth", "herb"}}},
         {}});
    const auto parse = match(set, "look at here " + said);
    if (!parse) {
        return "?";
    }
    std::string codes;
    for (const Piece& piece : parse->pieces) {
        if (piece.code != ErrorCode::none) {
            codes += (codes.empty() ? "" : " ") + std::string(errant_code(piece.code)) + "->" +
                     piece.right;
        }
    }
    return codes;
}

}  // namespace

TEST_CASE("noun phrase: no article behind no; the wind is the one around everybody") {
    const Question question =
        compiled({"why",
                  "Why?",
                  {"there is no {nothing}", "the {nothing} stopped", "it has no {part}"},
                  {{"nothing", {"wind", "air"}}, {"part", {"tail"}}}});
    const auto said_back = [&](const char* said) {
        const Mark mark = mark_answer(question, said);
        return mark.form_right() ? mark.corrected : mark.emphasised;
    };
    CHECK(said_back("there is no wind") == "There is no wind.");
    CHECK(said_back("there is no the wind") == "There is no *wind*.");
    CHECK(said_back("it has no a tail") == "It has no *tail*.");
    CHECK(said_back("it has no tails") == "It has no tails.");
    CHECK(said_back("the wind stopped") == "The wind stopped.");
    CHECK(said_back("wind stopped") == "*The wind* stopped.");
    CHECK(said_back("air stopped") == "Air stopped.");
}

TEST_CASE("noun phrase: a comparative of a list has its wrong forms too") {
    const Question question = compiled({"change",
                                        "How?",
                                        {"make the tail {size}", "it needs a {size} tail"},
                                        {{"size", {"longer|long", "shorter"}}}});
    const auto said_back = [&](const char* said) {
        const Mark mark = mark_answer(question, said);
        return std::string(mark.slot("size")) + ": " + mark.emphasised;
    };
    CHECK(said_back("make the tail more long") == "longer: Make the tail *longer*.");
    CHECK(said_back("make the tail more shorter") == "shorter: Make the tail *shorter*.");
    CHECK(said_back("it needs a more long tail") == "longer: It needs *a longer* tail.");
    CHECK(said_back("it needs a long tail") == "longer: It needs a long tail.");
    const Mark mark = mark_answer(question, "make the tail more long");
    REQUIRE(mark.form_errors.size() == 1);
    CHECK(mark.form_errors[0].code == ErrorCode::adjective_form);
    CHECK(mark.form_errors[0].base == "long");
}

TEST_CASE("noun phrase: what is called torque is nobody's own, and not one of several") {
    const TemplateSet set =
        compiled_templates({{"it is called {term}"}, {{"term", {"torque"}}}, {}});
    CHECK(match(set, "it is called torque")->cost == 0);
    CHECK_FALSE(match(set, "it is called my torque"));
    const auto one = match(set, "it is called a torque");
    REQUIRE(one);
    CHECK(one->cost > 0);
}

TEST_CASE("noun phrase: each class of noun has its articles") {
    const struct {
        const char *article, *said, *codes;
    } rows[] = {
        {"<article>", "a watermelon", ""},
        {"<article>", "an watermelon", "R:DET->a"},
        {"<article>", "the watermelon", ""},
        {"<article>", "watermelon", "M:DET->a"},
        {"<article>", "egg", "M:DET->an"},
        {"<article>", "a egg", "R:DET->an"},
        {"<article>", "this egg", ""},
        {"<article>", "that egg", ""},
        {"<article>", "these egg", "R:DET->this"},
        {"<article>", "those egg", "R:DET->that"},
        {"<article>", "this eggs", "R:NOUN:NUM->egg"},
        {"<article>", "that eggs", "R:NOUN:NUM->egg"},
        {"<article>", "the an egg", "U:DET->the"},
        {"<article>", "eggs", ""},
        {"<article>", "some eggs", ""},
        {"<article>", "the eggs", "R:NOUN:NUM->egg"},
        {"<article>", "an eggs", "R:NOUN:NUM->egg"},
        {"<article>", "a eggs", "R:DET->an R:NOUN:NUM->egg"},
        {"<article>", "these watermelons", "R:NOUN:NUM->watermelon"},
        {"<article>", "water", ""},
        {"<article>", "some water", ""},
        {"<article>", "a water", "U:DET->"},
        {"<article>", "this water", ""},
        {"<article>", "these water", "R:DET->this"},
        {"<article>", "scissors", ""},
        {"<article>", "these scissors", ""},
        {"<article>", "this scissors", "R:DET->these"},
        {"<article>", "that scissors", "R:DET->those"},
        {"<article>", "a scissors", "U:DET->"},
        {"<article>", "Jupiter", ""},
        {"<article>", "the Jupiter", "U:DET->"},
        {"<article>", "this Jupiter", "U:DET->"},
        {"<article>", "the moon", ""},
        {"<article>", "moon", "M:DET->the"},
        {"<article>", "a moon", "R:DET->the"},
        {"<article>", "the earth", ""},
        {"<article>", "earth", ""},
        {"<article>", "an earth", "R:DET->the"},
        {"<article>", "a herb", ""},
        {"<article>", "an herb", ""},
        {"no", "no water", ""},
        {"no", "no the water", "U:DET->"},
        {"no", "no watermelon", ""},
        {"no", "no watermelons", ""},
        {"no", "no a watermelon", "U:DET->"},
        {"enough", "enough water", ""},
        {"enough", "enough the water", "U:DET->"},
        {"any", "any scissors", ""},
        {"(no|too little)", "too little water", ""},
        {"(no|too little)", "no the water", "U:DET->"},
        {"any", "any the scissors", "U:DET->"},
        {"the", "watermelon", "M:DET->the"},
        {"the", "a watermelon", ""},
        {"the", "eggs", "M:DET->the R:NOUN:NUM->egg"},
        {"the", "some eggs", "R:NOUN:NUM->egg"},
        {"the", "the eggs", "R:NOUN:NUM->egg"},
        {"the", "those eggs", "R:NOUN:NUM->egg"},
        {"the", "this egg", ""},
        {"the", "these egg", "R:DET->this"},
        {"the", "water", ""},
        {"the", "the scissors", ""},
        {"[the|a|an]", "egg", "M:DET->the"},
        {"[the|a|an]", "an egg", ""},
        {"[the|a|an]", "a egg", "R:DET->an"},
        {"[a|an|the]", "egg", "M:DET->an"},
        {"(a|an)", "egg", "M:DET->an"},
        {"", "egg", ""},
        {"", "an egg", ""},
        {"", "a egg", "R:DET->an"},
        {"", "this egg", ""},
        {"", "these eggs", ""},
        {"", "those eggs", ""},
        {"", "the eggs", "R:NOUN:NUM->egg"},
        {"", "this eggs", "R:NOUN:NUM->egg"},
        {"", "these egg", "R:DET->this"},
        {"", "a water", "U:DET->"},
    };
    for (const auto& row : rows) {
        INFO(row.article << " | " << row.said);
        CHECK(codes_of(row.article, row.said) == row.codes);
    }
}

TEST_CASE("noun phrase: a noun in the number that its list doesn't give") {
    const TemplateSet any =
        compiled_templates({{"look at <article> {thing} here"},
                            {{"thing", {"wood", "metal", "windows", "scissors"}}},
                            {}});
    const TemplateSet there = compiled_templates(
        {{"look at the {thing} here"}, {{"thing", {"wood", "metal", "windows", "scissors"}}}, {}});
    const struct {
        const char *said, *any, *there;
    } rows[] = {
        {"wood", "", ""},
        {"woods", "R:NOUN:NUM", "R:NOUN:NUM"},
        {"the woods", "R:NOUN:NUM", "R:NOUN:NUM"},
        {"metals", "", "M:DET R:NOUN:NUM"},
        {"the metals", "R:NOUN:NUM", "R:NOUN:NUM"},
        {"windows", "", ""},
        {"a window", "", ""},
        {"the window", "", ""},
        {"window", "M:DET", "M:DET"},
        {"an window", "R:DET", "R:DET"},
        {"scissor", "R:NOUN:NUM", "R:NOUN:NUM"},
        {"a scissor", "U:DET R:NOUN:NUM", "U:DET R:NOUN:NUM"},
    };
    const auto codes = [](const TemplateSet& set, const char* said) {
        const auto parse = match(set, "look at " + std::string(said) + " here");
        std::string text = parse ? "" : "?";
        for (std::size_t i = 0; parse && i < parse->pieces.size(); ++i) {
            if (parse->pieces[i].code != ErrorCode::none) {
                text += (text.empty() ? "" : " ") + std::string(errant_code(parse->pieces[i].code));
            }
        }
        return text;
    };
    for (const auto& row : rows) {
        INFO(row.said);
        CHECK(codes(any, row.said) == row.any);
        CHECK(codes(there, row.said) == row.there);
    }
}

TEST_CASE("noun phrase: a word of a list that is no thing has no determiner") {
    const TemplateSet set = compiled_templates(
        {{"[it is] {place} the {thing}", "it should be {weight}"},
         {{"place", {"under|below", "on top of|on", "next to|beside", "between"}},
          {"thing", {"red block", "blue block"}},
          {"weight", {"heavy", "soft"}}},
         {}});
    const auto codes = [&](std::string_view said) {
        const auto parse = match(set, said);
        std::string found = parse ? "" : "?";
        for (const Piece& piece : parse ? parse->pieces : std::vector<Piece>{}) {
            if (piece.code != ErrorCode::none) {
                found += std::string(errant_code(piece.code)) + "->" + piece.right + " ";
            }
        }
        return found;
    };
    for (const char* right : {"under the red block", "it is on top of the blue block",
                              "it is beside the red block", "it should be heavy"}) {
        INFO(right);
        CHECK(codes(right).empty());
    }
    for (const char* wrong :
         {"an under the red block", "a under the red block", "the under the red block",
          "it is a below the red block", "it is the on the red block", "this beside the red block",
          "it should be a heavy", "it should be the soft"}) {
        INFO(wrong);
        CHECK(codes(wrong) == "U:DET-> ");
    }
    CHECK(codes("under the a red block") == "U:DET->the ");
}

TEST_CASE("noun phrase: an adjective before a thing keeps the thing's article") {
    const TemplateSet set = compiled_templates(
        {{"the {who} child must sit"}, {{"who", {"heavy|heavier", "light|lighter"}}}, {}});
    const auto parse = match(set, "the heavy child must sit");
    REQUIRE(parse);
    CHECK(parse->cost == 0);
}

TEST_CASE("noun phrase: food and stuff that cannot be counted takes no a") {
    const TemplateSet set = compiled_templates(
        {{"[a|an|the] {thing} is the <superlative:heavy>"}, {{"thing", {"corn", "apple"}}}, {}});
    const auto cost = [&](std::string_view said) {
        const auto parse = match(set, said);
        return parse ? parse->cost : -1;
    };
    CHECK(cost("corn is the heaviest") == 0);
    CHECK(cost("the corn is the heaviest") == 0);
    CHECK(cost("a corn is the heaviest") > 0);
    CHECK(cost("an apple is the heaviest") == 0);
}

TEST_CASE("noun phrase: the Sun and the Earth may be written small") {
    const TemplateSet set =
        compiled_templates({{"they go round [the] {star}", "[the] {star} is big"},
                            {{"star", {"Sun", "the Moon", "Earth|the Earth"}}},
                            {}});
    for (const char* right : {"they go round the sun", "they go round the Sun", "the earth is big",
                              "the moon is big", "Earth is big", "earth is big"}) {
        INFO(right);
        const auto parse = match(set, right);
        REQUIRE(parse);
        CHECK(parse->cost == 0);
    }
    for (const char* wrong : {"they go round sun", "sun is big", "a sun is big", "moon is big"}) {
        INFO(wrong);
        const auto parse = match(set, wrong);
        REQUIRE(parse);
        CHECK(parse->cost > 0);
    }
}

namespace {

/// What is said back to `said`, with the codes of its errors before it.
std::string told(const TemplateSource& source, std::string_view said) {
    const TemplateSet set = compiled_templates(source);
    const auto parse = match(set, said);
    std::string text = parse ? "" : "?";
    for (const Piece& piece : parse ? parse->pieces : std::vector<Piece>{}) {
        text += piece.code == ErrorCode::none ? "" : std::string(errant_code(piece.code)) + " ";
    }
    return parse ? text + render(parse->pieces) : text;
}

}  // namespace

TEST_CASE("noun phrase: a unit that measures has no determiner") {
    const TemplateSource in{
        {"we use {unit}", "it has the {unit}"}, {{"unit", {"newtons", "seconds"}}}, {}};
    CHECK(told(in, "we use newtons") == "We use newtons.");
    CHECK(told(in, "we use this newtons") == "U:DET We use newtons.");
    CHECK(told(in, "we use the seconds") == "U:DET We use seconds.");
    CHECK(told(in, "we use newton") == "R:NOUN:NUM We use newtons.");
    CHECK(told(in, "we use a newton") == "U:DET R:NOUN:NUM We use newtons.");
    // Where the template itself has an article it is asked for.
    CHECK(told(in, "it has the seconds") == "It has the seconds.");
}

TEST_CASE("noun phrase: what is behind is, is one thing") {
    const TemplateSource it{
        {"it is <article> {thing}", "it is the {thing} now", "<article> {thing} is here"},
        {{"thing", {"egg", "ball", "scissors"}}},
        {}};
    CHECK(told(it, "it is an egg") == "It is an egg.");
    CHECK(told(it, "it is eggs") == "M:DET R:NOUN:NUM It is an egg.");
    CHECK(told(it, "it is some balls") == "R:NOUN:NUM It is a ball.");
    CHECK(told(it, "it is the balls now") == "R:NOUN:NUM It is the ball now.");
    CHECK(told(it, "it is scissors") == "It is scissors.");
    CHECK(told(it, "eggs are here") == "Eggs are here.");
}

TEST_CASE("noun phrase: a list of adjectives before a noun has neither several nor stuff") {
    const TemplateSource who{
        {"the {who} child sits", "it is {who}"}, {{"who", {"light|lighter", "heavy|heavier"}}}, {}};
    CHECK(told(who, "the light child sits") == "The light child sits.");
    CHECK(told(who, "light child sits") == "M:DET The light child sits.");
    CHECK(told(who, "the lights child sits") == "R:SPELL The light child sits.");
    CHECK(told(who, "it is light") == "It is light.");
    CHECK(told(who, "it is a light") == "U:DET It is light.");
}

TEST_CASE("noun phrase: a name behind the is pointed at by no this") {
    const TemplateSource earth{
        {"the Earth has {thing}", "the four eggs weigh {thing}"}, {{"thing", {"water"}}}, {}};
    CHECK(told(earth, "this earth has water") == "R:DET The Earth has water.");
    CHECK(told(earth, "these four eggs weigh water") == "These four eggs weigh water.");
    CHECK(told(earth, "this four eggs weigh water") == "R:DET These four eggs weigh water.");
}

TEST_CASE("noun phrase: of a force there is not one, unless the sentence says so") {
    const TemplateSource up{{"{force} holds it up", "the {force} pulls", "take <article> {force}"},
                            {{"force", {"lift", "drag", "kite"}}},
                            {}};
    CHECK(told(up, "lift holds it up") == "Lift holds it up.");
    CHECK(told(up, "the lift holds it up") == "The lift holds it up.");
    CHECK(told(up, "a lift holds it up") == "U:DET Lift holds it up.");
    CHECK(told(up, "a kite holds it up") == "A kite holds it up.");
    CHECK(told(up, "a lifts holds it up") == "U:DET R:NOUN:NUM Lift holds it up.");
    CHECK(told(up, "the lift pulls") == "The lift pulls.");
    CHECK(told(up, "a lift pulls") == "R:DET The lift pulls.");
    CHECK(told(up, "take a lift") == "Take a lift.");
}
