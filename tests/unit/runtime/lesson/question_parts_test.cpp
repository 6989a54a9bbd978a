#include "runtime/lesson/free_english.h"
#include "runtime/lesson/question_dialogue.h"
#include "runtime/lesson/question_notes.h"
#include "runtime/lesson/questions.h"
#include "runtime/lesson/sentence_form.h"
#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

/// The things that the lesson is asked about, in order.
std::vector<std::string> asked_of(const QuestionTurn& turn) {
    std::vector<std::string> things;
    for (const LessonEvent& event : turn.events) {
        if (const auto* judge = std::get_if<JudgeEvent>(&event)) {
            things.push_back(judge->slots.empty() ? "" : judge->slots.back().second);
        }
    }
    return things;
}

/// Says it where the apple is the heaviest; what came of it.
QuestionTurn say(QuestionDialogue& dialogue, const std::string& words) {
    const QuestionTurn heard = dialogue.hear(words, 1.0, 0.0);
    QuestionTurn last;
    for (const std::string& thing : asked_of(heard)) {
        CHECK_FALSE(last.answer);
        last = dialogue.judge("heaviest", thing == "apple", 0.0);
    }
    REQUIRE(last.answer);
    return last;
}

const NoteSources kSilent{{}, "/nowhere"};

LessonDescription with_answers(std::vector<std::string> answers) {
    LessonDescription lesson = two_things();
    lesson.questions[0].answers = std::move(answers);
    lesson.questions[0].again = "Weigh them again.";
    return lesson;
}

// The one note; fails the test where there is none, or another.
std::string only_note(const LessonDescription& lesson, const NoteSources& sources = kSilent) {
    const auto notes = question_notes(lesson, sources);
    REQUIRE(notes.size() == 1);
    return notes[0];
}

LessonDescription without_hint() {
    LessonDescription lesson = two_things();
    lesson.questions[0].again.clear();
    return lesson;
}

// Where these words lie, as a dictionary of sounds.
constexpr const char* kSounds =
    "the DH AH\nis IH Z\nheavy HH EH V IY\negg EH G\napple AE P AH L\nthings TH IH NG Z\n"
    "thighs TH AY Z\n";

}  // namespace

TEST_CASE("question claims: no difference where nothing is right, and all is asked for it") {
    QuestionDialogue dialogue{compile_questions(two_questions()).value(), words()};
    (void)dialogue.ask("heaviest", 0.0);
    const QuestionTurn turn = say(dialogue, "they weigh the same");
    CHECK_FALSE(turn.answer->right);
    CHECK(turn.answer->mark.understood);
    REQUIRE(turn.events.size() == 1);
    const auto& answered = std::get<AnsweredEvent>(turn.events[0]);
    CHECK_FALSE(answered.right);
    REQUIRE(answered.slots.size() == 1);
    CHECK(answered.slots[0].second == "egg");  // a thing that is not right, as any wrong answer has
    CHECK(dialogue.state() == QuestionState::set_aside);
}

TEST_CASE("question claims: what is ruled out truly is told nobody, and the question goes on") {
    QuestionDialogue dialogue{compile_questions(two_questions()).value(), words()};
    (void)dialogue.ask("heaviest", 0.0);
    const QuestionTurn open = say(dialogue, "the egg is not the heaviest");
    CHECK(open.events.empty());
    CHECK_FALSE(open.answer->right);
    CHECK_FALSE(open.answer->mark.understood);
    CHECK(dialogue.listens());
    const QuestionTurn wrong = say(dialogue, "the apple is not the heaviest");
    CHECK_FALSE(wrong.answer->right);
    CHECK(wrong.answer->mark.understood);
    CHECK(wrong.events.size() == 1);
}

TEST_CASE("question notes: a question without a hint is told with its line") {
    LessonDescription lesson = without_hint();
    CHECK(
        only_note(lesson) ==
        "lesson.lua:7: question \"heaviest\": it has no `again`, and game.ask no `hint` for it, so "
        "after a wrong answer nothing helps; give it one of them.");
    lesson.questions[0].again = "Weigh them again.";
    CHECK(question_notes(lesson, kSilent).empty());
}

TEST_CASE("question notes: what the review finds has the question's line") {
    const std::string notes =
        only_note(with_answers({"the {thing} is [very] heavy", "the {thing} is heavy"}));
    CHECK_THAT(notes, Catch::StartsWith("lesson.lua:7: question \"heaviest\": answer 2 is never"));
    CHECK_THAT(notes, Catch::EndsWith("."));
}

