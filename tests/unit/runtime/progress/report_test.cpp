// The report's numbers, counted by hand.
#include "runtime/progress/report.h"

#include "runtime/progress/report_text.h"
#include "tests/unit/runtime/progress/diary.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

QuestionReport only_question(const Diary& diary) {
    const Report report = compute_report(diary.data);
    REQUIRE(report.learners.size() == 1);
    REQUIRE(report.learners[0].lessons.size() == 1);
    REQUIRE(report.learners[0].lessons[0].questions.size() == 1);
    return report.learners[0].lessons[0].questions[0];
}

}  // namespace

TEST_CASE("report: counts askings, attempts, first and last answers") {
    Diary diary("Mina");
    diary.session("gravity").answers("heaviest", "WUF").answers("heaviest", "R");
    diary.session("gravity").answers("heaviest", "RW");
    const QuestionReport question = only_question(diary);
    CHECK(question.asked == 3);
    CHECK(question.attempts == 6);
    CHECK(question.right_first_time == 2);
    CHECK(question.right_in_the_end == 2);
    CHECK(question.not_understood == 1);
    CHECK(question.form_wrong == 1);
    CHECK(question.wrong_in_a_row == 2);
    CHECK(question.stuck == Stuck::no);
}

TEST_CASE("report: a form that nobody heard counts neither as right nor as wrong") {
    Diary diary("Mina");
    diary.session("gravity").answers("heaviest", "FNVU").answers("heaviest", "R");
    const QuestionReport question = only_question(diary);
    CHECK(question.attempts == 5);
    CHECK(question.right_in_the_end == 1);
    CHECK(question.form_judged == 2);  // F and R
    CHECK(question.form_wrong == 1);
    REQUIRE(question.points.size() == 1);
    CHECK(question.points[0].answers_since == 1);  // R alone shows that it has gone well since
    CHECK(question.wrong_in_a_row == 2);
}

TEST_CASE("report: the four marks are summed each by itself") {
    Diary diary("Mina");
    diary.session("gravity").answers("heaviest", "RFWUNF");
    std::vector<AttemptRecord>& attempts = diary.data.attempts;
    const ErrorRecord taught{"R:ADJ:FORM", "most heavy", "heaviest", "comparison", true};
    const ErrorRecord other{"M:DET", "", "an", "article"};
    attempts[1].errors = {taught, other, taught};
    attempts[3].errors = {other};  // in words that fit no answer
    attempts[4].confidence = 0.5;
    attempts[5].errors = {other, other};
    attempts[5].target_right = true;
    const QuestionReport question = only_question(diary);
    CHECK(question.attempts == 6);
    CHECK(question.meaning_right == 4);  // R, both F, N
    CHECK(question.target_judged == 4);  // neither U nor N
    CHECK(question.target_right == 3);   // R, W, the second F
    CHECK(question.other_form_errors == 4);
    CHECK(question.confidence == Approx(5.5 / 6.0));
}

TEST_CASE("report: what was kept before the taught form was told from others is not judged by it") {
    Diary diary("Mina");
    diary.session("gravity").answers("heaviest", "FR");
    AttemptRecord& old = diary.data.attempts[0];
    // Older than the mark at each error: one at least is the taught form's.
    old.errors = {{"R:ADJ:FORM", "most heavy", "heaviest"}, {"M:DET", "", "the"}};
    CHECK(only_question(diary).other_form_errors == 1);
    CHECK(only_question(diary).target_right == 1);
    // Older than the mark at each answer.
    old.feedback.clear();
    CHECK(only_question(diary).target_judged == 1);
    CHECK(only_question(diary).other_form_errors == 2);
}

TEST_CASE("report: three answers in a row that are not right make stuck, over sessions too") {
    const auto stuck = [](const std::string& first, const std::string& second) {
        Diary diary("Mina");
        diary.session("gravity").answers("heaviest", first);
        diary.session("gravity").answers("heaviest", second);
        return only_question(diary).stuck;
    };
    CHECK(stuck("W", "W") == Stuck::no);
    CHECK(stuck("W", "WU") == Stuck::now);
    CHECK(stuck("WWW", "R") == Stuck::before);
    CHECK(stuck("WWWR", "WW") == Stuck::before);
    CHECK(stuck("WWWR", "WWW") == Stuck::now);
    CHECK(stuck("WWR", "WW") == Stuck::no);
    CHECK(stuck("UUU", "F") == Stuck::before);
}

TEST_CASE("report: the run of wrong answers that goes on is counted apart from the longest") {
    Diary diary("Mina");
    diary.session("gravity").answers("heaviest", "WWWRWU");
    CHECK(only_question(diary).wrong_in_a_row == 3);
    CHECK(only_question(diary).wrong_now == 2);
    diary.answers("heaviest", "F");
    CHECK(only_question(diary).wrong_now == 0);
}

