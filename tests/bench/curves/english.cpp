// How well free English is checked: on sentences made from the lessons' own templates, right ones and such with one error,
// and on learners' text that a person has (--text FILE). And what checking costs.
#include "dialogue/checking/link_grammar/link_judge.h"
#include "dialogue/checking/reading.h"
#include "dialogue/marking/mark_answer.h"
#include "runtime/lesson/free_english.h"
#include "runtime/lesson/questions.h"
#include "runtime/lua/process/lesson_process.h"
#include "tests/bench/curves/english_errors.h"
#include "tests/bench/curves/english_scores.h"
#include "tests/bench/harness/curve.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>

namespace fulcrum::bench {
namespace {

using namespace fulcrum::dialogue;
namespace fs = std::filesystem;

constexpr unsigned kSeed = 20'261;

/// Kilobytes of memory that this process holds.
double resident_kB() {
    std::ifstream file("/proc/self/statm");
    double pages = 0.0;
    double resident = 0.0;
    file >> pages >> resident;
    return resident * 4.0;
}

/// All questions of a lesson as it is shipped, and the things that it shows.
struct ShippedLesson {
    std::map<std::string, Question> questions;
    std::vector<std::string> things;
};

ShippedLesson shipped(const fs::path& folder) {
    runtime::LessonFiles files;
    files.folder = folder;
    files.library = fs::path(FULCRUM_SOURCE_DIR) / "scripts/lib";
    const runtime::LessonDescription description =
        must(runtime::LessonProcess::start(files))->description();
    return {must(runtime::compile_questions(description)), runtime::things_of(description)};
}

EnglishChecker make_checker(std::unique_ptr<SentenceJudge> judge) {
    return {must(Lexicon::open()), std::move(judge)};
}

std::string percent(int part, int whole) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%.1f", 100.0 * part / whole);
    return whole == 0 ? "" : text.data();
}

std::string point_of_alarms(int alarms, int sentences) {
    return std::to_string(alarms) + " of " + std::to_string(sentences);
}

/// Shows sentences that were judged wrongly, for whoever works on the rules: FULCRUM_SHOW=1.
void show(const char* what, const std::string& code, const CheckedText& checked) {
    static const bool shows = std::getenv("FULCRUM_SHOW") != nullptr;
    if (shows) {
        std::printf("%s %s: %s\n", what, code.c_str(), checked.marked.c_str());
    }
}

void add_row(const std::string& code, const EnglishScore& score, Sheet& sheet) {
    sheet.add({code, score.there, percent(score.found, score.there),
               percent(score.named, score.there), score.alarms,
               percent(score.right_place, score.alarms)});
}

void add_rows(const EnglishScores& scores, Sheet& sheet) {
    EnglishScore all;
    for (const auto& [code, score] : scores) {
        if (score.alarms == 0 && score.named == 0 && !sheet.name.starts_with("english-l")) {
            continue;
        }
        add_row(code, score, sheet);
        all.there += score.there;
        all.found += score.found;
        all.named += score.named;
        all.alarms += score.alarms;
        all.right_place += score.right_place;
    }
    add_row("all of these", all, sheet);
}

/// Counts what was found in a sentence with one error.
void add_sentence(const char* missed, const ErroneousSentence& wrong, const CheckedText& checked,
                  EnglishScores& scores) {
    bool found = false;
    bool named = false;
    for (const FreeError& error : checked.errors) {
        // What is missing has no letters: its neighbours' are as good.
        const bool touches = error.begin <= wrong.end + 1 && wrong.begin <= error.end + 1;
        EnglishScore& alarmed = scores[std::string(errant_code(error.code))];
        ++alarmed.alarms;
        alarmed.right_place += touches ? 1 : 0;
        found = found || touches;
        named = named || (touches && errant_code(error.code) == wrong.code);
    }
    EnglishScore& score = scores[wrong.code];
    ++score.there;
    score.found += found ? 1 : 0;
    score.named += named ? 1 : 0;
    if (!found) {
        show(missed, wrong.code, checked);
    }
}

Sheet lesson_sheet(const std::string& name, const std::string& title) {
    Sheet sheet;
    sheet.name = name;
    sheet.title = title;
    sheet.columns = {"error",      "n",      "found %",
                     "named so %", "alarms", "alarms in the right place %"};
    sheet.advice = "What a template foresees it marks itself; this is for what is said beside it.";
    return sheet;
}

/// "Than the egg is" without its verb, "it is metal" for "it is made of metal": another of the question's right sentences.
bool is_right_too(const Question& question, const std::string& sentence) {
    const Mark mark = mark_answer(question, sentence);
    return mark.understood && mark.form_right();
}

/// What was counted in the lessons' sentences.
struct LessonScores {
    EnglishScores put_in, labelled;
    int right = 0;
    int false_alarms = 0;
};

/// Sentences of a question: right ones, those with an error put in, and those with an error that a template labels.
void add_question(EnglishChecker& checker, const Lexicon& lexicon, const Question& question,
                  const TemplateSentences& made, LessonScores& scores) {
    for (const std::string& sentence : made.right) {
        const CheckedText checked = checker.check(sentence);
        ++scores.right;
        scores.false_alarms += static_cast<int>(checked.errors.size());
        if (!checked.errors.empty()) {
            show("alarm", std::string(errant_code(checked.errors.front().code)), checked);
        }
        for (const ErroneousSentence& wrong : spoil(lexicon, sentence)) {
            if (!is_right_too(question, wrong.text)) {
                add_sentence("missed", wrong, checker.check(wrong.text), scores.put_in);
            }
        }
    }
    for (const ErroneousSentence& wrong : made.wrong) {
        add_sentence("missed, labelled", wrong, checker.check(wrong.text), scores.labelled);
    }
}

Sheet make_lesson_sheet(const char* name, const char* title, const std::string& work,
                        const LessonScores& scores) {
    Sheet sheet = lesson_sheet(name, title);
    sheet.work = work + " Alarms in the right sentences: " +
                 point_of_alarms(scores.false_alarms, scores.right) + ".";
    add_rows(scores.put_in, sheet);
    return sheet;
}

std::array<Sheet, 3> check_lessons(EnglishChecker& checker, Run& run) {
    LessonScores own;
    LessonScores followed;
    auto lexicon = Lexicon::open();
    for (const auto& entry : fs::directory_iterator(fs::path(FULCRUM_SOURCE_DIR) / "scenarios")) {
        if (!fs::exists(entry.path() / "lesson.lua")) {
            continue;
        }
        const ShippedLesson lesson = shipped(entry.path());
        checker.set_things(lesson.things);
        for (const auto& [id, question] : lesson.questions) {
            add_question(
                checker, *lexicon, question,
                make_template_sentences(question, SentencesOf::author, run.pick(400, 40), kSeed),
                own);
            add_question(
                checker, *lexicon, question,
                make_template_sentences(question, SentencesOf::english, run.pick(40, 8), kSeed),
                followed);
        }
    }
    checker.set_things({});
    Sheet labelled = lesson_sheet("english-labelled", "Free English: what templates label");
    labelled.work =
        "The same with one error that a template labels, which no reading of the checker chose. "
        "Some of these are good English for something else (\"It was easy\"), which only the "
        "question tells.";
    add_rows(own.labelled, labelled);
    const std::string spoilt =
        "each way sampled, and every such sentence with one error put in, where the checker's own "
        "reading of the sentence finds a place for it and no other right sentence of the template "
        "comes of it.";
    return {make_lesson_sheet("english-lessons", "Free English: what the lessons teach",
                              "The sentences that the lessons' templates make, " + spoilt, own),
            make_lesson_sheet("english-followed", "Free English: what follows from the lessons",
                              "What is understood besides, in other words: negations, equality, "
                              "turned comparisons; " +
                                  spoilt,
                              followed),
            std::move(labelled)};
}

/// Learners' text from a file.
Sheet check_text(EnglishChecker& checker, const std::string& file, bool second_half) {
    const std::vector<LearnerLine> lines = must(read_learner_lines(file));
    const std::string half = second_half ? "odd" : "even";
    Sheet sheet =
        lesson_sheet("english-text-" + half, "Free English: learners' text, " + half +
                                                 " lines of " + fs::path(file).filename().string());
    EnglishScores scores;
    int right = 0;
    int sentences = 0;
    int false_alarms = 0;
    auto lexicon = Lexicon::open();
    for (std::size_t i = second_half ? 1 : 0; i < lines.size(); i += 2) {
        const LearnerLine& line = lines[i];
        const std::string& good = line.right ? line.said : line.corrected;
        if (!good.empty()) {
            const CheckedText checked = checker.check(good);
            ++right;
            sentences += static_cast<int>(read_sentences(*lexicon, good).size());
            false_alarms += static_cast<int>(checked.errors.size());
            if (!checked.errors.empty()) {
                show("alarm", std::string(errant_code(checked.errors.front().code)), checked);
            }
        }
        if (line.right || line.codes.empty()) {
            continue;
        }
        const CheckedText checked = checker.check(line.said);
        if (line.corrected.empty()) {
            EnglishScore& score = scores[line.codes.front()];
            ++score.there;
            score.found += checked.errors.empty() ? 0 : 1;
            score.alarms += static_cast<int>(checked.errors.size());
            score.right_place += static_cast<int>(checked.errors.size());
            continue;
        }
        add_line(line, checked, scores);
        if (!checked.errors.empty()) {
            show("said", std::string(errant_code(checked.errors.front().code)), checked);
        }
    }
    sheet.work =
        "Lines of learners' text, and the same as it was corrected. Alarms in what is right: " +
        std::to_string(false_alarms) + " in " + std::to_string(right) + " lines, " +
        std::to_string(sentences) + " sentences.";
    sheet.advice =
        "The rules were written with the even lines in view; the odd ones are the measure.";
    add_rows(scores, sheet);
    return sheet;
}

/// What it costs to have a checker and to ask it.
Sheet measure_checker(Run& run) {
    Sheet sheet{"english-cost",
                "Free English: what checking costs",
                "The word lists and the grammar are opened, then sentences are checked, each timed "
                "on its own; without the grammar the words alone decide.",
                "A lesson that calls for no free English opens neither.",
                {"what", "median us", "99 % us", "kB"}};
    const double before_kB = resident_kB();
    std::optional<EnglishChecker> plain;
    const Took words =
        time_once([&] { plain.emplace(make_checker(std::make_unique<NullJudge>())); });
    const double with_words_kB = resident_kB();
    std::unique_ptr<SentenceJudge> judge;
    const Took grammar = time_once([&] { judge = must(make_link_judge()); });
    const double with_grammar_kB = resident_kB();
    sheet.add({"open the word lists", words.clock_us, "", with_words_kB - before_kB});
    sheet.add({"open the grammar", grammar.clock_us, "", with_grammar_kB - with_words_kB});
    EnglishChecker whole = make_checker(std::move(judge));
    const Timing timing{run.pick(2000, 100), 1, 20};
    for (const char* text :
         {"The watermelon is the heaviest fruit.", "It have two moon.",
          "I felt apple and it was more heavier then the egg, because it is big."}) {
        for (EnglishChecker* checker : {&*plain, &whole}) {
            const Cost cost = measure_cost([&] { keep(checker->check(text)); }, timing);
            sheet.add({std::string(checker == &whole ? "" : "words alone: ") + text, cost.median_us,
                       cost.p99_us, ""});
        }
    }
    return sheet;
}

Report run_english(Run& run) {
    Report report;
    report.emplace_back(measure_checker(run));
    EnglishChecker checker = make_checker(must(make_link_judge()));
    run.progress(0.2);
    for (Sheet& sheet : check_lessons(checker, run)) {
        report.emplace_back(std::move(sheet));
    }
    if (!run.text_file().empty()) {
        run.progress(0.6);
        report.emplace_back(check_text(checker, run.text_file(), false));
        report.emplace_back(check_text(checker, run.text_file(), true));
    }
    return report;
}

const Registration kEnglish{
    {"english", "free English: how many errors are found, how often one is seen where none is",
     run_english}};

}  // namespace
}  // namespace fulcrum::bench
