#include "tests/unit/dialogue/checking/checked.h"

using namespace fulcrum::dialogue;

TEST_CASE("free articles: none behind no") {
    check_rows({{"There is no the wind.", "U:DET => There is no wind."},
                {"It has no a tail.", "U:DET => It has no tail."}});
    check_right({"No, the wind is strong.", "No the wind."});
}

TEST_CASE("free articles: by sound, before what can't be counted, said twice") {
    check_rows({{"I think it is a apple.", "R:DET => I think it is *an* apple."},
                {"It is an uniform.", "R:DET => It is *a* uniform."},
                {"An hour and an moon.", "R:DET => An hour and *a* moon."},
                {"I need a advice.", "U:DET => I need advice."},
                {"I have a new information.", "U:DET => I have new information."},
                {"It is made of a metal.", "U:DET => It is made of metal."},
                {"The rock is a hard.", "U:DET => The rock is hard."},
                {"I felt the a rock.", "U:DET => I felt the rock."},
                {"The Jupiter is big.", "U:DET => Jupiter is big."},
                {"It is a biggest planet.", "R:DET => It is *the* biggest planet."}});
}

TEST_CASE("free articles: this and these agree with their noun") {
    check_rows({{"These rock is hard.", "R:DET => *This* rock is hard."},
                {"I like this planets.", "R:DET => I like *these* planets."},
                {"This two moons are small.", "R:DET => *These* two moons are small."},
                {"I felt a moons.", "R:NOUN:NUM => I felt a *moon*."}});
}

TEST_CASE("free articles: good English that looks alike") {
    check_right({"An hour ago I had an MRI.", "It is a one-way street.", "She got an A in English.",
                 "A herb, an herb.", "I have a sports car.", "I have information.",
                 "Jupiter is big.", "The Jupiter mission is new.", "He gave me a means of travel.",
                 "This rocks!", "I like these fish.", "It is a European car.",
                 "A few moons are small.", "The best of them is a best friend."});
}

TEST_CASE(
    "free articles: a missing one is marked where the judge finds the sentence better with it") {
    const auto judged = [](int without, int with) {
        EnglishChecker checker(opened_lexicon(),
                               std::make_unique<ToldJudge>(std::map<std::string, int, std::less<>>{
                                   {"I saw moon.", without}, {"I saw a moon.", with}}));
        return checker.check("I saw moon.").corrected;
    };
    CHECK(judged(1, 0) == "I saw a moon.");
    CHECK(judged(0, 0) == "I saw moon.");
    CHECK(judged(2, 1) == "I saw moon.");
    CHECK(checked("I saw moon.") == "=> I saw moon.");
}

TEST_CASE(
    "article rules: a thing that stands there has an article, stuff and answers of one word have "
    "none") {
    EnglishChecker checker = words_alone();
    checker.set_things({"egg", "block", "rock", "spaceship"});
    const auto marked = [&](const char* text) { return checker.check(text).marked; };
    CHECK(marked("Egg is heavier than the spaceship.") ==
          "*The egg* is heavier than the spaceship.");
    CHECK(marked("The spaceship is heavier than egg.") ==
          "The spaceship is heavier than *the* egg.");
    CHECK(marked("The heaviest one is egg.") == "The heaviest one is *the* egg.");
    CHECK(marked("Yes, egg is heavier.") == "Yes, *the* egg is heavier.");
    CHECK(marked("Both egg and the block fall.") == "Both *the* egg and the block fall.");
    CHECK(marked("It is on top of blue block.") == "It is on top of *the* blue block.");
    CHECK(marked("The Earth pulls egg.") == "The Earth pulls *the* egg.");
    for (const char* right :
         {"Egg.", "The egg is heavier than a spaceship.", "My egg is on the block.",
          "It is made of rock.", "The spaceship is rock.", "It is one egg.", "Eggs are light.",
          "An apple and egg salad is good.", "Egg yolk is yellow.", "Which egg is heavier?",
          "The two eggs and the block are near this spaceship.", "It is Egg.",
          "The spaceship's block is heavy.", "The egg block is blue."}) {
        CHECK(marked(right) == std::string(right));
    }
    checker.set_things({"tail", "top", "line", "hand"});
    // Where it is wanted there is none yet.
    CHECK(marked("It needs longer tail.") == "It needs *a* longer tail.");
    CHECK(marked("It wants the a tail.") == "It wants a tail.");
    CHECK(marked("It moves nearer hand.") == "It moves nearer *the* hand.");
    CHECK(marked("I give it tail.") == "I give it *the* tail.");
    CHECK(marked("It is the tension of line.") == "It is the tension of *the* line.");
    CHECK(marked("Push it towards hand.") == "Push it towards *the* hand.");
    CHECK(marked("It is on top of the block.") == "It is on top of the block.");
    CHECK(marked("It is a kind of line.") == "It is a kind of line.");
    // Where no egg stands, one may speak of food.
    CHECK(checked("Egg is heavier than bread.") == "=> Egg is heavier than bread.");
}

TEST_CASE("article rules: one that is compared is a certain one") {
    check_rows({{"The egg is heavier one.", "M:DET => The egg is *the* heavier one."},
                {"Heavier one is the egg.", "M:DET => *The heavier* one is the egg."},
                {"It has a two moon.", "U:DET R:NOUN:NUM => It has two *moons*."}});
    check_right({"The egg is the heavier one.", "I want a heavier one.", "Is it a heavier one?",
                 "It is heavier one day.", "It has a two door car."});
}

TEST_CASE(
    "free articles: a thing that stands there has one among two, behind as, and where it is acted "
    "on") {
    EnglishChecker checker = words_alone();
    checker.set_things({"watermelon", "apple", "line", "tail"});
    const auto corrected = [&](std::string_view text) { return checker.check(text).corrected; };
    CHECK(corrected("Apple and a watermelon are alike.") ==
          "the Apple and a watermelon are alike.");
    CHECK(corrected("An apple is not as heavy as watermelon.") ==
          "An apple is not as heavy as the watermelon.");
    CHECK(corrected("We would change line.") == "We would change the line.");
    CHECK(corrected("The tension comes from line.") == "The tension comes from the line.");
    CHECK(corrected("Make tail longer.") == "Make the tail longer.");
    for (const std::string right :
         {"A longer line would help.", "It has no tail.", "It is as heavy as any apple.",
          "We made it from line.", "The apple and watermelon are alike."}) {
        CHECK(corrected(right) == right);
    }
}
