#include "runtime/lesson/knowledge.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

const dialogue::Catalogue& words() {
    static const auto kWords = value_of(dialogue::Catalogue::parse(
        "knowledge.recast = We say: {sentence} {answer}\nknowledge.unknown = No. Ask: {example}\n"
        "knowledge.not_known = No.\nknowledge.first_mine = First mine.\n"));
    return kWords;
}

LessonDescription planets() {
    LessonDescription lesson;
    BodyDescription apple;
    apple.name = apple.noun = "apple";
    lesson.bodies = {apple};
    lesson.knowledge = {
        {"moons",
         {"how many <plural:moon> does {planet} have", "how many <plural:moon> has {planet} got"},
         {{"planet", {"Mars", "Earth|the Earth"}}},
         7},
        {"weight", {"how heavy is (it|the {thing})"}, {}, 9}};
    return lesson;
}

Knowledge compiled(const LessonDescription& lesson = planets()) {
    return value_of(value_of(Knowledge::compile(lesson, words())));
}

}  // namespace

TEST_CASE("knowledge: words find what they ask for, with its slots") {
    const Knowledge knowledge = compiled();
    const auto moons = value_of(knowledge.find("How many moons does the Earth have?"));
    CHECK(moons.knowledge == "moons");
    CHECK(moons.mark.slot("planet") == "Earth");
    CHECK(moons.mark.form_right());
    CHECK(knowledge.find("how many moons has Mars got")->knowledge == "moons");
    const auto weight = value_of(knowledge.find("how heavy is the apple"));
    CHECK(weight.knowledge == "weight");
    CHECK(weight.mark.slot("thing") == "apple");
    CHECK(knowledge.find("how heavy is it")->mark.slots.empty());
    for (const char* nothing :
         {"", "apple", "the apple", "how many moons", "who are you", "it is heavy", "\x01\xff"}) {
        INFO(nothing);
        CHECK_FALSE(knowledge.find(nothing));
    }
}

TEST_CASE("knowledge: an error of form is said back rightly before the answer") {
    const Knowledge knowledge = compiled();
    const auto right = value_of(knowledge.find("how many moons does Mars have"));
    CHECK(knowledge.told(right, "Two.") == "Two.");
    CHECK(knowledge.told(right, "") == "No.");
    const auto wrong = value_of(knowledge.find("how many moon does Mars have"));
    CHECK(knowledge.told(wrong, "Two.") == "We say: How many *moons* does Mars have? Two.");
    // Where the meaning alone was heard nothing is put right.
    const auto meant = value_of(knowledge.find("how many moon does Mars have", false));
    CHECK(meant.mark.slot("planet") == "Mars");
    CHECK(knowledge.told(meant, "Two.") == "Two.");
    LessonDescription heavy = planets();
    heavy.knowledge = {{"heavy", {"is the {thing} <adjective:heavy>"}, {}, 3}};
    const Knowledge asks = compiled(heavy);
    const auto hard = value_of(asks.find("is apple heavy"));
    CHECK(asks.told(hard, "Yes.") == "We say: Is *the apple* heavy? Yes.");
    CHECK(knowledge.first_mine() == "First mine.");
}

TEST_CASE("knowledge: who asks for nothing is told another thing each time that may be asked") {
    Knowledge knowledge = compiled();
    const std::string first = knowledge.unknown();
    const std::string second = knowledge.unknown();
    CHECK(first == "No. Ask: How many moons does Mars have?");
    CHECK(second.starts_with("No. Ask: How heavy is "));
    CHECK(knowledge.unknown() == first);
}

TEST_CASE("knowledge: what is nearly a question is said rightly as one about the same") {
    LessonDescription lesson = planets();
    lesson.knowledge[0].nearly = {"how many moons {planet} has"};
    // Both ask without a slot; each belongs to its own.
    lesson.knowledge[1].nearly = {"how heavy it is"};
    lesson.knowledge.push_back({"age", {"how old are you"}, {}, 11, {"how old you are"}});
    const Knowledge knowledge = compiled(lesson);
    const auto moons = value_of(knowledge.find("how many moons Mars has"));
    CHECK(moons.knowledge == "moons");
    CHECK(moons.mark.slot("planet") == "Mars");
    CHECK(knowledge.told(moons, "Two.") == "We say: *How many moons does Mars have*? Two.");
    REQUIRE(knowledge.find("how heavy it is"));
    CHECK(knowledge.find("how heavy it is")->knowledge == "weight");
    REQUIRE(knowledge.find("how old you are"));
    CHECK(knowledge.find("how old you are")->knowledge == "age");
}

