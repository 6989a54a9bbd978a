// How values are written in a report.
#include "runtime/progress/report_cells.h"

#include "tests/unit/runtime/rig.h"

#include <ctime>

using namespace fulcrum::runtime::test;

TEST_CASE("report cells: times say their offset, in UTC and in the computer's zone") {
    CHECK(time_cell(0, {.utc = true}) == "1970-01-01 00:00 +0000");
    CHECK(time_cell(1'772'446'559'999, {.utc = true}) == "2026-03-02 10:15 +0000");
    CHECK(time_cell(-1, {.utc = true}) == "1969-12-31 23:59 +0000");
    CHECK(time_cell(std::numeric_limits<std::int64_t>::max(), {.utc = true}) ==
          "292278994-08-17 07:12 +0000");
    const char* zone = std::getenv("TZ");
    const std::string before = zone == nullptr ? "" : zone;
    setenv("TZ", "KST-9", 1);
    tzset();
    CHECK(time_cell(1'772'446'500'000, {}) == "2026-03-02 19:15 +0900");
    zone == nullptr ? unsetenv("TZ") : setenv("TZ", before.c_str(), 1);
    tzset();
}

TEST_CASE("report cells: an error in plain words shows the most frequent examples") {
    const FormErrorReport many{
        "R:SPELL", 9, "d", "D", {{"a", "A", 4}, {"b", "B", 2}, {"c", "C", 1}, {"d", "D", 2}}};
    CHECK(plain_words(many) ==
          "\"a\" for \"A\" (4 times), \"b\" for \"B\" (2 times), \"c\" for \"C\" (once), and "
          "others (2 "
          "times)");
    CHECK(plain_words({"M:DET", 1, "", "the", {{"", "the", 1}}}) == "left out \"the\" (once)");
    CHECK(plain_words({"R:WO", 2, "", "is the heaviest", {{"", "is the heaviest", 2}}}) ==
          "word order: the verb too late, for \"is the heaviest\" (2 times)");
    CHECK(plain_words({"R:WO", 1, "rock hard", "hard rock", {{"rock hard", "hard rock", 1}}}) ==
          "word order: \"rock hard\" for \"hard rock\" (once)");
    CHECK(times(1) == "once");
    CHECK(times(2) == "2 times");
}

TEST_CASE("report cells: a point of grammar tells how it goes now") {
    CHECK(plain_words(GrammarPointReport{"passive_voice", 3, 5}) ==
          "passive voice 3 (none in the last 5 answers)");
    CHECK(plain_words(GrammarPointReport{"article", 1, 1}) ==
          "article 1 (none in the last answer)");
    CHECK(plain_words(GrammarPointReport{"article", 2, 0}) == "article 2 (in the last answer)");
    CHECK(plain_words(GrammarPointReport{"wording", 1, 0}) ==
          "order of words 1 (in the last answer)");
    CHECK(point_cell({"passive_voice", 3, 5}) == "passive_voice 3");
    CHECK(since_cell({"passive_voice", 3, 5}) == "passive_voice 5");
}

TEST_CASE("report cells: stuck, errors and examples in words") {
    CHECK(std::string(stuck_cell(Stuck::no)) == "no");
    CHECK(std::string(stuck_cell(Stuck::before)) == "before");
    CHECK(std::string(stuck_cell(Stuck::now)) == "now");
    const FormErrorReport error{"M:DET", 2, "", "the", {{"", "the", 2}}};
    CHECK(error_cell(error) == "M:DET 2");
    CHECK(example_cell(error) == "\"\" -> \"the\"");
}

TEST_CASE("report cells: four marks in words, and none of a form that was never judged") {
    QuestionReport question;
    question.attempts = 5;
    question.meaning_right = 3;
    question.target_judged = 4;
    question.target_right = 2;
    question.other_form_errors = 1;
    question.confidence = 0.867;
    CHECK(marks_of(question) ==
          "meaning 3 of 5, taught form 2 of 4, other form errors 1, confidence 0.87");
    question.target_judged = question.target_right = question.other_form_errors = 0;
    CHECK(marks_of(question) == "meaning 3 of 5, form not judged, confidence 0.87");
    CHECK(confidence_cell(1.0) == "1.00");
}
