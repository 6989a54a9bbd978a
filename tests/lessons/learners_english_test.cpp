// What pupils say to the lessons' own questions (learners_english.txt, learners_answers.txt): each is understood for what it means, and
// its form is marked.
#include "dialogue/marking/mark.h"
#include "tests/lessons/lesson_questions.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <map>
#include <string>

using namespace fulcrum;
using namespace fulcrum::runtime;
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
