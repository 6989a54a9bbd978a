// What pupils and teachers say to the lessons' questions in good English and bad (said_answers.txt), by the lessons' own verdicts: a right
// answer is right and has no error, a wrong one is wrong, an error is told. Lessons whose things have to be moved for it are left out.
#include "tests/lessons/program.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

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

std::string text_of(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("said answers: right ones are right, wrong ones wrong, and errors are told") {
    int n_said = 0;
    for (const auto& [lesson, questions] : read_answers(n_said)) {
        const Sandbox sandbox;
        for (const auto& file :
             std::filesystem::directory_iterator(FULCRUM_SCENARIOS "/" + lesson)) {
            const std::string name = file.path().filename().string();
            if (name.ends_with(".lua")) {
                const std::string text = text_of(file.path().string());
                sandbox.write(lesson + "/" + name,
                              name == "lesson.lua" ? with_examples(text, questions) : text);
            }
        }
        const ProgramRun run = sandbox.run("check ./" + lesson);
        INFO(run.output);
        CHECK(run.exit_code == 0);
        CHECK(run.output.find("is said to be") == std::string::npos);
    }
    // Whatever is left out of the file, these many were there.
    CHECK(n_said >= 2300);
}