TEST_CASE("knowledge: every way to ask comes with each word of its lists, and asks for its own") {
    const Knowledge knowledge = compiled();
    std::vector<std::string> said;
    for (const AskingSentence& sentence : knowledge.every_way()) {
        said.push_back(sentence.said);
        REQUIRE(knowledge.find(sentence.said));
        CHECK(knowledge.find(sentence.said)->knowledge == sentence.knowledge);
        CHECK(knowledge.find(sentence.said)->mark.form_right());
    }
    CHECK(said == std::vector<std::string>{
                      "How many moons does Mars have?", "How many moons does the Earth have?",
                      "How many moons has Mars got?", "How many moons has the Earth got?",
                      "How heavy is it?", "How heavy is the apple?"});
}

TEST_CASE("knowledge: a mistake is told at the line of what has it, also where it needs another") {
    const auto refusal = [&](const LessonDescription& lesson) {
        return refusal_of(Knowledge::compile(lesson, words()));
    };
    LessonDescription lesson = planets();
    lesson.knowledge.push_back({"last", {"what is {colour}"}, {}, 12});
    CHECK_THAT(refusal(lesson), Catch::StartsWith("lesson.lua:12: ") &&
                                    Catch::Contains("answer 1, letter 9: there is no list"));
    // Each by itself may be asked in 40 ways, both together in no more than 64.
    const auto many = [](const std::string& word) {
        std::vector<std::string> ways;
        for (int i = 0; i < 40; ++i) {
            ways.push_back(word + " number " + std::to_string(i));
        }
        return ways;
    };
    lesson = planets();
    lesson.knowledge = {
        {"one", many("apple"), {}, 20}, {"two", many("egg"), {}, 30}, {"three", {"pear"}, {}, 40}};
    CHECK_THAT(refusal(lesson), Catch::StartsWith("lesson.lua:30: "));
    lesson = planets();
    lesson.knowledge[1].nearly = {"how {planet}"};
    lesson.knowledge[1].lists = lesson.knowledge[0].lists;
    CHECK_THAT(refusal(lesson), Catch::StartsWith("lesson.lua:9: ") &&
                                    Catch::Contains("no answer says the same rightly"));
}

TEST_CASE("knowledge: a lesson that knows nothing has none, and mistakes are told at their line") {
    const auto nothing = Knowledge::compile({}, words());
    REQUIRE(nothing);
    CHECK_FALSE(*nothing);
    LessonDescription broken = planets();
    broken.knowledge[1].asked = {"how {heavy is it"};
    CHECK(error_of(Knowledge::compile(broken, words())).where == "lesson.lua:9");
    LessonDescription two_meanings = planets();
    two_meanings.knowledge[1].lists = {{"planet", {"Venus"}}};
    CHECK(error_of(Knowledge::compile(two_meanings, words())).where == "lesson.lua:9");
}

TEST_CASE("knowledge: a rule is put in its place in every way to ask, and means one thing in all") {
    LessonDescription lesson = planets();
    lesson.knowledge[1].asked = {"how heavy is <what>", "what does <what> weigh"};
    lesson.knowledge[1].rules = {{"what", "(it|the {thing})"}};
    const Knowledge knowledge = compiled(lesson);
    CHECK(knowledge.find("what does the apple weigh")->mark.slot("thing") == "apple");
    CHECK(knowledge.find("how heavy is it")->knowledge == "weight");
    lesson.knowledge[0].rules = {{"what", "this"}};
    CHECK(refusal_of(Knowledge::compile(lesson, words())) ==
          "lesson.lua:9: the rule \"what\" of what \"weight\" asks for has other words elsewhere; "
          "give it a name of its own.");
}

TEST_CASE("knowledge: words are put as a question by their first word or a question mark") {
    for (const char* asks : {"what is it", "Is it made of glass", "  does Mars have moons?", "How?",
                             "what's this", "it is heavy?", "Tell me what it is"}) {
        INFO(asks);
        CHECK(fulcrum::runtime::begins_as_question(asks));
    }
    for (const char* says : {"it is made of glass", "the apple is heavier", "isn't it", "whatever",
                             "", "   ", "metal"}) {
        INFO(says);
        CHECK_FALSE(fulcrum::runtime::begins_as_question(says));
    }
}

TEST_CASE("knowledge: what asks something of its own, and what is an answer that lacks a word") {
    using fulcrum::runtime::asks_something;
    for (const char* asks :
         {"What colour is it?", "what colour is it", "Can I eat it?", "can i eat it", "Is it red?",
          "is there a dog?", "does it float", "And why?", "Please tell me more", "When is it over",
          "Have you got a dog?", "how many are there", "Whose is it?", "do you like it"}) {
        INFO(asks);
        CHECK(asks_something(asks));
    }
    for (const char* says :
         {"", "  ", "?", "the apple?", "is on the block", "is the lift", "has two moons",
          "can float", "when the wind stops", "is there one moon", "it is heavy?", "why", "does it",
          "please", "because it is light", "I don't know what it is"}) {
        INFO(says);
        CHECK_FALSE(asks_something(says));
    }
}
