#include "dialogue/marking/mark.h"

#include "tests/unit/dialogue/marking/marked_rows.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("mark: superlatives as learners say them") {
    check_rows(
        heaviest(),
        {
            {"watermelon is most heavy", "M:DET M:DET R:ADJ:FORM",
             "A watermelon is *the heaviest*."},
            {"A watermelon is the heaviest.", "", "A watermelon is the heaviest."},
            {"the watermelon is the heaviest", "", "The watermelon is the heaviest."},
            {"an egg is the heaviest object", "", "An egg is the heaviest object."},
            {"watermelons are the heaviest", "", "Watermelons are the heaviest."},
            {"my watermelon is the heaviest", "", "My watermelon is the heaviest."},
            {"a watermelon is the most heavy", "R:ADJ:FORM", "A watermelon is *the heaviest*."},
            {"a watermelon is the most heaviest", "R:ADJ:FORM", "A watermelon is *the heaviest*."},
            {"a watermelon is the heavyest", "R:SPELL", "A watermelon is *the heaviest*."},
            {"a watermelon is the heavyest one", "R:SPELL", "A watermelon is *the heaviest* one."},
            {"a watermelon is the heavy", "R:ADJ:FORM", "A watermelon is *the heaviest*."},
            {"a watermelon is the heavier", "R:ADJ:FORM", "A watermelon is *the heaviest*."},
            {"a watermelon is the more heavy", "R:ADJ:FORM", "A watermelon is *the heaviest*."},
            {"a watermelon is heaviest", "M:DET", "A watermelon is *the heaviest*."},
            {"a watermelon is a heaviest", "R:DET", "A watermelon is *the heaviest*."},
            {"watermelon is the heaviest", "M:DET", "*A watermelon* is the heaviest."},
            {"apple is the heaviest", "M:DET", "*An apple* is the heaviest."},
            {"a apple is the heaviest", "R:DET", "*An apple* is the heaviest."},
            {"an banana is the heaviest", "R:DET", "*A banana* is the heaviest."},
            {"a watermelon are the heaviest", "R:VERB:SVA", "A watermelon *is* the heaviest."},
            {"watermelons is the heaviest", "R:VERB:SVA", "Watermelons *are* the heaviest."},
            {"a watermelons is the heaviest", "R:NOUN:NUM", "*A watermelon* is the heaviest."},
            {"an eggs is the heaviest", "R:NOUN:NUM", "*An egg* is the heaviest."},
            {"a watermelon the heaviest", "M:VERB", "A watermelon *is* the heaviest."},
            {"a watermelon be the heaviest", "R:VERB:FORM", "A watermelon *is* the heaviest."},
            {"a watermelon was the heaviest", "", "A watermelon was the heaviest."},
            {"a watermelon were the heaviest", "R:VERB:SVA", "A watermelon *was* the heaviest."},
            {"a watermelon it is the heaviest", "U:PRON", "A watermelon is the heaviest."},
            {"the a watermelon is the heaviest", "U:DET", "*The watermelon* is the heaviest."},
            {"a watermellon is the heaviest", "R:SPELL", "*A watermelon* is the heaviest."},
            {"a water melon is the heaviest", "R:ORTH", "*A watermelon* is the heaviest."},
            {"a watermelon is the haeviest", "R:SPELL", "A watermelon is *the heaviest*."},
            {"a watermelon is teh heaviest", "R:SPELL", "A watermelon is *the heaviest*."},
            {"watermelon heavy", "M:DET M:VERB M:DET R:ADJ:FORM",
             "A watermelon is *the heaviest*."},
            {"watermelon most heaviest", "M:DET M:VERB M:DET R:ADJ:FORM",
             "A watermelon is *the heaviest*."},
            {"The heaviest is a watermelon", "", "The heaviest is a watermelon."},
            {"the heaviest fruit is watermelon", "M:DET", "The heaviest fruit is *a watermelon*."},
            {"heaviest one is the egg", "M:DET", "*The heaviest* one is the egg."},
            {"most heavy is apple", "M:DET R:ADJ:FORM M:DET", "*The heaviest* is an apple."},
            {"um, I think a watermelon is the heaviest", "", "A watermelon is the heaviest."},
            {"the watermelon’s the heaviest!", "", "The watermelon is the heaviest."},
            {"watermelons’re the heaviest!", "", "Watermelons are the heaviest."},
            {"watermelons's the heaviest!", "R:VERB:SVA", "Watermelons *are* the heaviest."},
            {"the watermelon's the heaviest!", "", "The watermelon is the heaviest."},
            {"  THE   WATERMELON  IS THE HEAVIEST  ", "", "The watermelon is the heaviest."},
        });
}

