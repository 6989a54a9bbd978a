// What fulcrum check does with a lesson's file; what it finds in one stands in the table beside that lesson.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

const std::string kCheck = FULCRUM_TEST_LESSONS "/check/lesson.lua";

}  // namespace

TEST_CASE("check: a file that is no UTF-8 text is one sentence") {
    const std::string text = bytes_of(kCheck);
    std::string wide = "\xFF\xFE";
    std::string big_endian;
    for (const char letter : text) {
        wide += {letter, '\0'};
        big_endian += {'\0', letter};
    }
    struct {
        std::string bytes, found;
    } const rows[] = {{wide, "lesson.lua: this is saved as UTF-16, not as UTF-8; save it again"},
                      {big_endian, "this is saved as UTF-16"},
                      {"{\\rtf1\\ansi " + text, "this is a document of a word processor"},
                      {"PK\x03\x04 and so on", "this is a document of a word processor"}};
    for (const auto& row : rows) {
        const Sandbox sandbox;
        sandbox.write("x/lesson.lua", row.bytes);
        const ProgramRun run = sandbox.run("check x");
        INFO(run.output);
        CHECK(run.exit_code != 0);
        CHECK(run.output.find(row.found) != std::string::npos);
        CHECK(std::count(run.output.begin(), run.output.end(), '\n') == 1);
    }
}

TEST_CASE("check: what was found is told again until something changes, or it is asked for anew") {
    const Sandbox sandbox;
    const std::string note = "lesson.lua:8: question \"second\": ";
    std::string text = bytes_of(kCheck);
    text.replace(text.find("a.feel == \"soft\""), 16, "a.feel == \"sotf\"");
    sandbox.write("x/lesson.lua", text);
    const ProgramRun first = sandbox.run("check x");
    check_run(first, 0, {note}, {"nothing has changed"});
    const auto is_told_again = [&](const ProgramRun& run) {
        return run.exit_code == 0 &&
               run.output.starts_with(first.output + "This was found on 20") &&
               run.output.ends_with(
                   ", and nothing has changed since; to look anew, add --again.\n");
    };
    const ProgramRun second = sandbox.run("check x");
    INFO(second.output);
    CHECK(is_told_again(second));
    CHECK(sandbox.run("check x --again").output == first.output);
    // Ended in the middle it keeps nothing, and what is kept stays.
    const ProgramRun ended = sandbox.run("check x --again", "timeout -s INT 0.2");
    check_run(ended, {}, {}, {"another scene"});
    CHECK(is_told_again(sandbox.run("check x")));
    CHECK(sandbox.run("check x --force-limit 2").output == first.output);
    sandbox.write("x/lesson.lua", "-- mended\n" + text);
    check_run(sandbox.run("check x"), 0, {"lesson.lua:9: question"}, {"nothing has changed"});
    // What fails is looked at each time, and leaves nothing behind.
    sandbox.write("x/lesson.lua", text + "x = ");
    for (int i = 0; i < 2; ++i) {
        check_run(sandbox.run("check x"), 1, {"lesson.lua:"}, {"nothing has changed"});
    }
    sandbox.write("x/lesson.lua", "-- mended\n" + text);
    check_run(sandbox.run("check x"), 0, {"nothing has changed"});
}

TEST_CASE("check: each word that the seven lessons show is common, or named or taught there") {
    const Sandbox sandbox;
    for (const char* lesson :
         {"gravity", "textures", "solar-system", "lever", "kite", "maze-park", "stacks"}) {
        const ProgramRun run = sandbox.run(std::string("check ") + lesson);
        INFO(run.output);
        CHECK(run.exit_code == 0);
        CHECK(run.output.find("no common word") == std::string::npos);
    }
}

TEST_CASE("check: a word that is not common is told with its line, once, unless it is taught") {
    const Sandbox sandbox;
    const auto check = [&](const std::string& level, const std::string& taught) {
        sandbox.write("own/lesson.lua",
                      "local L = lesson { id = 'own', title = 'Own', level = '" + level + "' }\n" +
                          taught +
                          "\nfunction L:start(world)\n"
                          "  world:caption \"The walrus is big.\"\n"
                          "  world:caption \"Walruses like London.\"\nend\nreturn L\n");
        return sandbox.run("check own --quick").output;
    };
    for (const char* level : {"A1", "A2"}) {
        const std::string told = check(level, "");
        CHECK_THAT(told, Catch::Contains("lesson.lua:4: \"walrus\" in \"The walrus is big.\" is no "
                                         "common word for level " +
                                         std::string(level)));
        CHECK(told.find("lesson.lua:5") == std::string::npos);
    }
    CHECK(check("A1", "require('know').words(L, { walrus = 'A walrus is a big animal.' })")
              .find("common word") == std::string::npos);
    CHECK(check("B1", "").find("common word") == std::string::npos);
}
