// What pupils say to the lessons' own questions (learners_english.txt, learners_answers.txt): each is understood for what it means, and
// its form is marked.
#include "dialogue/marking/mark_answer.h"
#include "dialogue/marking/question_review.h"
#include "tests/lessons/lesson_questions.h"
#include "tests/lessons/program.h"
#include "tests/unit/dialogue/wrong_sentences.h"

using namespace fulcrum::dialogue;
using namespace fulcrum::test;

namespace {

// Takes what stands before `separator` off; all of it where there is none.
std::string take_before(std::string& text, const std::string& separator) {
    const std::size_t at = text.find(separator);
    const std::string before = text.substr(0, at);
    text.erase(0, at == std::string::npos ? at : at + separator.size());
    return before;
}

// What the lines before have said.
struct Asked {
    std::map<std::string, Questions> lessons;
    const dialogue::Question* question = nullptr;
    std::string slot;     // empty: the words are not to be understood
    bool denied = false;  // they say that it is not so
    std::string value;
    std::string words;
    dialogue::Mark mark;
};

void ask(std::string line, Asked& asked) {
    const std::string lesson = take_before(line, " ");
    if (!asked.lessons.contains(lesson)) {
        asked.lessons.emplace(lesson, questions_of(lesson));
    }
    asked.question = &asked.lessons.at(lesson).at(line);
}

void say(std::string line, Asked& asked) {
    const char sign = line.size() > 1 && line[1] == ' ' ? line[0] : ' ';
    asked.words = line.substr(sign == '!' || sign == '?' ? 2 : 0);
    asked.mark = dialogue::mark_answer(*asked.question, asked.words);
    std::string codes;
    for (const dialogue::FormError& error : asked.mark.form_errors) {
        codes += std::string(error.errant()) + ' ';
    }
    INFO(asked.question->id << ": " << asked.words << " -> " << asked.mark.emphasised << ' '
                            << codes);
    if (sign == '?') {
        return;
    }
    REQUIRE(asked.mark.understood == !asked.slot.empty());
    if (asked.mark.understood) {
        CHECK(asked.mark.slot(asked.slot) == asked.value);
        const bool denies = asked.mark.claim == dialogue::Claim::excluded ||
                            asked.mark.claim == dialogue::Claim::contrary;
        CHECK(denies == asked.denied);
        CHECK(asked.mark.form_right() == (sign != '!'));
    }
}

void check_mark(std::string line, const Asked& asked) {
    const std::string what = take_before(line, ": ");
    const std::map<std::string, std::string> told{{"corrected", asked.mark.corrected},
                                                  {"emphasised", asked.mark.emphasised},
                                                  {"opposite_of", asked.mark.opposite_of}};
    INFO(asked.question->id << ": " << asked.words);
    CHECK(told.at(what) == line);
}

constexpr const char* kLessons[] = {"gravity", "textures", "solar-system", "lever",
                                    "kite",    "stacks",   "maze-park"};

// The examples of one question as Lua: right, wrong, form.
struct SaidAnswers {
    std::string right, wrong, form;
};

// lesson -> question -> what is said to it.
std::map<std::string, std::map<std::string, SaidAnswers>> read_answers(int& n_said) {
    std::map<std::string, std::map<std::string, SaidAnswers>> lessons;
    std::ifstream file(FULCRUM_TEST_LESSONS "/said_answers.txt");
    SaidAnswers* question = nullptr;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line.front() == '#') {
            continue;
        }
        if (line.front() != ' ') {
            const std::size_t blank = line.find(' ');
            question = &lessons[line.substr(0, blank)][line.substr(blank + 1)];
            continue;
        }
        REQUIRE(question != nullptr);
        std::string& examples = line[2] == '-'   ? question->wrong
                                : line[2] == '!' ? question->form
                                                 : question->right;
        examples += "\"" + line.substr(4) + "\", ";
        ++n_said;
    }
    return lessons;
}

