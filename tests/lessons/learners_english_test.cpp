// What pupils of level A2 say to the lessons' own questions: each is understood for what it means, and its form is marked.
#include "dialogue/marking/mark.h"
#include "runtime/lesson/questions.h"
#include "runtime/lua/process/lesson_process.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <string>
#include <vector>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

std::map<std::string, dialogue::Question> questions_of(const std::string& lesson) {
    LessonFiles files;
    files.folder = std::filesystem::path(FULCRUM_SCENARIOS) / lesson;
    files.library = std::filesystem::path(FULCRUM_SCENARIOS) / "../scripts/lib";
    LessonProcessOptions options;
    options.executable = FULCRUM_PROGRAM;
    options.load_wall_s = options.answer_wall_s = 30.0;
    auto process = LessonProcess::start(files, options);
    REQUIRE(process);
    auto questions = compile_questions((*process)->description());
    REQUIRE(questions);
    return std::move(*questions);
}

/// Words, and whether their form is right; "!" before them: an error is to be found.
void check_all(const dialogue::Question& question, const std::string& slot,
               const std::string& value, const std::vector<std::string>& said) {
    for (std::string words : said) {
        const bool has_error = words.front() == '!';
        words.erase(0, has_error ? 1 : 0);
        const dialogue::Mark mark = dialogue::mark_answer(question, words);
        std::string codes;
        for (const dialogue::FormError& error : mark.form_errors) {
            codes += std::string(error.errant()) + ' ';
        }
        INFO(question.id << ": " << words << " -> " << mark.emphasised << ' ' << codes);
        CHECK(mark.understood);
        CHECK(mark.slot(slot) == value);
        CHECK(mark.form_right() != has_error);
    }
}

void check_none(const dialogue::Question& question, const std::vector<std::string>& said) {
    for (const std::string& words : said) {
        INFO(question.id << ": " << words);
        CHECK_FALSE(dialogue::mark_answer(question, words).understood);
    }
}

}  // namespace

TEST_CASE("learners' English: the lever") {
    auto questions = questions_of("lever");
    const auto& near_far = questions.at("near_far");
    check_all(near_far, "far", "far",
              {"far",
               "Far.",
               "far from the support",
               "far away from the support",
               "far away",
               "it is easier far from the support",
               "It's easier far from it",
               "it is easier to press far from the support",
               "I think it is easier far away",
               "I press far from the support",
               "press far away",
               "you must press far from it",
               "it is easier when I press far from the support",
               "it is easier if you press far away",
               "!further away is easier",
               "a long way",
               "far because the arm is long",
               "I need less force far from the support",
               "!far of the support",
               "!far from support",
               "!it easier far from the support",
               "!it is more easy far from the support",
               "!it is easyer far",
               "!far is easier",
               "!it is easier far the support",
               "!it is a far",
               "!when I press far is easier",
               "!it's easier farr from the support",
               "!far from a support"});
    check_all(near_far, "near", "near",
              {"near", "near the support", "close to the support", "it is easier near the support",
               "next to it", "it is easier close to the support", "closer", "I press near it",
               "!it is more easy near the support"});
    check_none(near_far, {"not far", "I don't know", "banana", "it is not easier far away"});
    CHECK(dialogue::mark_answer(near_far, "far").corrected == "It is easier far from the support.");
    CHECK(dialogue::mark_answer(near_far, "it is harder near the support").opposite_of == "easier");

    const auto& way = questions.at("which_way");
    check_all(way, "goal", "Earth",
              {"to the Earth",
               "to Earth",
               "the Earth",
               "it must go to the Earth",
               "closer to the Earth",
               "nearer to the Earth",
               "it must go closer to the Earth",
               "near the Earth",
               "towards the Earth",
               "the support must go to the Earth",
               "it has to move to the Earth",
               "move it to the Earth",
               "to the left",
               "it goes to the left",
               "we must move the support closer to the Earth",
               "you should move it towards the Earth",
               "it must be near the Earth",
               "!it must to go to the Earth",
               "!the support must goes to the Earth",
               "!support must go to the Earth",
               "!must go to the Earth",
               "!go to the Earth",
               "!it go to the Earth",
               "!at the Earth"});
    check_all(way, "goal", "hand",
              {"to my hand", "to your hand", "my hand", "it must go to my hand",
               "closer to my hand", "to the right", "!it must go to hand"});
    check_none(way, {"not to the Earth", "up", "I want to go home"});

    const auto& strong = questions.at("how_strong");
    check_all(strong, "number", "one",
              {"1",
               "one",
               "1 N",
               "1N",
               "1 newton",
               "one newton",
               "I need one newton",
               "I need 1 N",
               "it is one newton",
               "I need 1 newton.",
               "only one newton",
               "we need one newton",
               "you need 1 newton",
               "I must press with one newton",
               "one newton is enough",
               "I think it is 1 N",
               "just one",
               "I need only one newton",
               "!1 newtons",
               "!I need 1 newtons",
               "!need one newton",
               "!I am need one newton",
               "!it needs 1 newton",
               "!with one newton",
               "!I needs one newton"});
    check_all(strong, "number", "one thousand",
              {"1000", "a thousand newtons", "one thousand newtons", "1000 N",
               "I need 1000 newtons", "!I need 1000 newton", "!1000 newton"});
    check_all(strong, "number", "one hundred", {"100 newtons", "a hundred newtons"});
    check_none(strong, {"much", "I am strong", "not one"});
    CHECK(dialogue::mark_answer(strong, "1 newtons").emphasised == "One *newton*.");
    CHECK(dialogue::mark_answer(strong, "1").corrected == "I need one newton.");
}

