#include "dialogue/english/sorted_lines.h"

#include "tests/support/scratch_folder.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

SortedLines opened(const fulcrum::ScratchFolder& folder, const std::string& text) {
    folder.write("lines", text);
    auto lines = SortedLines::open((folder.path() / "lines").string(), "some-package");
    REQUIRE(lines);
    return std::move(*lines);
}

}  // namespace

TEST_CASE("sorted lines: every line is found by its beginning, and what isn't there is not") {
    const fulcrum::ScratchFolder folder;
    const SortedLines lines = opened(folder, "ant 1\nbee 2\nbee 3\nbeetle 4\ncat 5\n");
    CHECK(lines.starting_with("ant ") == "ant 1\n");
    CHECK(lines.starting_with("bee ") == "bee 2\nbee 3\n");
    CHECK(lines.starting_with("bee") == "bee 2\nbee 3\nbeetle 4\n");
    CHECK(lines.starting_with("cat ") == "cat 5\n");
    CHECK(lines.starting_with("a") == "ant 1\n");
    CHECK(lines.starting_with("aa").empty());
    CHECK(lines.starting_with("bef").empty());
    CHECK(lines.starting_with("zoo").empty());
    CHECK(lines.starting_with("").size() == lines.text().size());
}

TEST_CASE("sorted lines: a last line without its end, and one line alone") {
    const fulcrum::ScratchFolder folder;
    CHECK(opened(folder, "ant 1\nbee 2").starting_with("bee ") == "bee 2");
    CHECK(opened(folder, "ant 1").starting_with("ant") == "ant 1");
    CHECK(opened(folder, "\n").starting_with("a").empty());
}

TEST_CASE("sorted lines: what cannot be read is named with its package") {
    const fulcrum::ScratchFolder folder;
    folder.write("empty", "");
    for (const std::string name : {"missing", "empty", "."}) {
        const auto lines = SortedLines::open((folder.path() / name).string(), "some-package");
        REQUIRE_FALSE(lines);
        CHECK(lines.error().message.find(name) != std::string::npos);
        CHECK(lines.error().message.find("some-package") != std::string::npos);
    }
}