TEST_CASE("mark: comparatives as learners say them") {
    check_rows(
        heavier(),
        {
            {"an apple is heavier than an egg", "", "An apple is heavier than an egg."},
            {"apples are heavier than eggs", "", "Apples are heavier than eggs."},
            {"an apple is much heavier than an egg", "", "An apple is much heavier than an egg."},
            {"an apple is a lot heavier", "", "An apple is a lot heavier."},
            {"the apple is the heavier", "", "The apple is the heavier."},
            {"an apple is more heavy than an egg", "R:ADJ:FORM",
             "An apple is *heavier* than an egg."},
            {"an apple is more heavier than an egg", "R:ADJ:FORM",
             "An apple is *heavier* than an egg."},
            {"an apple is heavyer than an egg", "R:SPELL", "An apple is *heavier* than an egg."},
            {"an apple is heavy than an egg", "R:ADJ:FORM", "An apple is *heavier* than an egg."},
            {"an apple is heaviest than an egg", "R:ADJ:FORM",
             "An apple is *heavier* than an egg."},
            {"an apple is the heavier than an egg", "U:DET", "An apple is *heavier* than an egg."},
            {"an apple is the heaviest than an egg", "U:DET R:ADJ:FORM",
             "An apple is *heavier* than an egg."},
            {"an apple is heavier then an egg", "R:PREP", "An apple is heavier *than* an egg."},
            {"an apple is heavier that an egg", "R:PREP", "An apple is heavier *than* an egg."},
            {"an apple is heavier an egg", "M:PREP", "An apple is heavier *than* an egg."},
            {"an apple is heavier than egg", "M:DET", "An apple is heavier than *an egg*."},
            {"an apple is heavier than a egg", "R:DET", "An apple is heavier than *an egg*."},
            {"an apple is very heavier than an egg", "R:ADV",
             "An apple is *much heavier* than an egg."},
            {"apple heavier egg", "M:DET M:VERB M:PREP M:DET",
             "An apple *is* heavier than an egg."},
            {"a apple more heavy then a egg", "R:DET M:VERB R:ADJ:FORM R:PREP R:DET",
             "An apple is *heavier* than an egg."},
            {"apples is heavier than eggs", "R:VERB:SVA", "Apples *are* heavier than eggs."},
        });
}

