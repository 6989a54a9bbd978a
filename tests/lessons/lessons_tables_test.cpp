// Lessons that are written, checked, played and tested as the tables of the folders here say.
#include "tests/lessons/program.h"
#include "tests/support/table.h"

#include <regex>

using namespace fulcrum::test;

namespace {

std::string lesson_file(const std::string& name) {
    return bytes_of(FULCRUM_TEST_LESSONS "/" + name);
}

/// "words ~> others": the text with others in the place of the words; several are parted by " && ".
std::string edited(std::string text, const std::string& edits) {
    const std::string to = " ~> ";
    for (const std::string& edit : listed(edits, " && ")) {
        INFO(edit);
        const std::size_t mark = edit.find(to);
        REQUIRE(mark != std::string::npos);
        const std::size_t at = text.find(edit.substr(0, mark));
        REQUIRE(at != std::string::npos);
        text.replace(at, mark, edit.substr(mark + to.size()));
    }
    return text;
}

/// Lines parted by " / "; "4 * words" are four of them.
std::string lines_of(const std::string& said) {
    std::string lines;
    for (const std::string& part : listed(said, " / ")) {
        const std::size_t times = part.find(" * ");
        for (int i = times == std::string::npos ? 1 : std::stoi(part); i > 0; --i) {
            lines += part.substr(times == std::string::npos ? 0 : times + 3) + '\n';
        }
    }
    return lines;
}

/// The exit code, and each line without its time, the end without how fast it was.
std::string transcript(const ProgramRun& run) {
    static const std::regex kTime(R"(^ *[0-9]+\.[0-9] s  ([a-z]+) +)");
    static const std::regex kFast(R"( \([0-9]+ times real time\))");
    std::vector<std::string> told{std::to_string(run.exit_code)};
    std::istringstream lines(run.output);
    for (std::string line; std::getline(lines, line);) {
        told.push_back(std::regex_replace(std::regex_replace(line, kTime, "$1: "), kFast, ""));
    }
    return spaced(told, " | ");
}

/// What is told of the question that a learner asks in the base, after it.
std::string told_of_question(const std::string& told) {
    const std::string marks[] = {" (asks) | tells: ", " | "};
    const std::size_t at = told.find(marks[0]);
    const std::size_t begin = at == std::string::npos ? 0 : at + marks[0].size();
    return told.substr(begin, at == std::string::npos ? at : told.find(marks[1], begin) - begin);
}

/// What a table of lessons can do; `@base FILE`, `@hand FILE` and `@edit` choose what is played.
struct Lessons {
    std::string base, hand;

    [[nodiscard]] std::string run(const std::string& lesson, const std::string& arguments,
                                  const std::string& said = "") const {
        const Sandbox sandbox;
        sandbox.write("x/lesson.lua", lesson);
        if (!hand.empty()) {
            sandbox.write("hand.lua", hand);
        }
        sandbox.write("say.txt", lines_of(said));
        return transcript(sandbox.run(arguments));
    }
    void direct(const std::string& word, const std::string& rest) {
        if (word == "base") {
            base = lesson_file(rest);
        } else if (word == "hand") {
            hand = lesson_file(rest);
        } else if (word == "edit") {
            base = edited(base, rest);
        } else {
            REQUIRE(word == "law");
        }
    }
};

/// The base with what goes in for "…".
std::string filled(std::string base, const std::string& in) {
    const std::string gap = "…";
    const std::size_t at = base.find(gap);
    REQUIRE(at != std::string::npos);
    return base.replace(at, gap.size(), in);
}

TableReader told_program() {
    using Text = const std::string&;
    const auto lessons = std::make_shared<Lessons>();
    return {
        {{"edit",
          [=](Text with, Text in) { return lessons->run(edited(lessons->base, in), with); }},
         {"fill",
          [=](Text with, Text in) { return lessons->run(filled(lessons->base, in), with); }},
         {"ask",
          [=](Text, Text in) {
              return told_of_question(lessons->run(lessons->base,
                                                   "run x --headless --hand hand.lua --say say.txt",
                                                   '?' + in + " / it is an egg"));
          }},
         {"say", [=](Text with, Text in) { return lessons->run(lessons->base, with, in); }},
         {"run", [=](Text with, Text in) { return lessons->run(lessons->base, with + ' ' + in); }}},
        [=](Text word, Text rest) { lessons->direct(word, rest); }};
}

void hold(const std::string& folder) {
    hold_tables(FULCRUM_TEST_LESSONS "/" + folder, told_program);
}

}  // namespace

TEST_CASE("teachers' slips: check names the cause, as the table says") {
    hold("slips");
}

TEST_CASE("check: a lesson whose parts are right one by one is tried as the table says") {
    hold("check");
}

TEST_CASE("broken lessons: each is told as the table says") {
    hold("broken");
}

TEST_CASE("asking: what a learner asks and answers is told as the table says") {
    hold("asking");
}

TEST_CASE("lessons: who plays them so is told what the table says") {
    hold("played");
}
