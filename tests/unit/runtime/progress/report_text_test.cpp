// The report as a teacher reads it.
#include "runtime/progress/report.h"
#include "runtime/progress/text_rules.h"
#include "tests/unit/runtime/progress/diary.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

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
            const Character character = character_at(line, at);
            CHECK(character.valid);
            CHECK_FALSE(is_control(character.code));
            at += character.bytes;
        }
    }
}