TEST_CASE("mark: long adjectives, names, materials, plurals, other verbs") {
    check_rows(dearer(), {
                             {"an apple is more expensive than an egg", "",
                              "An apple is more expensive than an egg."},
                             {"an apple is expensiver than an egg", "R:ADJ:FORM",
                              "An apple is *more expensive* than an egg."},
                             {"an apple is most expensive than an egg", "R:ADJ:FORM",
                              "An apple is *more expensive* than an egg."},
                         });
    check_rows(biggest(), {
                              {"Jupiter is the biggest", "", "Jupiter is the biggest."},
                              {"the jupiter is the biggest", "U:DET", "*Jupiter* is the biggest."},
                              {"jupiter is the bigest", "R:SPELL", "Jupiter is *the biggest*."},
                              {"moon is the biggest", "M:DET", "*The Moon* is the biggest."},
                              {"a moon is the biggest", "R:DET", "*The Moon* is the biggest."},
                              {"earth is the biggest", "", "Earth is the biggest."},
                              {"the earth is the biggest", "", "The Earth is the biggest."},
                              {"Mars is most big", "M:DET R:ADJ:FORM", "Mars is *the biggest*."},
                          });
    check_rows(
        made_of(),
        {
            {"the ball is made of rubber", "", "The ball is made of rubber."},
            {"the ball is made by rubber", "R:PREP", "The ball is made *of* rubber."},
            {"the ball is made rubber", "M:PREP", "The ball is made *of* rubber."},
            {"the ball made of rubber", "M:VERB", "The ball *is* made of rubber."},
            {"the ball is made of a wood", "U:DET", "The ball is made of *wood*."},
            {"the scissors are made of metal", "", "The scissors are made of metal."},
            {"the scissors is made of metal", "R:VERB:SVA", "The scissors *are* made of metal."},
            {"ball is made of wood", "M:DET", "*The ball* is made of wood."},
        });
    check_rows(moons(), {
                            {"Mars has two moons", "", "Mars has 2 moons."},
                            {"Mars has 2 moons", "", "Mars has 2 moons."},
                            {"Mars has twenty-one moons", "", "Mars has 21 moons."},
                            {"Mars has two moon", "R:NOUN:NUM", "Mars has 2 *moons*."},
                            {"Mars have two moons", "R:VERB:SVA", "Mars *has* 2 moons."},
                        });
    check_rows(weighs(),
               {
                   {"an apple weighs more than an egg", "", "An apple weighs more than an egg."},
                   {"an apple weigh more than an egg", "R:VERB:SVA",
                    "An apple *weighs* more than an egg."},
                   {"apples weigh more than eggs", "", "Apples weigh more than eggs."},
                   {"an apple is weigh more than an egg", "R:VERB:FORM",
                    "An apple *weighs* more than an egg."},
               });
}

TEST_CASE("mark: the template's own first article is the one that is said back") {
    const auto asked = [](const char* answer) {
        return compiled(
            {"heavier", "Which one is heavier, the apple or the egg?", {answer}, fruit()});
    };
    for (const char* answer : {"[the|a|an] {thing} is <comparative:heavy> [than the {thing:other}]",
                               "the {thing} is <comparative:heavy> [than the {thing:other}]"}) {
        INFO(answer);
        const Question question = asked(answer);
        check_rows(question,
                   {{"the apple is heavier", "", "The apple is heavier."},
                    {"apple is heavier", "M:DET", "*The apple* is heavier."},
                    {"the apple is more heavy", "R:ADJ:FORM", "The apple is *heavier*."},
                    {"an apple is more heavy than an egg", "R:ADJ:FORM",
                     "The apple is *heavier* than the egg."},
                    {"a apple is heavier", "R:DET", "*An apple* is heavier."},
                    {"the apples are heavier", "R:NOUN:NUM", "*The apple* is heavier."},
                    {"apples are heavier", "", "Apples are heavier."},
                    {"the apples are more heavy than the eggs", "R:NOUN:NUM R:ADJ:FORM R:NOUN:NUM",
                     "The apple is *heavier* than the egg."},
                    {"it is apple", "M:DET", "It is *the apple*."}});
        CHECK(mark_answer(question, "apple").corrected == "The apple is heavier.");
        CHECK(mark_answer(question, "an apple").corrected == "The apple is heavier.");
        CHECK(mark_answer(question, "apple").form_right());
        CHECK(choices(question)[1] == "the apple");
    }
    for (const char* answer : {"[a|an|the] {thing} is <comparative:heavy>",
                               "<article> {thing} is <comparative:heavy>"}) {
        INFO(answer);
        const Question question = asked(answer);
        check_rows(question, {{"apple is heavier", "M:DET", "*An apple* is heavier."},
                              {"the apple is more heavy", "R:ADJ:FORM", "The apple is *heavier*."},
                              {"apples are heavier", "", "Apples are heavier."},
                              {"the apples are heavier", "R:NOUN:NUM", "*The apple* is heavier."},
                              {"it is apple", "M:DET", "It is *an apple*."}});
        CHECK(mark_answer(question, "apple").corrected == "An apple is heavier.");
        CHECK(choices(question)[1] == "an apple");
    }
}

