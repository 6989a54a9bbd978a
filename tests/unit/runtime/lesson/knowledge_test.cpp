#include "runtime/lesson/knowledge.h"

#include "runtime/lesson/questions.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

const dialogue::Catalogue& words() {
    static const auto kWords = value_of(dialogue::Catalogue::parse(
        "knowledge.unknown = No. Ask: {example}\nknowledge.first_mine = First mine.\n"));
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

Knowledge compiled() {
    return value_of(value_of(Knowledge::compile(planets(), words())));
}

}  // namespace

TEST_CASE("knowledge: who asks for nothing is told another thing each time that may be asked") {
    Knowledge knowledge = compiled();
    const std::string first = knowledge.unknown();
    const std::string second = knowledge.unknown();
    CHECK(first == "No. Ask: How many moons does Mars have?");
    CHECK(second.starts_with("No. Ask: How heavy is "));
    CHECK(knowledge.unknown() == first);
    CHECK(knowledge.first_mine() == "First mine.");
}

TEST_CASE("knowledge: what would answer the open question, or comes near to it, is given away") {
    LessonDescription lesson = planets();
    QuestionDescription asked;
    asked.id = "heavier";
    asked.prompt = "Which block is heavier?";
    asked.answers = {"[the] {thing} is heavier", "it is on top"};
    asked.lists = {{"thing", {"wooden block|wood", "metal block"}}};
    lesson.questions = {asked};
    const auto questions = value_of(compile_questions(lesson));
    const dialogue::Question& question = questions.begin()->second;
    for (const auto& [words, told] : {std::pair{"is it heavy", "Yes, it is."},
                                      {"is it light", "No, it isn't."},
                                      {"how heavy is the metal block", "It weighs 3.4 newtons."},
                                      {"what is this", "This is Wood, from a tree."},
                                      {"where is it", "Look. It is on top."}}) {
        CAPTURE(words, told);
        CHECK(gives_away(question, words, told));
    }
    for (const auto& [words, told] :
         {std::pair{"what is a newton", "It is as much as an apple weighs."},
          {"what is this", "This is a woodpecker."},
          {"how many are there", "There are three."}}) {
        CAPTURE(words, told);
        CHECK_FALSE(gives_away(question, words, told));
    }
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

TEST_CASE("knowledge: too many ways to ask are told at the line of the one that is too much") {
    // Each by itself may be asked in 40 ways, both together in no more than 64.
    const auto many = [](const std::string& word) {
        std::vector<std::string> ways;
        for (int i = 0; i < 40; ++i) {
            ways.push_back(word + " number " + std::to_string(i));
        }
        return ways;
    };
    LessonDescription lesson = planets();
    lesson.knowledge = {
        {"one", many("apple"), {}, 20}, {"two", many("egg"), {}, 30}, {"three", {"pear"}, {}, 40}};
    CHECK_THAT(refusal_of(Knowledge::compile(lesson, words())),
               Catch::StartsWith("lesson.lua:30: "));
}

TEST_CASE("knowledge: a lesson that knows nothing has none") {
    CHECK_FALSE(value_of(Knowledge::compile({}, words())));
}
