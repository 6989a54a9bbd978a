// The report's numbers, counted by hand, and its two writers, which must show the same ones.
#include "runtime/progress/report.h"

#include "runtime/progress/text_rules.h"
#include "tests/unit/runtime/progress/csv_reader.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include <map>
#include <random>
#include <sstream>

namespace fulcrum::runtime {
namespace {

constexpr ReportStyle kUtc{.utc = true};
constexpr std::int64_t kMorning_utc_ms = 1'772'446'500'000;  // 2026-03-02 10:15 UTC

// Progress that is written down answer by answer. Ids are plain words: the report does not look
// into them.
class Diary {
  public:
    explicit Diary(std::string nickname) { learner(std::move(nickname)); }

    Diary& learner(std::string nickname) {
        data.learners.push_back({"id-of-" + nickname, std::move(nickname), 0});
        return *this;
    }
    Diary& session(const std::string& lesson, std::int64_t started_utc_ms = kMorning_utc_ms) {
        SessionRecord session;
        session.id = "session " + std::to_string(data.sessions.size());
        session.learner = data.learners.back().id;
        session.lesson = lesson;
        session.started_utc_ms = started_utc_ms;
        data.sessions.push_back(session);
        return *this;
    }
    Diary& end(std::int32_t stars, std::int32_t score, EndReason reason = EndReason::finished) {
        data.ends.push_back({data.sessions.back().id, kMorning_utc_ms, reason, stars, score, 1});
        return *this;
    }
    // One letter an answer: R right, F right with a wrong form, W wrong, U not understood.
    Diary& answers(const std::string& question, const std::string& letters) {
        std::int32_t number = 0;
        for (const char letter : letters) {
            AttemptRecord attempt;
            attempt.session = data.sessions.back().id;
            attempt.question = question;
            attempt.attempt = ++number;
            attempt.understood = letter != 'U';
            attempt.meaning_right = letter == 'R' || letter == 'F';
            attempt.form_right = letter == 'R' || letter == 'W';
            if (letter == 'F') {
                attempt.errors = {{"R:ADJ:FORM", "most heavy", "heaviest"}};
            }
            data.attempts.push_back(attempt);
        }
        return *this;
    }

