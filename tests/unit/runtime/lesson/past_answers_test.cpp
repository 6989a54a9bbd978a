#include "runtime/lesson/past_answers.h"

#include "tests/unit/runtime/progress/diary.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

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

}  // namespace

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