TEST_CASE("question notes: an answer that would be said back without its subject is told") {
    CHECK_THAT(only_note(with_answers({"[it] needs a tail"})),
               Catch::EndsWith("answer 1: \"Needs a tail.\" has no subject; let what stands "
                               "before the verb be no part that may be left out."));
    CHECK(question_notes(with_answers({"(it|the {thing}) is in the bowl", "[it is] in the bowl",
                                       "turn it round", "is it heavy?"}),
                         kSilent)
              .empty());
}

TEST_CASE("question notes: a hint that says a word twice is told") {
    const LessonDescription lesson = with_answers({"is the {thing} on the apple"});
    check_says(only_note(lesson), {"\", which has \"apple\" twice; give the first of"});
    CHECK(question_notes(with_answers({"the {thing} is on the {thing:other}"}), kSilent).empty());
}

TEST_CASE("question notes: of a question that is asked with a slip of the pen only that is told") {
    LessonDescription lesson = without_hint();
    NoteSources sources = kSilent;
    sources.texts = {"L:question \"heaviest\" { }\ngame.ask(\"haeviest\", { hint = \"Look.\" })"};
    CHECK_THAT(only_note(lesson, sources),
               Catch::EndsWith("nothing asks it; write game.ask \"heaviest\", where "
                               "\"haeviest\" stands now."));
    sources.texts = {"L:question \"heaviest\" { }\ngame.ask(\"colour\", { hint = \"Look.\" })"};
    CHECK(question_notes(lesson, sources).size() == 2);
}

TEST_CASE("question notes: words that no dictionary and no rule can say are named") {
    const ScratchFolder folder;
    folder.write("sounds", kSounds);
    const std::string sounds = folder.file("sounds");
    const std::string notes =
        only_note(with_answers({"the {thing} is heavy and zorbly"}), {{}, sounds});
    CHECK_THAT(notes,
               Catch::StartsWith("lesson.lua:7: ") && Catch::Contains("nobody knows how to say"));
    check_says(notes, {"\"zorbly\""});
    CHECK_THAT(notes, !Catch::Contains("\"egg\"") && !Catch::Contains("\"heavy\""));

    // Of a list's word not its plural as well, which only the program made.
    LessonDescription lesson = with_answers({"the {thing} is heavy", "the {odd} is heavy"});
    lesson.questions.front().lists.emplace_back("odd", std::vector<std::string>{"zzyzx"});
    CHECK_THAT(only_note(lesson, {{}, sounds}),
               Catch::Contains("\"zzyzx\"") && !Catch::Contains("zzyzxes"));
}

TEST_CASE("question notes: a slip of the pen is told with what was meant, a foreign letter too") {
    const ScratchFolder folder;
    folder.write("sounds", kSounds);
    const std::string sounds = folder.file("sounds");
    const auto noted = [&](const std::string& word) {
        std::string all;
        for (const std::string& note :
             question_notes(with_answers({"the {thing} is heavy " + word}), {{}, sounds})) {
            all += note + "\n";
        }
        return all;
    };
    check_says(noted("thigns"),
               {"\"thigns\" is no word that is known here; did you mean \"things\"?\n"});
    check_says(noted("caf\xC3\xA9"),
               {"\"caf\xC3\xA9\" has the letter \"\xC3\xA9\", which English has not"});
    check_says(noted("met\xD0\xB0l"), {"has the letter \"\xD0\xB0\", which English has not"});
    CHECK_THAT(noted("zorblyq"),
               Catch::Contains("nobody knows how to say") && Catch::Contains("\"zorblyq\""));
}

TEST_CASE("question notes: questions that do not compile have none") {
    CHECK(question_notes(with_answers({"the {thng} is heavy"}), kSilent).empty());
}

TEST_CASE("question notes: a hint of game.ask is as good as `again`") {
    LessonDescription lesson = without_hint();
    const auto noted = [&](const std::string& text) {
        return question_notes(lesson, {{"L:question \"heaviest\" { }", text}, "/nowhere"}).size();
    };
    CHECK(noted("game.ask(\"heaviest\", { hint = \"Lift them.\" })") == 0);
    CHECK(noted("game.ask(\"heaviest\", { solution = \"It is.\" })") == 1);
    CHECK(noted("-- game.ask(\"heaviest\", { hint = \"Lift them.\" })\nstory.ask(world, "
                "\"heaviest\")") == 1);
    CHECK(noted("for _, q in ipairs { \"heaviest\" } do game.ask(q, { hint = \"Lift.\" }) end") ==
          0);
}

