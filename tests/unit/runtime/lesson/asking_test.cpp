#include "dialogue/marking/mark_answer.h"
#include "runtime/lesson/answer_choices.h"
#include "runtime/lesson/past_answers.h"
#include "runtime/lesson/said_before.h"
#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/progress/diary.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

dialogue::Question heaviest(const std::vector<std::string>& things) {
    return value_of(
        dialogue::compile_question({"heaviest",
                                    "Which one is the heaviest?",
                                    {"[a|an|the] {thing} is the <superlative:heavy> [one]"},
                                    {{"thing", things}}}));
}

Expected<bool> is_watermelon(const AnswerSlots& slots) {
    return slots == AnswerSlots{{"thing", "watermelon"}};
}

constexpr std::int64_t kDay_ms = 86'400'000;

/// The diary's attempts, a day apart from the first of January 1970 on.
ProgressData dated(const Diary& diary) {
    ProgressData data = diary.data;
    std::int64_t day = 0;
    for (AttemptRecord& attempt : data.attempts) {
        attempt.said_utc_ms = kDay_ms * day++;
    }
    return data;
}

const PastAnswers& of(const std::vector<PastAnswers>& past, const std::string& question) {
    const auto found = std::ranges::find(past, question, &PastAnswers::question);
    REQUIRE(found != past.end());
    return *found;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("answer choices: one is right, all are right in form, and no two mean the same") {
    const auto question = heaviest({"watermelon", "apple", "banana", "egg", "stone", "feather"});
    const auto choices = value_of(make_choices(question, is_watermelon));
    REQUIRE(choices.size() == kMostChoices);
    CHECK(std::ranges::count(choices, true, &AnswerChoice::right) == 1);
    std::set<AnswerSlots> meanings;
    for (const AnswerChoice& choice : choices) {
        const dialogue::Mark mark = dialogue::mark_answer(question, choice.said);
        INFO(choice.said);
        CHECK(mark.understood);
        CHECK(mark.form_right());
        CHECK(mark.slots == choice.meaning);
        CHECK(choice.right == (choice.meaning == AnswerSlots{{"thing", "watermelon"}}));
        meanings.insert(choice.meaning);
    }
    CHECK(meanings.size() == choices.size());
}

TEST_CASE("answer choices: one question gives the same ones; the right one is at various places") {
    const auto said = [](const Expected<std::vector<AnswerChoice>>& choices) {
        std::vector<std::string> all;
        for (const AnswerChoice& choice : *choices) {
            all.push_back(choice.said);
        }
        return all;
    };
    const auto question = heaviest({"watermelon", "apple", "banana", "egg"});
    CHECK(said(make_choices(question, is_watermelon)) ==
          said(make_choices(question, is_watermelon)));
    std::set<std::ptrdiff_t> places;
    for (const char* id : {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l"}) {
        dialogue::Question other = question;
        other.id = id;
        const auto choices = value_of(make_choices(other, is_watermelon));
        places.insert(std::ranges::find(choices, true, &AnswerChoice::right) - choices.begin());
    }
    CHECK(places.size() >= 3);
}

TEST_CASE("answer choices: the right one of a hundred is found; of none, three others are given") {
    std::vector<std::string> many{"watermelon"};
    for (const char* first :
         {"red", "blue", "green", "grey", "black", "white", "brown", "pink", "gold", "silver"}) {
        for (const char* second :
             {"box", "cup", "ball", "hat", "shoe", "book", "pen", "bag", "lamp"}) {
            many.push_back(std::string(first) + " " + second);
        }
    }
    const auto choices = value_of(make_choices(heaviest(many), is_watermelon));
    CHECK(choices.size() == kMostChoices);
    CHECK(std::ranges::count(choices, true, &AnswerChoice::right) == 1);
    const auto wrong =
        value_of(make_choices(heaviest({"apple", "banana", "egg", "stone"}), is_watermelon));
    CHECK(wrong.size() == kMostChoices - 1);
    CHECK(std::ranges::count(wrong, true, &AnswerChoice::right) == 0);
}

namespace {

Texts said_by(const std::vector<AnswerChoice>& choices) {
    Texts said;
    for (const AnswerChoice& choice : choices) {
        said.push_back((choice.right ? "+" : "") + choice.said);
    }
    std::ranges::sort(said);
    return said;
}

dialogue::Question asked(const std::string& prompt, const std::vector<std::string>& answers,
                         const dialogue::NamedLists& lists) {
    return value_of(dialogue::compile_question({"asked", prompt, answers, lists}));
}

/// Right is what has all of these words.
Verdict says(const std::vector<std::string>& words) {
    return [words](const AnswerSlots& slots) {
        return Expected<bool>(std::ranges::all_of(words, [&](const std::string& word) {
            return std::ranges::any_of(slots,
                                       [&](const auto& slot) { return slot.second == word; });
        }));
    };
}

}  // namespace

TEST_CASE("answer choices: nothing is compared with itself, but with what it is compared with") {
    const Texts things{"apple", "egg"};
    const auto question = asked("Which one is heavier?",
                                {"[the] {thing} is <comparative:heavy> [than [the] {other}]"},
                                {{"thing", things}, {"other", things}});
    const auto choices = value_of(make_choices(question, [](const AnswerSlots& slots) {
        return Expected<bool>(slots.front().second == "apple");
    }));
    CHECK(said_by(choices) ==
          Texts{"+The apple is heavier than the egg.", "The egg is heavier than the apple."});
}

TEST_CASE(
    "answer choices: only what is seen is offered, and of two that are asked about these two") {
    const Texts things{"apple", "egg", "stone", "feather"};
    const dialogue::NamedLists lists{{"thing", things}};
    const std::vector<std::string> answers{"the {thing} is the <superlative:heavy>"};
    const auto of_all = asked("Which one is the heaviest?", answers, lists);
    CHECK(said_by(value_of(make_choices(of_all, says({"egg"}), {"egg", "apple", "tree"}))) ==
          Texts{"+The egg is the heaviest.", "The apple is the heaviest."});
    // Where no two of them are seen, nobody knows what is in play.
    CHECK(value_of(make_choices(of_all, says({"egg"}), {"egg"})).size() == things.size());
    const auto of_two = asked("Which one is the heaviest, the egg or the stone?", answers, lists);
    CHECK(said_by(value_of(make_choices(of_two, says({"egg"}), {"egg", "apple", "stone"}))) ==
          Texts{"+The egg is the heaviest.", "The stone is the heaviest."});
}

TEST_CASE("answer choices: the taught sentence, another word at one place, and no nonsense") {
    const Texts words{"hard", "soft", "rough", "smooth"};
    const auto question = asked("What is metal like?",
                                {"{material} is <adjective:{feel}> [and <adjective:{feel:also}>]",
                                 "(it|this) is <adjective:{feel}>"},
                                {{"material", {"metal", "wood"}}, {"feel", words}});
    CHECK(said_by(value_of(make_choices(question, says({"hard", "smooth"})))) ==
          Texts{"+Metal is hard and smooth.", "Metal is hard and rough.",
                "Metal is soft and smooth."});
}

TEST_CASE("answer choices: what the question names is not offered for what it asks") {
    const Texts things{"box", "cup", "hat"};
    const auto question = asked("Where is the box now?", {"it is {place} the {thing}"},
                                {{"place", {"on", "under"}}, {"thing", things}});
    CHECK(said_by(value_of(make_choices(question, says({"on", "cup"}), things))) ==
          Texts{"+It is on the cup.", "It is on the hat.", "It is under the cup."});
}

TEST_CASE(
    "answer choices: another answer's sentence, where the first says nothing wrong or right") {
    const auto question = asked("Is it heavier?", {"{yes} it is", "{no} it is not"},
                                {{"yes", {"yes"}}, {"no", {"no"}}});
    CHECK(said_by(value_of(make_choices(question, says({"yes"})))) ==
          Texts{"+Yes, it is.", "No, it is not."});
    CHECK(said_by(value_of(make_choices(question, says({"no"})))) ==
          Texts{"+No, it is not.", "Yes, it is."});
}

TEST_CASE("answer choices: where nothing is wrong, each may be chosen") {
    const auto question = asked("Now you ask me!", {"how big is {planet}"},
                                {{"planet", {"Mars", "Venus", "Saturn", "Neptune", "Uranus"}}});
    const auto choices = value_of(make_choices(question, says({})));
    CHECK(choices.size() == kMostChoices);
    CHECK(std::ranges::all_of(choices, &AnswerChoice::right));
}

TEST_CASE("answer choices: a verdict that fails is the lesson's error") {
    CHECK(error_of(make_choices(heaviest({"egg", "apple"}), [](const AnswerSlots&) {
              return Expected<bool>(fail("the lesson broke", "lesson.lua:3", "mend it"));
          })).where == "lesson.lua:3");
}

TEST_CASE("asking: who asked while a question is open is waited for anew") {
    LessonDescription lesson = two_things();
    lesson.knowledge = {{"colour", {"what colour is the {thing}"}, {}, 9}};
    Play play(lesson);
    play.ask();
    const double asked_at_s = play.session->hud().question_asked_at_s;
    for (const char* asked : {"What colour is the apple?", "Can I eat it?"}) {
        play.hear(asked);
        play.reply({TellCommand{"colour", "It is red."}});
        CHECK(play.session->hud().question_asked_at_s > asked_at_s);
        CHECK(play.session->listens());
    }
}

TEST_CASE("past answers: a question counts as often as it was asked, and as right once each time") {
    Diary mina("Mina");
    mina.session("gravity").answers("heaviest", "WWR").answers("lightest", "F");
    mina.session("gravity").answers("heaviest", "RR").session("lever").answers("near_far", "RWU");
    const auto past = find_past_answers(dated(mina), "id-of-Mina", 20 * kDay_ms);
    REQUIRE(past.size() == 3);
    // "RR" is numbered 1, 2: asked once, said twice.
    const PastAnswers& heaviest = of(past, "heaviest");
    CHECK(heaviest.lesson == "gravity");
    CHECK(heaviest.asked == 2);
    CHECK(heaviest.right == 2);
    CHECK(heaviest.wrong_now == 0);
    CHECK(heaviest.days == Approx(20.0 - 5.0));
    CHECK(heaviest.points.empty());
    const PastAnswers& lightest = of(past, "lightest");
    CHECK(lightest.points == std::vector<std::pair<std::string, std::int32_t>>{{"comparison", 1}});
    const PastAnswers& near_far = of(past, "near_far");
    CHECK(near_far.right == 1);
    CHECK(near_far.wrong_now == 2);
    // Those answered last stand at the end.
    CHECK(past.back().question == "near_far");
    CHECK(past.front().question == "lightest");
}

TEST_CASE("past answers: another learner's are not there; a clock that goes back gives 0 days") {
    Diary both("Mina");
    both.session("gravity").answers("heaviest", "R");
    both.learner("Tom").session("gravity").answers("heaviest", "WW");
    const auto past = find_past_answers(dated(both), "id-of-Tom", 0);
    REQUIRE(past.size() == 1);
    CHECK(past[0].wrong_now == 2);
    CHECK(past[0].right == 0);
    CHECK(past[0].days == 0.0);
    CHECK(find_past_answers(dated(both), "id-of-Nobody", 0).empty());
    CHECK(find_past_answers({}, "id-of-Tom", 0).empty());
}

TEST_CASE("past answers: of very many questions the newest are left") {
    Diary mina("Mina");
    mina.session("gravity");
    const int n = static_cast<int>(kMaxPastAnswers) + 3;
    for (int i = 0; i < n; ++i) {
        mina.answers("q" + std::to_string(i), "R");
    }
    const auto past = find_past_answers(dated(mina), "id-of-Mina", n * kDay_ms);
    REQUIRE(past.size() == kMaxPastAnswers);
    CHECK(past.front().question == "q3");
    CHECK(past.back().question == "q" + std::to_string(n - 1));
}

TEST_CASE("past answers: names that no lesson can be told are left out") {
    Diary mina("Mina");
    mina.session("gravity").answers("heaviest", "R").answers(std::string(2000, 'x'), "R");
    mina.answers("bad\xff", "R").answers("bell\x07", "R");
    const auto past = find_past_answers(dated(mina), "id-of-Mina", 0);
    REQUIRE(past.size() == 1);
    CHECK(past[0].question == "heaviest");
}

TEST_CASE("past answers: a store gives them for its learner, and nothing where nothing is kept") {
    const auto nothing = make_null_store();
    const auto learner = value_of(nothing->enrol("Mina"));
    const auto past = value_of(read_past_answers(*nothing, learner, 0));
    CHECK(past.empty());
}

TEST_CASE("said before: what stands there comes first, then one further back each time") {
    SaidBefore said;
    for (const char* text : {"one", "two", "three", "four"}) {
        said.add(text);
    }
    const Texts standing{"three", "four"};
    CHECK(said.look_back(standing, 1.0) == standing);
    CHECK(said.shown(1.0).empty());
    CHECK(said.look_back(standing, 2.0) == Texts{"two"});
    CHECK(said.shown(2.0) == "two");
    CHECK(said.look_back(standing, 3.0) == Texts{"one"});
    // Nothing was said before the first.
    CHECK(said.look_back(standing, 4.0) == Texts{"one"});
    CHECK(said.shown(4.0) == "one");
}

TEST_CASE("said before: who waits, and who is told something new, begins with the newest") {
    SaidBefore said;
    said.add("one");
    said.add("two");
    CHECK(said.look_back({}, 1.0) == Texts{"two"});
    CHECK(said.look_back({}, 2.0) == Texts{"one"});
    CHECK(said.shown(2.0 + SaidBefore::kForgets_s).empty());
    CHECK(said.look_back({}, 2.0 + SaidBefore::kForgets_s) == Texts{"two"});
    said.add("three");
    CHECK(said.shown(12.5).empty());
    CHECK(said.look_back({}, 12.5) == Texts{"three"});
    // The same once more is nothing new to hear, but it is new.
    said.add("three");
    CHECK(said.look_back({}, 13.0) == Texts{"three"});
    CHECK(said.look_back({}, 13.5) == Texts{"two"});
}

TEST_CASE("said before: more than is shown at once comes in order, the oldest is forgotten") {
    SaidBefore said;
    const std::size_t many = SaidBefore::kMostKept + 7;
    for (std::size_t i = 1; i <= many; ++i) {
        said.add("line " + std::to_string(i));
    }
    const Texts standing{"line " + std::to_string(many)};
    double now_s = 0.0;
    CHECK(said.look_back(standing, now_s) == standing);
    for (std::size_t i = many - 1; i > many - SaidBefore::kMostKept; --i) {
        CHECK(said.look_back(standing, now_s += 1.0) == Texts{"line " + std::to_string(i)});
    }
    CHECK(said.look_back(standing, now_s + 1.0) == Texts{"line 8"});
}

TEST_CASE("said before: nothing said is nothing to hear, and two lines are shown as one") {
    SaidBefore said;
    said.add("");
    CHECK(said.look_back({}, 0.0).empty());
    CHECK(said.look_back({}, 1.0).empty());
    CHECK(said.shown(1.0).empty());
    // What stands there from before the play is said all the same, again and again.
    CHECK(said.look_back({"x"}, 100.0) == Texts{"x"});
    CHECK(said.look_back({"x"}, 101.0) == Texts{"x"});
    said.add("Look.\nWhich one?");
    CHECK(said.look_back({}, 200.0) == Texts{"Look.\nWhich one?"});
    CHECK(said.shown(200.0) == "Look. Which one?");
}