TEST_CASE("mark: short answers are understood and fine") {
    for (const char* said :
         {"watermelon", "the watermelon", "A watermelon!", "It is the watermelon.",
          "it's a watermelon", "I think it's the watermelon", "that is my watermelon"}) {
        INFO(said);
        const Mark mark = mark_answer(heaviest(), said);
        CHECK(mark.understood);
        CHECK(mark.short_answer);
        CHECK(mark.form_right());
        CHECK(mark.slot("thing") == "watermelon");
        CHECK(mark.answer == 0);
    }
    for (const char* said :
         {"I think the apple is heavier because it is big", "Well, of course the apple is heavier.",
          "the apple is heavier, I think, because the egg is not heavier"}) {
        INFO(said);
        const Mark mark = mark_answer(heavier(), said);
        CHECK(mark.corrected == "The apple is heavier.");
        CHECK(mark.form_right());
        CHECK(mark.slot("other").empty());
    }
    CHECK(mark_answer(heavier(), "the eg is heavier").slot("thing") == "egg");
    CHECK(codes_of(mark_answer(heavier(), "the eg is heavier")) == "R:SPELL");
    // Of two, not the one is the other.
    CHECK(mark_answer(heavier(), "the apple is not heavier because it is big").slot("thing") ==
          "egg");
    CHECK(mark_answer(heaviest(), "watermelon").corrected == "A watermelon is the heaviest.");
    CHECK(mark_answer(heaviest(), "a apple").emphasised == "*An apple* is the heaviest.");
    CHECK(mark_answer(heaviest(), "it is watermelon").emphasised == "It is *a watermelon*.");
    CHECK(mark_answer(biggest(), "moon").form_right());
    // Two slots are asked for: one noun is no answer.
    CHECK_FALSE(mark_answer(made_of(), "metal").understood);
}

TEST_CASE("mark: what turns the meaning round, or says nothing known, is not understood") {
    for (const char* said :
         {"", " ", "?!", "a watermelon is the least heavy", "a watermelon is the second heaviest",
          "a pear is the heaviest", "a watermelon is the lightest", "heaviest", "the",
          "is the heaviest", "watermelon apple", "a watermelon or an apple", "no watermelon",
          "a watermelon is the heaviest except the apple", "수박", "\xFF\xFE",
          "a bear is the heaviest"}) {
        INFO(said);
        const Mark mark = mark_answer(heaviest(), said);
        CHECK_FALSE(mark.understood);
        CHECK(mark.slots.empty());
        CHECK(mark.form_errors.empty());
        CHECK(mark.corrected.empty());
    }
}

TEST_CASE("mark: the opposite of what is asked is no answer, but is known for what it is") {
    const Mark lighter = mark_answer(heavier(), "I think the egg is Lighter than the apple!");
    CHECK_FALSE(lighter.understood);
    CHECK(lighter.slots.empty());
    CHECK(lighter.opposite_said == "lighter");
    CHECK(lighter.opposite_of == "heavier");
    const Mark lightest = mark_answer(heaviest(), "egg is the lightest");
    CHECK(lightest.opposite_said == "the lightest");
    CHECK(lightest.opposite_of == "the heaviest");
    CHECK(mark_answer(dearer(), "an egg is cheaper than an apple").opposite_of == "more expensive");
    CHECK(mark_answer(heavier(), "an egg weighs less").opposite_of == "heavier");
    CHECK(mark_answer(heaviest(), "an egg weighs the least").opposite_said == "the lightest");
    for (const char* said : {"an egg is heavier", "an egg is not lighter", "the sun is lighter",
                             "lighter", "an egg is slighter", "an egg is bigger", ""}) {
        INFO(said);
        CHECK(mark_answer(heavier(), said).opposite_said.empty());
    }
}

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

