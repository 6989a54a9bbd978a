#include "dialogue/unicode.h"
#include "runtime/progress/report.h"
#include "runtime/progress/report_cells.h"
#include "runtime/progress/report_csv.h"
#include "runtime/progress/report_text.h"
#include "runtime/progress/text_rules.h"
#include "tests/support/csv_reader.h"
#include "tests/unit/runtime/progress/diary.h"
#include "tests/unit/runtime/rig.h"

#include <ctime>
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

TEST_CASE("report: reads as a teacher reads it") {
    Diary diary("mina");
    diary.session("gravity")
        .end(2, 70)
        .answers("heaviest", "WF")
        .answers("lighter-than-egg", "WWW");
    diary.learner("Joon").session("gravity");
    diary.learner("Ada");
    CHECK(to_text(compute_report(diary.data), kUtc) ==
          R"(Stuck now: mina (gravity: lighter-than-egg, said "the egg").

Ada
  has not played yet

Joon
  gravity: played once, finished not yet, last on 2026-03-02 10:15 +0000
    no question answered yet

mina
  gravity: played once, finished once, last on 2026-03-02 10:15 +0000
    best: 2 stars, score 70
                                          right  right  not un-  form  wrong in
    question             asked attempts at once in end derstood wrong a row now
    heaviest                 1        2       0      1        0     1         0
      meaning 1 of 2, taught form 1 of 2, other form errors 0, confidence 1.00
      slips: comparison 1 (in the last answer)
      "most heavy" for "heaviest" (once)
    lighter-than-egg         1        3       0      0        0     0         3
      meaning 0 of 3, taught form 3 of 3, other form errors 0, confidence 1.00
      STUCK now: the last 3 answers were not right
)");
}

TEST_CASE("report: who was let go on, and what came of saying it once more, is told") {
    Diary diary("Mina");
    diary.session("gravity")
        .answers("heaviest", "PS")
        .answers("heaviest", "P")
        .answers("lightest", "PF")
        .answers("heavier", "UUM");
    const Report report = compute_report(diary.data);
    const auto& questions = report.learners[0].lessons[0].questions;
    REQUIRE(questions.size() == 3);
    CHECK(questions[0].invited == 2);
    CHECK(questions[0].repaired == 1);
    CHECK(questions[0].moved_on == 0);
    CHECK(questions[0].last_wrong.empty());
    CHECK(questions[2].moved_on == 1);
    CHECK(questions[2].last_wrong == "hm");
    const std::string text = to_text(report, kUtc);
    CHECK_THAT(text, Catch::StartsWith("Stuck now: Mina (gravity: heavier, said \"hm\")."));
    check_says(text, {"said once more when asked to: right 1 of 2 times\n",
                      "said once more when asked to: right 0 of 1 time\n",
                      "let go on without a right answer once\n"});
    check_says(to_csv(report, kUtc), {",1,0,0,hm,0,0,0,0,1.00\r\n"});
}

TEST_CASE("report: nobody yet is one friendly sentence") {
    CHECK(to_text(compute_report({})) ==
          "Nobody has played yet. Play a lesson first, for example: fulcrum run gravity\n");
    check_says(to_text(compute_report({}, {"Zoe", ""})), {"no learner called \"Zoe\""});
    const auto store = make_null_store();
    CHECK(make_report(*store)->learners.empty());
}

TEST_CASE("report: a lesson that one learner has not played is said so") {
    Diary diary("Mina");
    diary.session("kite").answers("faster", "R").learner("Joon");
    const std::string everybody = to_text(compute_report(diary.data, {"", "kite"}));
    check_says(everybody, {"Joon\n  has not played kite yet"});
    Diary one("Mina");
    check_says(to_text(compute_report(one.data, {"Mina", "kite"})),
               {"Mina\n  has not played kite yet"});
}

