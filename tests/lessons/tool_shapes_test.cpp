// What takes long to make for a tool is made once for a user, whatever happens to the program or the files meanwhile.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

namespace fs = std::filesystem;

const std::string kExplain = std::string("explain ") + FULCRUM_TEST_LESSONS "/banana";

// What is kept in the sandbox's cache.
std::vector<fs::path> kept_in(const Sandbox& sandbox, const char* ending) {
    std::vector<fs::path> all;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(sandbox.path(".cache/fulcrum/shapes"), none)) {
        if (entry.path().extension() == ending) {
            all.push_back(entry.path());
        }
    }
    return all;
}

bool says(const ProgramRun& run, const char* words) {
    return run.output.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("tool shapes: made at the first start, read at the next, and played with both") {
    const Sandbox sandbox;
    const ProgramRun first = sandbox.run(kExplain);
    INFO(first.output);
    check_run(first, 0, {"banana", "B, made now\n"});
    CHECK_FALSE(kept_in(sandbox, ".shape").empty());
    CHECK(kept_in(sandbox, ".tmp").empty());
    // No terminal: no line that says how far it has come.
    CHECK_FALSE(says(first, "%"));
    check_run(sandbox.run(kExplain), 0, {"B, from the cache\n"});
    check_run(sandbox.run(std::string("run ") +
                          FULCRUM_TEST_LESSONS "/banana --headless --seconds 4 --hand " +
                          FULCRUM_TEST_LESSONS "/touch/press.lua"),
              0, {"touched ball"});
}

TEST_CASE("tool shapes: a damaged file is told in one sentence and made again") {
    const Sandbox sandbox;
    REQUIRE(sandbox.run(kExplain).exit_code == 0);
    // What is made quickly is not kept: how many there are is the machine's affair.
    const auto kept = kept_in(sandbox, ".shape");
    REQUIRE_FALSE(kept.empty());
    for (const fs::path& shape : kept) {
        fs::resize_file(shape, fs::file_size(shape) / 2);
    }
    const ProgramRun damaged = sandbox.run(kExplain);
    INFO(damaged.output);
    CHECK(damaged.exit_code == 0);
    for (const fs::path& shape : kept) {
        check_says(damaged.output, {(shape.string() +
                                     ": the kept shape is cut off or too long; it is made again.\n")
                                        .c_str()});
    }
    CHECK(says(damaged, "B, made now\n"));
    check_run(sandbox.run(kExplain), {}, {"B, from the cache\n"}, {"made again"});
}

TEST_CASE("tool shapes: a program killed at any step of writing leaves whole files or none") {
    std::size_t n_unfinished = 0;
    // Folders are synced as well; a step that never comes kills nobody.
    for (const char* step :
         {"write 1", "fsync 1", "fsync 2", "fsync 3", "fsync 4", "fsync 5", "renameat 1"}) {
        const std::string call = std::string(step).substr(0, std::string(step).find(' '));
        const Sandbox sandbox;
        const ProgramRun killed = sandbox.run(
            kExplain, "strace -f -o /dev/null -e trace=" + call + " -e inject=" + call +
                          ":signal=KILL:when=" + std::string(step).substr(call.size() + 1));
        INFO(step << killed.output);
        if (killed.exit_code == 127 || says(killed, "strace: ")) {
            WARN("skipped: no strace (Debian package strace), or none is allowed");
            return;
        }
        CHECK(killed.exit_code != 0);
        n_unfinished += kept_in(sandbox, ".tmp").size();
        check_run(sandbox.run(kExplain), 0, {}, {"made again"});
        CHECK(says(sandbox.run(kExplain), "B, from the cache\n"));
    }
    CHECK(n_unfinished >= 2);
}

TEST_CASE("tool shapes: what cannot be kept is told, and costs time alone") {
    const Sandbox sandbox;
    sandbox.write("elsewhere/notes", "");
    fs::create_directories(sandbox.path(".cache/fulcrum"));
    fs::create_directory_symlink(sandbox.path("elsewhere"), sandbox.path(".cache/fulcrum/shapes"));
    const ProgramRun run = sandbox.run(kExplain);
    INFO(run.output);
    check_run(run, 0, {"this is a link, where a folder should be", "B, made now\n"});
    CHECK(std::distance(fs::directory_iterator(sandbox.path("elsewhere")), {}) == 1);
    // Files may not become long: that is no end of the program.
    const Sandbox narrow;
    check_run(narrow.run(kExplain, "prlimit --fsize=100000"), 0,
              {"this shape can't be kept: File too large"});
    for (const fs::path& shape : kept_in(narrow, ".shape")) {
        CHECK(fs::file_size(shape) < 1000);  // what little there is was written whole
    }
    CHECK(kept_in(narrow, ".tmp").empty());
}

TEST_CASE("tool shapes: Ctrl-C while they are made ends the program at once, without a word") {
    const Sandbox sandbox;
    std::string text =
        "local L = lesson { id = \"many\", title = \"Many\" }\nfunction L:start(world)\n";
    for (int i = 0; i < 8; ++i) {
        text += "  world:body { name = \"ball" + std::to_string(i) +
                "\", model = \"sphere\", solid = true, radius = 0.1" + std::to_string(i) +
                ", at = { " + std::to_string(i) + ", 0, 0 } }\n";
    }
    sandbox.write("many/lesson.lua",
                  text + "  world:hand { tool = { points = 200000 } }\nend\nreturn L\n");
    for (const char* signal : {"INT", "TERM"}) {
        const ProgramRun run = sandbox.run(
            "explain many", std::string("timeout --preserve-status -s ") + signal + " 1");
        INFO(signal);
        CHECK(run.output.empty());
        CHECK(run.exit_code == (signal == std::string("INT") ? 130 : 143));
        CHECK(kept_in(sandbox, ".tmp").empty());
    }
}
