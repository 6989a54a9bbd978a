#include "runtime/link/arm_key.h"

#include "tests/unit/runtime/rig.h"

#include <atomic>
#include <sys/stat.h>
#include <thread>

using namespace fulcrum::runtime::test;

namespace {

void write_key(const std::filesystem::path& file, const std::string& text, mode_t mode = 0600) {
    std::ofstream(file) << text;
    REQUIRE(::chmod(file.c_str(), mode) == 0);
}

}  // namespace

TEST_CASE("arm key: made where it is missing, for its owner alone, and the same the next time") {
    const ScratchFolder folder;
    const auto file = folder.path() / "own" / "arm.key";
    const auto made = value_of(load_or_make_arm_key(file));
    struct stat about {};
    REQUIRE(::stat(file.c_str(), &about) == 0);
    CHECK((about.st_mode & 0777) == 0600);
    CHECK(about.st_size == 65);
    const auto again = value_of(load_or_make_arm_key(file));
    CHECK(again == made);
}

TEST_CASE("arm key: many who make it at once all end with the same one") {
    for (int again = 0; again < 20; ++again) {
        const ScratchFolder folder;
        const auto file = folder.path() / "own" / "arm.key";
        constexpr std::size_t kPrograms = 8;
        std::array<std::optional<ArmKey>, kPrograms> keys;
        std::atomic<std::size_t> n_ready{0};
        std::vector<std::thread> programs;
        for (std::size_t i = 0; i < kPrograms; ++i) {
            programs.emplace_back([&, i] {
                ++n_ready;
                while (n_ready.load() < kPrograms) {
                }
                if (const auto key = load_or_make_arm_key(file)) {
                    keys[i] = *key;
                }
            });
        }
        for (std::thread& program : programs) {
            program.join();
        }
        const auto last = value_of(load_or_make_arm_key(file));
        for (const std::optional<ArmKey>& key : keys) {
            REQUIRE(key);
            CHECK(*key == last);
        }
        // Nothing unfinished is left beside it.
        CHECK(std::distance(std::filesystem::directory_iterator(file.parent_path()), {}) == 1);
    }
}

TEST_CASE("arm key: 64 figures, with or without a line's end") {
    const ScratchFolder folder;
    const auto file = folder.path() / "arm.key";
    const std::string figures = "000102030405060708090a0b0c0d0e0f101112131415161718191a1b1c1d1e1f";
    for (const std::string& text : {figures, figures + "\n"}) {
        write_key(file, text);
        const auto key = value_of(load_or_make_arm_key(file));
        for (std::size_t i = 0; i < key.size(); ++i) {
            CHECK(std::to_integer<std::size_t>(key[i]) == i);
        }
    }
}

TEST_CASE("arm key: what is none, or no secret, is refused with its file, and left as it is") {
    const ScratchFolder folder;
    const auto file = folder.path() / "arm.key";
    const std::string figures(64, 'a');
    for (const std::string& text :
         {std::string(), std::string("x"), figures.substr(1), figures + "a", figures + "\n\n",
          figures.substr(1) + "g", figures.substr(1) + "A", std::string(100'000, 'a')}) {
        write_key(file, text);
        CHECK(error_of(load_or_make_arm_key(file)).where == file.string());
        CHECK(std::filesystem::file_size(file) == text.size());
    }
    for (const mode_t mode : {0640, 0604, 0660}) {
        write_key(file, figures, mode);
        check_says(error_of(load_or_make_arm_key(file)).what_to_do, {"chmod 600"});
    }
}