TEST_CASE("learners' English: the solar system, counting") {
    auto questions = questions_of("solar-system");
    const auto& count = questions.at("planets");
    check_all(count, "number", "eight",
              {"8",
               "eight",
               "eight planets",
               "8 planets",
               "there are eight planets",
               "there are eight",
               "I see eight planets",
               "I can see 8 planets",
               "we have 8 planets",
               "eight planets go round the Sun",
               "eight planets go around the Sun",
               "8 planets move round it",
               "the Sun has eight planets",
               "I counted eight",
               "I think there are 8 planets",
               "the answer is eight",
               "it has eight planets",
               "there are eight planets in the solar system",
               "!eight planet",
               "!there is eight planets",
               "!there are eight planet",
               "!it is eight planets",
               "!are eight planets",
               "!eight planets goes round the Sun",
               "!they are eight",
               "!there have eight planets",
               "!eight planetes"});
    check_all(count, "number", "nine", {"nine planets", "9"});
    check_none(count, {"many", "not eight", "planets", "I like planets"});

    const auto& one = questions.at("moons_earth");
    check_all(one, "number", "one",
              {"1",
               "one",
               "one moon",
               "a moon",
               "one Moon",
               "it has one moon",
               "it has a moon",
               "the Earth has one moon",
               "Earth has one moon",
               "it has only one moon",
               "only one moon",
               "there is one moon",
               "there's one moon",
               "I see one moon",
               "it has got one moon",
               "just one",
               "!one moons",
               "!it has one moons",
               "!there are one moon",
               "!it have one moon",
               "!it one moon",
               "!is one moon",
               "!one moon has the Earth"});
    CHECK(dialogue::mark_answer(one, "one moons").emphasised == "One *moon*.");
    const auto& two = questions.at("moons_mars");
    check_all(two, "number", "two",
              {"2", "two", "two moons", "it has two moons", "Mars has two moons",
               "Mars has got two moons", "there are two moons", "it's got two moons", "!two moon",
               "!it has two moon", "!there is two moons", "!the Mars has two moons",
               "!Mars have two moons", "!it has two mooons"});
    check_all(two, "number", "no", {"no moons", "it has no moons", "zero", "none"});
    check_none(two, {"it has not two moons", "small moons", "Phobos"});
}

TEST_CASE("learners' English: the solar system, asking and comparing") {
    auto questions = questions_of("solar-system");
    const auto& ask = questions.at("your_turn");
    check_all(ask, "planet", "Saturn",
              {"how many moons does Saturn have?",
               "How many moons has Saturn got",
               "how many moons are there around Saturn",
               "how big is Saturn?",
               "how far is Saturn from the Sun?",
               "how heavy is Saturn",
               "how far away is Saturn",
               "how long is a day on Saturn?",
               "how long is a year on Saturn",
               "tell me how many moons Saturn has",
               "please, how large is Saturn?",
               "!How many moons Saturn has?",
               "!how many moons Saturn have",
               "!how many moon does Saturn have",
               "!how many moons does Saturn has",
               "!how many moons do Saturn have",
               "!how much moons does Saturn have",
               "!how many moons have Saturn",
               "!Saturn has how many moons",
               "!how many moons is Saturn",
               "!how big Saturn is",
               "!how many moons there are Saturn",
               "!how many moons Saturn",
               "!how far Saturn from the Sun"});
    check_all(ask, "planet", "Earth",
              {"how many moons does the Earth have", "how many moons does Earth have"});
    check_none(ask, {"why is Saturn nice", "hello", "how many rings does Saturn have"});
    CHECK(dialogue::mark_answer(ask, "How many moons Saturn has?").emphasised ==
          "*How many moons does Saturn have*?");

    const auto& place = questions.at("side_or_pole");
    check_all(place, "place", "side",
              {"side", "the side", "at the side", "on the side", "it turns more at the side",
               "it turns faster at the side", "at the side it turns more", "more at the side",
               "when I push at the side", "at the equator",
               "the planet turns more when I push at the side", "I push at the side",
               "it is at the side", "!in the side", "!it turn more at the side",
               "!the side turns more", "!at side", "!it turns more at side", "!side is more"});
    check_all(place, "place", "pole",
              {"near the pole", "at the pole", "the pole", "on the top", "at the North Pole",
               "!near pole"});
    check_none(place, {"not at the side", "both", "I don't know"});

    const auto& hard = questions.at("harder");
    check_all(hard, "planet", "Jupiter",
              {"Jupiter", "Jupiter is harder", "Jupiter is harder to turn",
               "Jupiter is harder than the Earth", "Jupiter is harder to turn than Earth",
               "Jupiter is more difficult to turn", "it is Jupiter", "it's harder to turn Jupiter",
               "Jupiter turns more slowly", "I think Jupiter is harder because it is big",
               "!Jupiter is more hard", "!Jupiter is hardest", "!Jupiter is hard to turn",
               "!Jupiter harder", "!the Jupiter is harder", "!Jupiter is more harder to turn",
               "!Jupiter is harder then the Earth", "!Jupiter is harder for turn",
               "!Jupiter turn more slow"});
    check_none(hard, {"Jupiter is not harder", "Mars", "the Sun"});
    CHECK(dialogue::mark_answer(hard, "the Earth is easier to turn").opposite_of == "harder");
}
