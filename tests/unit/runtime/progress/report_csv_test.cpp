// The report as a spreadsheet reads it: the numbers of the screen, and nothing that it would run.
#include "runtime/progress/report.h"
#include "tests/support/csv_reader.h"
#include "tests/unit/runtime/progress/diary.h"
#include "tests/unit/runtime/rig.h"

#include <random>

using namespace fulcrum::runtime::test;

namespace {

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

}  // namespace

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
        const auto rows = value_of(parse_csv(to_csv(report, kUtc)));
        std::size_t compared = 0;
        for (const auto& row : rows) {
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
    const auto rows = value_of(parse_csv(to_csv(compute_report(diary.data), kUtc)));
    REQUIRE(rows.size() == 2);
    CHECK(rows[1] ==
          value_of(parse_csv("Mina,id-of-Mina,gravity,1,1,2026-03-02 10:15 +0000,2,70,heaviest,1,4,"
                             "0,1,0,1,0,3,before,R:ADJ:FORM 1,\"\"\"most heavy\"\" -> "
                             "\"\"heaviest\"\"\",comparison 1,comparison 0,0,0,0,the egg,1,4,3,0,"
                             "1.00\r\n"))[0]);
    const std::vector<std::string> head{"meaning_right", "target_judged", "target_right",
                                        "other_form_errors", "confidence"};
    CHECK(std::vector<std::string>(rows[0].end() - 5, rows[0].end()) == head);
    const std::string with_mark = to_csv({}, {.byte_order_mark = true});
    CHECK(with_mark.substr(0, 10) == "\xEF\xBB\xBFlearner");
}

TEST_CASE("report: without learners the CSV is its header alone") {
    const auto rows = value_of(parse_csv(to_csv(compute_report({}))));
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].size() == 31);
}

TEST_CASE("report: no cell of the CSV is a formula, and every cell is read back whole") {
    for (const std::string nasty :
         {"=HYPERLINK(\"http://x\")", "+1", "-1+1", "@SUM(A1)", "\t=1", " =1", "＝1", "\r=1", "a,b",
          "a;=1", "say \"hi\"", "two\nlines", "plain", "민아"}) {
        Diary diary(nasty);
        diary.session(nasty).answers(nasty, "F");
        diary.data.attempts[0].errors[0].span = nasty;
        const std::string csv = to_csv(compute_report(diary.data), kUtc);
        const auto rows = value_of(parse_csv(csv));
        REQUIRE(rows.size() == 2);
        for (const auto& row : rows) {
            REQUIRE(row.size() == 31);
        }
        const auto& row = rows[1];
        CAPTURE(nasty, csv);
        const bool is_formula = nasty.find_first_of("=+-@") < 2 || nasty.substr(0, 3) == "＝";
        const bool is_control = nasty.find_first_of("\t\r") == 0;
        const std::string expected = is_formula || is_control ? "'" + nasty : nasty;
        CHECK(row[0] == (nasty == "a;=1" ? nasty : expected));
        CHECK(row[2] == row[0]);
        CHECK(row[8] == row[0]);
        CHECK(row[19] == '"' + nasty + "\" -> \"heaviest\"");
    }
}
