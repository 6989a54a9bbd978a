#include "runtime/files/other_writers.h"

#include "tests/support/scratch_folder.h"

#include <catch2/catch.hpp>

#include <filesystem>

namespace fulcrum::runtime {
namespace {

TEST_CASE("other writers: everybody, and a group that is not the owner's own") {
    struct stat about {};
    about.st_uid = about.st_gid = 1000;
    for (const mode_t mode : {0600, 0644, 0664, 0755, 0775}) {
        CAPTURE(mode);
        about.st_mode = mode;
        CHECK_FALSE(may_others_write(about));
    }
    about.st_mode = 0666;
    CHECK(may_others_write(about));
    about.st_gid = 100;
    about.st_mode = 0664;
    CHECK(may_others_write(about));
    about.st_mode = 0644;
    CHECK_FALSE(may_others_write(about));
}

TEST_CASE("other writers: of a file, and of the folder where it really lies") {
    const ScratchFolder scratch;
    const std::filesystem::path folder = scratch.path() / "folder";
    std::filesystem::create_directory(folder);
    const std::filesystem::path file = folder / "file";
    const std::filesystem::path link = scratch.path() / "link";
    scratch.write("folder/file", "");
    std::filesystem::create_symlink("folder/file", link);
    const auto has_writers = [&](mode_t of_file, mode_t of_folder) {
        REQUIRE(::chmod(file.c_str(), of_file) == 0);
        REQUIRE(::chmod(folder.c_str(), of_folder) == 0);
        CHECK(find_other_writers(file).has_value() == find_other_writers(link).has_value());
        return find_other_writers(link).value_or("nobody");
    };
    CHECK(has_writers(0644, 0755) == "nobody");
    CHECK(has_writers(0646, 0755) == "others may write to this file");
    CHECK(has_writers(0644, 0757) == "others may write to the folder of this file");
    CHECK(has_writers(0644, 01777) == "nobody");  // as /tmp
    CHECK(has_writers(0600, 0700) == "nobody");
    CHECK_FALSE(find_other_writers(scratch.path() / "nowhere"));
}

TEST_CASE("other writers: which link leads nowhere") {
    const ScratchFolder scratch;
    const std::filesystem::path& at = scratch.path();
    scratch.write("file", "");
    std::filesystem::create_symlink("nowhere", at / "link");
    std::filesystem::create_symlink(at, at / "whole");
    CHECK(find_dangling_link(at / "link") == at / "link");
    CHECK(find_dangling_link(at / "link" / "below" / "file") == at / "link");
    CHECK(find_dangling_link(at / "whole" / "link") == at / "whole" / "link");
    CHECK_FALSE(find_dangling_link(at / "whole" / "file"));
    CHECK_FALSE(find_dangling_link(at / "file"));
    CHECK_FALSE(find_dangling_link(at / "none" / "file"));
}

}  // namespace
}  // namespace fulcrum::runtime
