#include "runtime/link/arm_key.h"

#include "tests/support/scratch_folder.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>
#include <string>
#include <sys/stat.h>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

void write_key(const std::filesystem::path& file, const std::string& text, mode_t mode = 0600) {
    std::ofstream(file) << text;
    REQUIRE(::chmod(file.c_str(), mode) == 0);
}

}  // namespace

TEST_CASE("arm key: made where it is missing, for its owner alone, and the same the next time") {
    const ScratchFolder folder;
    const auto file = folder.path() / "own" / "arm.key";
    const auto made = load_or_make_arm_key(file);
    REQUIRE(made);
    struct stat about {};
    REQUIRE(::stat(file.c_str(), &about) == 0);
    CHECK((about.st_mode & 0777) == 0600);
    CHECK(about.st_size == 65);
    const auto again = load_or_make_arm_key(file);
    REQUIRE(again);
    CHECK(*again == *made);
}

TEST_CASE("arm key: 64 figures, with or without a line's end") {
    const ScratchFolder folder;
    const auto file = folder.path() / "arm.key";
    const std::string figures = "000102030405060708090a0b0c0d0e0f101112131415161718191a1b1c1d1e1f";
    for (const std::string& text : {figures, figures + "\n"}) {
        write_key(file, text);
        const auto key = load_or_make_arm_key(file);
        REQUIRE(key);
        for (std::size_t i = 0; i < key->size(); ++i) {
            CHECK(std::to_integer<std::size_t>((*key)[i]) == i);
        }
    }
}

TEST_CASE(
    "arm key: what is none, or is no secret, is refused with its file's name and left as it is") {
    const ScratchFolder folder;
    const auto file = folder.path() / "arm.key";
    const std::string figures(64, 'a');
    for (const std::string& text :
         {std::string(), std::string("x"), figures.substr(1), figures + "a", figures + "\n\n",
          figures.substr(1) + "g", figures.substr(1) + "A", std::string(100'000, 'a')}) {
        write_key(file, text);
        const auto key = load_or_make_arm_key(file);
        REQUIRE_FALSE(key);
        CHECK(key.error().where == file.string());
        CHECK(std::filesystem::file_size(file) == text.size());
    }
    for (const mode_t mode : {0640, 0604, 0660}) {
        write_key(file, figures, mode);
        const auto key = load_or_make_arm_key(file);
        REQUIRE_FALSE(key);
        CHECK(key.error().what_to_do.find("chmod 600") != std::string::npos);
    }
}
