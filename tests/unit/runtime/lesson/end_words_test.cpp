#include "runtime/lesson/end_words.h"

#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

// Each text is its key, and what is put into it.
fulcrum::dialogue::Catalogue keys() {
    return fulcrum::dialogue::Catalogue::parse(
               "end.best = best\nend.no_question = none asked\nend.one_right = one right\n"
               "end.one_later = one later\nend.all_right = all {of}\n"
               "end.some_right = {right} of {of}\nend.none_right = 0 of {of}\n"
               "end.practise.one = practise {words}\nend.practise.other = practise {n}: {words}\n"
               "language.plurals = one other\n")
        .value();
}

std::string told(int questions, int right, std::vector<std::string> to_practise = {}, int stars = 2,
                 int best_before = -1) {
    SessionResult result;
    result.stars = stars;
    result.questions = questions;
    result.right_at_first = right;
    result.to_practise = std::move(to_practise);
    return explain_stars(result, best_before, keys());
}

std::vector<KnownLesson> course(std::vector<std::int32_t> stars) {
    std::vector<KnownLesson> lessons;
    for (std::size_t i = 0; i < stars.size(); ++i) {
        const std::string name(1, static_cast<char>('a' + i));
        lessons.push_back({name, "Lesson " + name, "A1", "apple", stars[i]});
    }
    return lessons;
}

std::string next(const std::vector<KnownLesson>& lessons, const std::string& played) {
    const auto found = find_next_lesson(lessons, played);
    return found ? found->name : "-";
}

}  // namespace

TEST_CASE("end words: how many were right at the first try, each number in words of its own") {
    CHECK(told(0, 0) == "none asked");
    CHECK(told(1, 1) == "one right");
    CHECK(told(1, 0) == "one later");
    CHECK(told(5, 4) == "4 of 5");
    CHECK(told(5, 5) == "all 5");
    CHECK(told(5, 0) == "0 of 5");
}

TEST_CASE("end words: what to practise is named, three at most, and how many there are") {
    CHECK(told(2, 2, {"heavier"}) == "all 2 practise heavier");
    CHECK(told(2, 1, {"heavier", "lightest"}) == "1 of 2 practise 2: heavier, lightest");
    CHECK(told(0, 0, {"a", "b", "c", "d"}) == "none asked practise 4: a, b, c …");
}

TEST_CASE("end words: more stars than ever before are the best, the first ones are not") {
    CHECK(told(0, 0, {}, 3, 2) == "best none asked");
    CHECK(told(0, 0, {}, 1, 0) == "best none asked");
    CHECK(told(0, 0, {}, 2, 2) == "none asked");
    CHECK(told(0, 0, {}, 1, 2) == "none asked");
    CHECK(told(0, 0, {}, 3, -1) == "none asked");
}

TEST_CASE("end words: the next lesson is the first after this one that was not played") {
    CHECK(next(course({-1, -1, -1}), "a") == "b");
    CHECK(next(course({-1, 0, -1}), "a") == "c");
    CHECK(next(course({-1, 2, -1}), "c") == "a");
    CHECK(next(course({1, 2, -1}), "c") == "-");
    CHECK(next(course({1, 2, 3}), "a") == "-");
    CHECK(next(course({-1, -1}), "elsewhere") == "-");
    CHECK(next({}, "a") == "-");
}

TEST_CASE("end words: questions, first tries and what to practise are counted from the answers") {
    Play play;
    const SessionResult& result = play.session->result();
    play.ask();
    play.hear("bla bla bla");
    play.reply();
    CHECK(result.questions == 1);
    CHECK(result.right_at_first == 0);
    // Another try is no other question.
    play.hear("The apple is the heaviest.");
    play.reply({VerdictCommand{"heaviest", true}});
    CHECK(result.attempts == 2);
    CHECK(result.questions == 1);
    CHECK(result.right_at_first == 0);
    CHECK(result.to_practise.empty());
    // The next is right at once, with an error of form.
    play.ask();
    play.hear("the apple is the most heavy");
    play.reply({VerdictCommand{"heaviest", true}});
    CHECK(result.questions == 2);
    CHECK(result.right_at_first == 1);
    CHECK(result.to_practise == std::vector<std::string>{"the heaviest"});
    // What is right already teaches nothing new.
    play.ask();
    play.hear("The apple is the heaviest.");
    play.reply({VerdictCommand{"heaviest", false}});
    CHECK(result.right_at_first == 1);
    CHECK(result.to_practise.size() == 1);
}