TEST_CASE("report: the simulated pupil stands in it only when asked for") {
    Diary diary("Mina");
    diary.session("gravity").answers("heaviest", "R");
    diary.learner(kSimulatedPupil).session("gravity").answers("heaviest", "WWW");
    const Report class_report = compute_report(diary.data);
    REQUIRE(class_report.learners.size() == 1);
    CHECK(class_report.learners[0].learner.nickname == "Mina");
    Diary alone(kSimulatedPupil);
    alone.session("gravity").answers("heaviest", "WWW");
    CHECK(compute_report(alone.data, {"Simulated Pupil", ""}).learners.size() == 1);
    CHECK(compute_report(alone.data).learners.empty());
}

TEST_CASE(
    "report: guests stand behind the others as one, with what they played, unless asked for") {
    const auto guest = [](char digit) { return "guest 2026-11-30 14:05 " + std::string(8, digit); };
    Diary diary(guest('a'));
    diary.session("gravity").end(1, 10).answers("heaviest", "WWW");
    diary.learner("zoë").session("gravity").answers("heaviest", "R");
    diary.learner(guest('b')).session("gravity").end(3, 5).answers("heaviest", "WWW");
    diary.learner(guest('c'));  // played nothing
    const Report folded = compute_report(diary.data);
    REQUIRE(folded.learners.size() == 2);
    CHECK(folded.learners[0].learner.nickname == "zoë");
    CHECK(folded.learners[0].guests == 0);
    CHECK(folded.learners[0].lessons[0].questions.size() == 1);
    CHECK(folded.learners[1].learner.nickname == "Guests (2)");
    CHECK(folded.learners[1].guests == 2);
    REQUIRE(folded.learners[1].lessons.size() == 1);
    const LessonReport& lesson = folded.learners[1].lessons[0];
    CHECK(lesson.played == 2);
    CHECK(lesson.finished == 2);
    CHECK(lesson.best_stars == 3);
    CHECK(lesson.best_score == 10);
    CHECK(lesson.questions.empty());
    const std::string text = to_text(folded, kUtc);
    check_says(text, {"Nobody is stuck.", "\nGuests (2)\n", "--guests"});
    check_lacks(text, {"no question answered", "14:05"});

    const Report each =
        compute_report(diary.data, {.nickname = {}, .lesson = {}, .each_guest = true});
    REQUIRE(each.learners.size() == 4);
    CHECK(each.learners[0].learner.nickname == guest('a'));
    CHECK(each.learners[0].lessons[0].questions[0].stuck == Stuck::now);

    Diary alone(guest('a'));
    alone.session("gravity").answers("heaviest", "R");
    const Report one = compute_report(alone.data, {.nickname = guest('a'), .lesson = {}});
    REQUIRE(one.learners.size() == 1);
    CHECK(one.learners[0].guests == 0);
    CHECK(one.learners[0].lessons[0].questions.size() == 1);
}

TEST_CASE("report: guests who have not played a lesson are not counted for it") {
    Diary diary("guest 2026-11-30 14:05 aaaaaaaa");
    CHECK(compute_report(diary.data).learners.empty());
    diary.session("kite").end(1, 1);
    diary.learner("guest 2026-11-30 14:06 bbbbbbbb").session("kite");
    CHECK(compute_report(diary.data).learners[0].guests == 2);
    CHECK(compute_report(diary.data).learners[0].lessons[0].finished == 1);
}

TEST_CASE("report: a right meaning that was not understood is not right") {
    Diary diary("Mina");
    diary.session("gravity").answers("heaviest", "R");
    diary.data.attempts[0].understood = false;
    CHECK(only_question(diary).right_first_time == 0);
    CHECK(only_question(diary).right_in_the_end == 0);
}

TEST_CASE("report: errors of form are counted by code, most frequent first, newest example") {
    Diary diary("Mina");
    diary.session("gravity").answers("heaviest", "FFF");
    diary.data.attempts[0].errors = {{"A", "a1", "x"}, {"B", "b1", "x"}, {"B", "b2", "x"}};
    diary.data.attempts[1].errors = {{"C", "c1", "x"}};
    diary.data.attempts[2].errors = {{"B", "b3", "y"}};
    const auto errors = only_question(diary).form_errors;
    REQUIRE(errors.size() == 3);
    CHECK(errors[0].code == "B");
    CHECK(errors[0].count == 3);
    CHECK(errors[0].span == "b3");
    CHECK(errors[0].correction == "y");
    CHECK(errors[1].code == "A");
    CHECK(errors[2].code == "C");
}

TEST_CASE("report: a lesson shows how often, when last, and its best end") {
    Diary diary("Mina");
    diary.session("gravity", kMorning_utc_ms).end(1, 70);
    diary.session("kite", 5).session("gravity", kMorning_utc_ms - 1).end(2, 60, EndReason::left);
    const Report report = compute_report(diary.data);
    REQUIRE(report.learners[0].lessons.size() == 2);
    const LessonReport& gravity = report.learners[0].lessons[0];
    CHECK(gravity.lesson == "gravity");
    CHECK(gravity.played == 2);
    CHECK(gravity.finished == 1);
    CHECK(gravity.last_played_utc_ms == kMorning_utc_ms);
    CHECK(gravity.best_stars == 2);
    CHECK(gravity.best_score == 70);
    CHECK(report.learners[0].lessons[1].best_stars == std::nullopt);
}