// The lesson with these examples in the place of its own.
std::string with_examples(std::string lesson, const std::map<std::string, SaidAnswers>& questions) {
    std::string lua = "local said = {\n";
    for (const auto& [name, said] : questions) {
        lua += "[\"" + name + "\"] = { right = { " + said.right + "}, wrong = { " + said.wrong +
               "}, form = { " + said.form + "} },\n";
    }
    lua += R"(}
local declare = L.question
rawset(L, "question", function(self, id)
  local take = declare(self, id)
  return function(question) question.examples = said[id]; return take(question) end
end)
)";
    const std::size_t bank = lesson.find("bank.declare(L)");
    return lesson.insert(bank != std::string::npos ? bank : lesson.find("know.things(L"), lua);
}

}  // namespace

TEST_CASE("learners' English: what is said is understood, and its form marked") {
    // Whatever is left out of a file, these many were there.
    const struct {
        const char* name;
        int n_said;
    } files[] = {{"learners_english.txt", 325}, {"learners_answers.txt", 826}};
    for (const auto& [name, least_said] : files) {
        std::ifstream file(std::string(FULCRUM_TEST_LESSONS "/") + name);
        Asked asked;
        int n_said = 0;
        for (std::string line; std::getline(file, line);) {
            const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
            line.erase(0, indent);
            if (line.empty() || line.front() == '#') {
                continue;
            }
            if (indent >= 4) {
                check_mark(line, asked);
            } else if (indent > 0) {
                say(line, asked);
                ++n_said;
            } else if (line == "nothing" || line.find(" = ") != std::string::npos) {
                asked.denied = line.starts_with("not ");
                line.erase(0, asked.denied ? 4 : 0);
                asked.slot = line == "nothing" ? "" : take_before(line, " = ");
                asked.value = line;
            } else {
                ask(line, asked);
            }
        }
        CHECK(n_said >= least_said);
    }
}

TEST_CASE("lessons' English: no right sentence of a question has two determiners side by side") {
    for (const char* lesson : kLessons) {
        for (const auto& [id, question] : questions_of(lesson)) {
            INFO(lesson << ", " << id);
            for (const Graph& graph : question.templates->graphs) {
                // What is nearly an answer is never right.
                CHECK(
                    (graph.nearly || right_doubled_determiner(*question.templates, graph).empty()));
            }
            for (const SaidBack& back : said_back(question)) {
                CHECK(doubled_determiner(back.sentence).empty());
            }
        }
    }
}

TEST_CASE("lessons' English: one or two labelled errors are said back in a right sentence") {
    int n_tried = 0;
    for (const char* lesson : kLessons) {
        for (const auto& [id, question] : questions_of(lesson)) {
            INFO(lesson << ", " << id);
            CHECK(wrong_recasts(question, n_tried) == "");
        }
    }
    CHECK(n_tried > 20'000);
}

// What pupils and teachers say to the lessons' questions in good English and bad (said_answers.txt), by the lessons' own verdicts: a right
// answer is right and has no error, a wrong one is wrong, an error is told. Lessons whose things have to be moved for it are left out.
TEST_CASE("said answers: right ones are right, wrong ones wrong, and errors are told") {
    int n_said = 0;
    for (const auto& [lesson, questions] : read_answers(n_said)) {
        const Sandbox sandbox;
        for (const auto& file :
             std::filesystem::directory_iterator(FULCRUM_SCENARIOS "/" + lesson)) {
            const std::string name = file.path().filename().string();
            if (name.ends_with(".lua")) {
                const std::string text = bytes_of(file.path().string());
                sandbox.write(lesson + "/" + name,
                              name == "lesson.lua" ? with_examples(text, questions) : text);
            }
        }
        check_run(sandbox.run("check ./" + lesson), 0, {}, {"is said to be"});
    }
    // Whatever is left out of the file, these many were there.
    CHECK(n_said >= 2300);
}
