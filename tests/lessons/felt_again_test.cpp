// Where a lesson has a contrast that can be felt, an error of form in the answer about it lets the hand feel it once more: "replay".
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

/// The second at which the line that comes after the answer `said` and holds `text` was told; 0 where there is none.
double told_after(const std::string& output, const std::string& said, const std::string& text) {
    std::istringstream lines(output);
    bool answered = false;
    for (std::string line; std::getline(lines, line);) {
        answered = answered || line.find("learner  " + said) != std::string::npos;
        if (answered && line.find(text) != std::string::npos) {
            return std::atof(line.c_str());
        }
    }
    return 0.0;
}

}  // namespace

TEST_CASE("felt again: an error of form lets the hand feel the contrast, good English goes on") {
    struct {
        std::string lesson, before, right, wrong, next;
    } const rows[] = {
        {"lever", "", "it is easier far from the support", "it is more easy far from the support",
         "level    2"},
        {"solar-system",
         "eight planets\none moon\nit has two moons\nhow many moons does Saturn have\n",
         "it turns more at the side", "it turn more at the side", "This is Jupiter"},
        {"kite",
         "it needs a tail\nthe lift holds it up\nI feel the tension\nthe lift is stronger than the "
         "drag\n",
         "it pulls more", "it pull more", "asks "},
    };
    for (const auto& row : rows) {
        const Sandbox sandbox;
        const auto pause = [&](const std::string& said) {
            sandbox.write("say.txt", row.before + said + "\n");
            const ProgramRun run =
                sandbox.run("run " + row.lesson + " --headless --say say.txt --seconds 400");
            INFO(run.output);
            const double answered = told_after(run.output, said, "answers");
            CHECK(answered > 0.0);
            return told_after(run.output, said, row.next) - answered;
        };
        INFO(row.lesson);
        const double good = pause(row.right);
        CHECK(good > 0.0);
        CHECK(pause(row.wrong) > good + 3.0);
    }
}