TEST_CASE("mark: slots hold the list's own words") {
    const Mark mark = mark_answer(heavier(), "Apples are heavier then EGG");
    CHECK(mark.slot("thing") == "apple");
    CHECK(mark.slot("other") == "egg");
    CHECK(mark.slot("nothing").empty());
    CHECK(mark_answer(biggest(), "MOON is the biggest").slot("body") == "Moon");
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

TEST_CASE("mark: the frame and the choices help without telling") {
    CHECK(sentence_frame(heaviest()) == "… is the heaviest.");
    CHECK(choices(heaviest()) ==
          std::vector<std::string>{"a watermelon", "an apple", "a banana", "an egg"});
    CHECK(choices(biggest()) ==
          std::vector<std::string>{"Jupiter", "Mars", "the Moon", "the Earth"});
}

TEST_CASE("mark: a counted noun goes with the number before it") {
    check_rows(compiled({"moons",
                         "How many moons?",
                         {"it has {number} <plural:moon>", "there are {number} <plural:moon>"},
                         {{"number", {"no", "one|1", "two", "8"}}}}),
               {
                   {"it has one moon", "", "It has one moon."},
                   {"it has 1 moon", "", "It has one moon."},
                   {"it has one moons", "R:NOUN:NUM", "It has one *moon*."},
                   {"it has one moones", "R:NOUN:INFL", "It has one *moon*."},
                   {"it has two moons", "", "It has two moons."},
                   {"it has two moon", "R:NOUN:NUM", "It has two *moons*."},
                   {"it has no moons", "", "It has no moons."},
                   {"there is one moon", "", "There is one moon."},
                   {"there are one moon", "R:VERB:SVA", "There *is* one moon."},
                   {"there is two moons", "R:VERB:SVA", "There *are* two moons."},
                   {"it has a two moons", "U:DET", "It has *two* moons."},
               });
}

TEST_CASE("mark: a number, a place and a direction are no nouns, so they take no article") {
    const Question where = compiled({"where",
                                     "Where is it easier?",
                                     {"it is easier {where}"},
                                     {{"where", {"far|far away", "near", "to the left"}}}});
    check_rows(where, {
                          {"far", "", "It is easier far."},
                          {"it is far", "", "It is far."},
                          {"it is a far", "U:DET", "It is *far*."},
                          {"to the left", "", "It is easier to the left."},
                      });
    CHECK(choices(where) == std::vector<std::string>{"far", "near", "to the left"});
}

TEST_CASE("mark: what is nearly English is understood, and the whole sentence is put right") {
    const Question ask = compiled({"ask",
                                   "Ask me!",
                                   {"how many moons does {planet} have", "what about {planet}"},
                                   {{"planet", {"Saturn", "the Earth"}}},
                                   {},
                                   {"how many moons {planet} (has|have)"}});
    check_rows(
        ask,
        {
            {"How many moons does Saturn have?", "", "How many moons does Saturn have?"},
            {"how many moons does Saturn has", "R:VERB:SVA", "How many moons does Saturn *have*?"},
            {"how many moons Saturn has?", "R:OTHER", "*How many moons does Saturn have*?"},
            {"what about the Earth", "", "What about the Earth?"},
        });
    const Mark mark = mark_answer(ask, "How many moons Saturn have");
    CHECK(mark.slot("planet") == "Saturn");
    CHECK(mark.gapped ==
          "How many moons does Saturn have?");  // nothing but a gap would help nobody
    CHECK(mark.main_error()->end == mark.said.size());
    CHECK_FALSE(mark.target_right());
    CHECK(example_sentence(ask) == "How many moons does Saturn have?");
}

TEST_CASE("mark: a frame of nothing but a gap, and a choice of one word, are no help") {
    const Question place = compiled({"place",
                                     "Where?",
                                     {"[it turns more at] {place} {own}"},
                                     {{"place", {"home", "school"}}, {"own", {"now"}}}});
    CHECK(sentence_frame(place).empty());
    CHECK(choices(place) == std::vector<std::string>{"home", "school"});
}

TEST_CASE("mark: a frame of nothing but blanks has the words that the question says, and \"the\"") {
    const NamedLists lists{{"material", {"metal", "wood"}}, {"feel", {"hard", "rough"}}};
    CHECK(sentence_frame(compiled(
              {"q", "What is metal like?", {"{material} is <adjective:{feel}>"}, lists})) ==
          "Metal is …");
    CHECK(
        sentence_frame(compiled(
            {"q", "What is metal like, and wood?", {"{material} is <adjective:{feel}>"}, lists})) ==
        "… is …");
    CHECK(sentence_frame(compiled({"q",
                                   "Which is it?",
                                   {"the {thing} is <adjective:{feel}>"},
                                   {{"thing", {"apple", "egg"}}, lists[1]}})) == "The … is …");
}
