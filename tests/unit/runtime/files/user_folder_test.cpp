#include "runtime/files/user_folder.h"

#include "tests/support/scratch_folder.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <sys/stat.h>

namespace fulcrum::runtime {
namespace {

TEST_CASE("user folder: what the environment names counts where it is absolute") {
    ::setenv("FULCRUM_TEST_FOLDER", "/somewhere", 1);
    CHECK(*find_user_folder("FULCRUM_TEST_FOLDER", ".cache", "") == "/somewhere");
    ::setenv("FULCRUM_TEST_FOLDER", "relative", 1);
    const auto below_home = find_user_folder("FULCRUM_TEST_FOLDER", ".cache", "");
    REQUIRE(below_home);
    CHECK(below_home->is_absolute());
    CHECK(below_home->filename() == ".cache");
    ::unsetenv("FULCRUM_TEST_FOLDER");
    CHECK(*find_user_folder("FULCRUM_TEST_FOLDER", ".cache", "") == *below_home);
}

TEST_CASE("user folder: folders are made for the user alone; one that is a file is told") {
    const ScratchFolder scratch;
    const std::filesystem::path folder = scratch.path() / "a" / "b";
    REQUIRE(create_private_folders(folder, "advice"));
    struct stat about {};
    REQUIRE(::stat(folder.c_str(), &about) == 0);
    CHECK((about.st_mode & 0777U) == 0700);
    CHECK(create_private_folders(folder, "advice"));
    scratch.write("file", "");
    const auto refused = create_private_folders(scratch.path() / "file" / "c", "advice");
    REQUIRE_FALSE(refused);
    CHECK(refused.error().what_to_do == "advice");
    sync_folder(scratch.path() / "nowhere");
}

}  // namespace
}  // namespace fulcrum::runtime
