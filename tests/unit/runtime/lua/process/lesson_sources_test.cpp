#include "runtime/lua/process/lesson_sources.h"

#include "tests/unit/runtime/lua/lesson_folder.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <sys/stat.h>

namespace fulcrum::runtime {
namespace {

using test::LessonFolder;
namespace fs = std::filesystem;

TEST_CASE("lesson sources: a module comes from the library first, then from the lesson's folder") {
    const LessonFolder folder;
    folder.write("story.lua", "mine");
    folder.write("helper.lua", "return 1");
    LessonSources sources(folder.files());
    CHECK(sources.find_module("story").source.name == "lib/story.lua");
    const ModuleAnswer helper = sources.find_module("helper");
    CHECK(helper.found);
    CHECK(helper.source.name == "helper.lua");
    CHECK(helper.source.text == "return 1");
    CHECK(sources.known_name("helper.lua") == "helper.lua");
    CHECK(sources.known_name("/etc/passwd") == "lesson.lua");
}

TEST_CASE("lesson sources: names that lead elsewhere, links, pipes and folders are refused") {
    const LessonFolder folder;
    LessonSources sources(folder.files());
    for (const char* name : {"", "..", "../x", "a/b", "/etc/passwd", "a.b", "A", "a-b"}) {
        CHECK_FALSE(sources.find_module(name).found);
    }
    fs::create_symlink("/etc/passwd", folder.path() / "link.lua");
    CHECK(sources.find_module("link").problem == "the file can't be read (is a symbolic link)");
    REQUIRE(mkfifo((folder.path() / "pipe.lua").c_str(), 0600) == 0);
    CHECK(sources.find_module("pipe").problem == "this is no plain file");
    fs::create_directory(folder.path() / "folder.lua");
    CHECK_FALSE(sources.find_module("folder").found);
    CHECK(sources.find_module("nothing").problem ==
          "there is no nothing.lua beside the lesson nor in the library");
    folder.write("know.lua", "return 1");
    CHECK(sources.find_module("now").problem ==
          "there is no now.lua beside the lesson nor in the library; did you mean \"know\"?");
}

TEST_CASE(
    "lesson sources: a byte order mark goes, compiled Lua and giants are refused, the largest is "
    "read") {
    const LessonFolder folder;
    LessonSources sources(folder.files());
    folder.write("lesson.lua", "\xEF\xBB\xBFreturn 1");
    CHECK(sources.read_lesson()->text == "return 1");
    folder.write("lesson.lua", "\x1BLua");
    CHECK_THAT(to_sentence(sources.read_lesson().error()), Catch::Contains("this is compiled Lua"));
    folder.write("lesson.lua", std::string(kMaxSourceBytes, ' '));
    CHECK(sources.read_lesson()->text.size() == kMaxSourceBytes);
    folder.write("lesson.lua", std::string(kMaxSourceBytes + 1, ' '));
    CHECK_THAT(to_sentence(sources.read_lesson().error()), Catch::Contains("longer than 512 KB"));
}

TEST_CASE("lesson sources: a missing lesson is one sentence") {
    const LessonFolder folder;
    LessonSources sources(folder.files());
    CHECK_THAT(to_sentence(sources.read_lesson().error()),
               Catch::Contains("lesson.lua: the file can't be read (No such file or directory); "
                               "check the name and the folder."));
}

TEST_CASE("lesson sources: at most so many files") {
    const LessonFolder folder;
    LessonSources sources(folder.files());
    int n_found = 0;
    for (int i = 0; i < 40; ++i) {
        const std::string name = "m" + std::to_string(i);
        folder.write(name + ".lua", "");
        n_found += sources.find_module(name).found ? 1 : 0;
    }
    CHECK(n_found == 32);
}

}  // namespace
}  // namespace fulcrum::runtime