    ProgressData data;
};

QuestionReport only_question(const Diary& diary) {
    const Report report = compute_report(diary.data);
    REQUIRE(report.learners.size() == 1);
    REQUIRE(report.learners[0].lessons.size() == 1);
    REQUIRE(report.learners[0].lessons[0].questions.size() == 1);
    return report.learners[0].lessons[0].questions[0];
}

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

TEST_CASE("report: reads as a teacher reads it") {
    Diary diary("mina");
    diary.session("gravity")
        .end(2, 70)
        .answers("heaviest", "WF")
        .answers("lighter-than-egg", "WWW");
    diary.learner("Joon").session("gravity");
    diary.learner("Ada");
    CHECK(to_text(compute_report(diary.data), kUtc) ==
          R"(Stuck now: mina (gravity: lighter-than-egg).

Ada
  has not played yet

Joon
  gravity: played once, finished not yet, last on 2026-03-02 10:15 +0000
    no question answered yet

mina
  gravity: played once, finished once, last on 2026-03-02 10:15 +0000
    best: 2 stars, score 70
                                          right  right  not un-  form wrong in
    question             asked attempts at once in end derstood wrong    a row
    heaviest                 1        2       0      1        0     1        1
      R:ADJ:FORM 1: "most heavy" -> "heaviest"
    lighter-than-egg         1        3       0      0        0     0        3
      STUCK now: the last 3 or more answers were not right
)");
}

TEST_CASE("report: nobody yet is one friendly sentence") {
    CHECK(to_text(compute_report({})) ==
          "Nobody has played yet. Play a lesson first, for example: fulcrum run gravity\n");
    CHECK(to_text(compute_report({}, {"Zoe", ""})).find("no learner called \"Zoe\"") !=
          std::string::npos);
    const auto rows = test::parse_csv(to_csv(compute_report({})));
    REQUIRE(rows);
    CHECK(rows->size() == 1);
    const auto store = make_null_store();
    CHECK(make_report(*store)->learners.empty());
}

TEST_CASE("report: a lesson that one learner has not played is said so") {
    Diary diary("Mina");
    CHECK(to_text(compute_report(diary.data, {"", "kite"})).find("has not played kite yet") !=
          std::string::npos);
}

// The numbers of each question by "learner|lesson|question", read back from the text.
std::map<std::string, std::vector<std::string>> numbers_on_screen(const std::string& text) {
    std::map<std::string, std::vector<std::string>> numbers;
    std::istringstream lines(text);
    std::string line;
    std::string learner;
    std::string lesson;
    while (std::getline(lines, line)) {
        const std::size_t indent = line.find_first_not_of(' ');
        if (indent == 0) {
            learner = line;
        } else if (indent == 2) {
            lesson = line.substr(2, line.find(':') - 2);
        } else if (indent == 4) {
            std::istringstream words(line);
            std::string question;
            words >> question;
            auto& row = numbers[learner + "|" + lesson + "|" + question];
            for (std::string word; words >> word;) {
                row.push_back(word);
            }
        }
    }
    return numbers;
}

TEST_CASE("report: the CSV holds the numbers that the screen shows") {
    std::mt19937 random(7);
    const auto pick = [&](int below) {
        return static_cast<int>(random() % static_cast<unsigned>(below));
    };
    for (int round = 0; round < 50; ++round) {
        Diary diary("pupil0");
        for (int sessions = 0; sessions < 12; ++sessions) {
            if (pick(3) == 0) {
                diary.learner("pupil" + std::to_string(sessions + 1));
            }
            diary.session("lesson" + std::to_string(pick(3))).end(pick(4), pick(100));
            for (int questions = pick(4); questions > 0; --questions) {
                std::string letters;
                for (int n = 1 + pick(15); n > 0; --n) {
                    letters += "RFWU"[pick(4)];
                }
                diary.answers("question" + std::to_string(pick(4)), letters);
            }
        }
        const Report report = compute_report(diary.data);
        const auto on_screen = numbers_on_screen(to_text(report, kUtc));
        const auto rows = test::parse_csv(to_csv(report, kUtc));
        REQUIRE(rows);
        std::size_t compared = 0;
        for (const auto& row : *rows) {
            if (row[8].empty() || row[8] == "question") {
                continue;
            }
            const auto shown = on_screen.find(row[0] + "|" + row[2] + "|" + row[8]);
            REQUIRE(shown != on_screen.end());
            CHECK(shown->second == std::vector<std::string>(row.begin() + 9, row.begin() + 16));
            ++compared;
        }
        // And every question on the screen is in the CSV.
        const auto shown_questions =
            std::count_if(on_screen.begin(), on_screen.end(), [](const auto& entry) {
                return std::isdigit(static_cast<unsigned char>(entry.first.back())) != 0;
            });
        CHECK(compared == static_cast<std::size_t>(shown_questions));
    }
}

TEST_CASE("report: the CSV says when, how well, and with which errors") {
    Diary diary("Mina");
    diary.session("gravity").end(2, 70).answers("heaviest", "WWWF");
    const auto rows = test::parse_csv(to_csv(compute_report(diary.data), kUtc));
    REQUIRE(rows);
    REQUIRE(rows->size() == 2);
    CHECK((*rows)[1] == std::vector<std::string>{"Mina", "id-of-Mina", "gravity", "1", "1",
                                                 "2026-03-02 10:15 +0000", "2", "70", "heaviest",
                                                 "1", "4", "0", "1", "0", "1", "3", "before",
                                                 "R:ADJ:FORM 1", "\"most heavy\" -> \"heaviest\""});
    const std::string with_mark = to_csv({}, {.byte_order_mark = true});
    CHECK(with_mark.substr(0, 10) == "\xEF\xBB\xBFlearner");
}

TEST_CASE("report: no cell of the CSV is a formula, and every cell is read back whole") {
    for (const std::string nasty :
         {"=HYPERLINK(\"http://x\")", "+1", "-1+1", "@SUM(A1)", "\t=1", " =1", "＝1", "\r=1", "a,b",
          "a;=1", "say \"hi\"", "two\nlines", "plain", "민아"}) {
        Diary diary(nasty);
        diary.session(nasty).answers(nasty, "F");
        diary.data.attempts[0].errors[0].span = nasty;
        const std::string csv = to_csv(compute_report(diary.data), kUtc);
        const auto rows = test::parse_csv(csv);
        REQUIRE(rows);
        REQUIRE(rows->size() == 2);
        for (const auto& row : *rows) {
            REQUIRE(row.size() == 19);
        }
        const auto& row = (*rows)[1];
        CAPTURE(nasty, csv);
        const bool is_formula = nasty.find_first_of("=+-@") < 2 || nasty.substr(0, 3) == "＝";
        const bool is_control = nasty.find_first_of("\t\r") == 0;
        const std::string expected = is_formula || is_control ? "'" + nasty : nasty;
        CHECK(row[0] == (nasty == "a;=1" ? nasty : expected));
        CHECK(row[2] == row[0]);
        CHECK(row[8] == row[0]);
        CHECK(row[18] == '"' + nasty + "\" -> \"heaviest\"");
    }
}

TEST_CASE("report: no line is wider than 80 columns, and nothing moves the cursor") {
    Diary diary(std::string(40, 'W'));
    std::string korean;
    for (int i = 0; i < 40; ++i) {
        korean += "무";
    }
    diary.session(std::string(200, 'l')).end(3, 1'000'000).answers("q", "F");
    diary.learner(korean).session(korean).answers(korean, "WWWW").answers("q\x1b[2J", "F");
    diary.data.attempts.back().errors = {{"CODE", korean + "\x07" + korean, "two words " + korean}};
    const std::string text = to_text(compute_report(diary.data), kUtc);
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        CAPTURE(line);
        CHECK(display_width(line) <= 80);
        for (std::size_t at = 0; at < line.size();) {
            const Character character = character_at(line, at);
            CHECK(character.valid);
            CHECK_FALSE(is_control(character.code));
            at += character.bytes;
        }
    }
}

}  // namespace
}  // namespace fulcrum::runtime