TEST_CASE("report: a lesson that nobody has played is one sentence, not a list of everybody") {
    Diary diary("Mina");
    diary.learner("Joon");
    const Report report = compute_report(diary.data, {"", "gravty"});
    CHECK(report.learners.empty());
    CHECK(to_text(report) ==
          "Nobody has played a lesson called \"gravty\" here; fulcrum report without --lesson\n"
          "  shows all that was played.\n");
}

TEST_CASE("report: wrong in a row is how it stands now; what is over is said in words") {
    Diary diary("Mina");
    diary.session("gravity").answers("heaviest", "WWWWRW");
    const std::string text = to_text(compute_report(diary.data), kUtc);
    check_says(text, {"    0     0         1\n",
                      "was stuck before (4 answers in a row were not right), and went on"});
}

TEST_CASE("report: errors of form are told in words, without codes") {
    Diary diary("Mina");
    diary.session("gravity").answers("heaviest", "FFFFF");
    const std::vector<ErrorRecord> errors[] = {{{"M:DET", "", "the"}, {"U:PRON", "it", ""}},
                                               {{"M:DET", "", "an"}},
                                               {{"M:DET", "", "the"}},
                                               {{"R:ADJ:FORM", "most heavy", "heaviest"}},
                                               {{"M:DET", "", "the"}}};
    for (std::size_t i = 0; i < 5; ++i) {
        diary.data.attempts[i].errors = errors[i];
    }
    const std::string text = to_text(compute_report(diary.data), kUtc);
    check_says(text, {"      left out \"the\" (3 times), left out \"an\" (once)\n",
                      "      \"most heavy\" for \"heaviest\" (once)\n",
                      "      \"it\" where no word belongs (once)\n"});
    CHECK_THAT(text, !Catch::Contains("DET") && !Catch::Contains("ADJ"));
    check_says(to_csv(compute_report(diary.data)), {"M:DET 4; R:ADJ:FORM 1; U:PRON 1"});
}

TEST_CASE("report: points of grammar are counted, and so are the answers since") {
    Diary diary("Mina");
    diary.session("textures").answers("made_of", "FFRUFRRU");
    const ErrorRecord missing{"M:VERB", "", "is", "passive_voice"};
    const ErrorRecord article{"M:DET", "", "a", "article"};
    const std::vector<ErrorRecord> errors[] = {{missing, article}, {missing}, {missing, missing}};
    diary.data.attempts[0].errors = errors[0];
    diary.data.attempts[1].errors = errors[1];
    diary.data.attempts[4].errors = errors[2];
    const Report report = compute_report(diary.data);
    check_says(to_text(report, kUtc),
               {"      slips: passive voice 4 (none in the last 2 answers), article 1 "
                "(none in\n        the last 5 answers)\n"});
    CHECK_THAT(to_csv(report), Catch::Contains("passive_voice 4; article 1") &&
                                   Catch::Contains("passive_voice 2; article 5"));
    // What was kept before points were has none.
    diary.data.attempts[0].errors[1].point.clear();
    check_lacks(to_csv(compute_report(diary.data)), {"article"});
}

TEST_CASE("report: lines are broken between words, and no word is lost") {
    Diary diary("pupil0");
    for (int i = 1; i <= 12; ++i) {
        diary.session("gravity").answers("heaviest", "WWW").learner("pupil" + std::to_string(i));
    }
    std::istringstream words(to_text(compute_report(diary.data), kUtc));
    std::string first_lines;
    for (std::string word; words >> word && word != "(gravity:";) {
        first_lines += word + " ";
    }
    CHECK(first_lines == "Stuck now: pupil0 ");
    words.seekg(0);
    int named = 0;
    for (std::string word; words >> word;) {
        named += word == "heaviest," ? 1 : 0;
    }
    CHECK(named == 12);
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
            const auto character = fulcrum::dialogue::character_at(line, at);
            CHECK(character.valid);
            CHECK_FALSE(is_control(character.code));
            at += character.bytes;
        }
    }
}