TEST_CASE("question notes: a question that nothing asks is told") {
    LessonDescription lesson = two_things();
    lesson.questions[0].again = "Weigh them again.";
    check_says(
        only_note(lesson, {{"L:question \"heaviest\" { }\ngame.ask \"heavist\""}, "/nowhere"}),
        {"question \"heaviest\": nothing asks it; write game.ask \"heaviest\""});
    CHECK(question_notes(lesson, {{"L:question 'heaviest' { }\ngame.ask 'heaviest'"}, "/nowhere"})
              .empty());
    CHECK(question_notes(
              lesson,
              {{"L:question \"heaviest\" { }\nfor i = 1, 3 do game.ask(names[i]) end"}, "/nowhere"})
              .empty());
    // Declared by a name that is put together.
    CHECK(question_notes(lesson, {{"L:question(\"heav\" .. \"iest\") { }\ngame.ask(\"heaviest\")"},
                                  "/nowhere"})
              .empty());
}

TEST_CASE("question notes: a damaged dictionary of sounds is told once, and no more is lost") {
    const ScratchFolder folder;
    folder.write("words.dict", "egg EH G\nthe DH A");
    LessonDescription lesson = without_hint();
    const auto notes = question_notes(lesson, {{}, folder.file("words.dict")});
    REQUIRE(notes.size() == 2);
    CHECK(notes[0] == "the dictionary of sounds " + folder.file("words.dict") +
                          ": line 2 has \"A\", which is no sound of English; the file may be "
                          "damaged there, get it anew.");
    check_says(notes[1], {"it has no `again`"});
    CHECK(question_notes(lesson, {{}, folder.path().string()}).size() == 2);
}

TEST_CASE("free English: opened, it finds errors by its words and by its grammar") {
    const auto check = value_of(open_free_english({"egg"}));
    CHECK(check("it have two moon").corrected == "it has two moons");
    CHECK(check("I saw moon.").corrected == "I saw a moon.");
    CHECK(check("It has two moons.").errors.empty());
    CHECK(check("Egg is heavier.").corrected == "The egg is heavier.");
}

TEST_CASE("free English: things are bodies and what questions call so, by the last word") {
    LessonDescription lesson;
    for (const char* noun : {"egg", "", "wooden block", "Sun", "metal block"}) {
        lesson.bodies.emplace_back().noun = noun;
    }
    lesson.questions.emplace_back().lists = {{"thing", {"apple|red apple", "egg"}},
                                             {"number", {"two"}}};
    CHECK(things_of(lesson) == std::vector<std::string>{"egg", "block", "apple"});
}

TEST_CASE("free English: things are also the words that all answers say with an article") {
    LessonDescription lesson;
    QuestionDescription& question = lesson.questions.emplace_back();
    question.answers = {"push at the {place}",
                        "it needs a {missing}",
                        "it has no {missing}",
                        "it is near the {goal}",
                        "{goal}",
                        "it is the {force}",
                        "(a|the) {part}",
                        "it needs a {size} tail"};
    question.lists = {{"place", {"side|rim", "pole|top"}},
                      {"missing", {"tail|kite tail"}},
                      {"goal", {"hand"}},
                      {"force", {"weight", "wind"}},
                      {"part", {"knot"}},
                      {"size", {"longer|long", "short"}},
                      {"nowhere", {"book"}}};
    CHECK(things_of(lesson) == std::vector<std::string>{"side", "pole", "tail", "wind", "knot"});
}

TEST_CASE("free English: things are also the nouns that a lesson says with an article each time") {
    LessonDescription lesson;
    QuestionDescription& question = lesson.questions.emplace_back();
    question.answers = {"pull the (line|string) near the end",
                        "(my|the) hand feels the drag",
                        "[the] cloth is <adjective:light>",
                        "on top of the kite",
                        "it is in the top",
                        "make the {part} longer"};
    question.rules = {{"of", "[(of|in) the (line|rope|air)]"}};
    question.lists = {{"part", {"knot"}}, {"nothing", {"kite"}}};
    CHECK(things_of(lesson) ==
          std::vector<std::string>{"knot", "end", "hand", "line", "rope", "string"});
}

TEST_CASE("sentence form: what is amiss is told as a sentence's end, what is good not at all") {
    const auto check = value_of(open_free_english({"egg"}));
    CHECK(tell_form(check, "The egg is heavy. Lift it!").empty());
    CHECK(tell_form(check, "").empty());
    CHECK(tell_form(check, "Lift it. It have two moon.") ==
          "is no good English; better is \"Lift it. It has two moons.\"");
    CHECK(tell_form(check, "It is is heavy.") ==
          "has \"is\" twice; take one out, or the form of grammar that brings it");
    CHECK(tell_form(check, "It weighs six million million tonnes.").empty());
    CHECK(tell_form({}, "It have two moon.").empty());
}
