#include "runtime/files/private_folder.h"
#include "runtime/files/user_folder.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/runtime/files/own_program.h"
#include "tests/unit/runtime/rig.h"

#include <cerrno>
#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace fulcrum::runtime::test;

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kAnyLength = 1U << 20U;
constexpr uid_t kAnother = 65533;

std::vector<std::byte> bytes_of(const std::string& text) {
    const auto raw = std::as_bytes(std::span(text));
    return {raw.begin(), raw.end()};
}

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

PrivateFolder folder_at(const fs::path& path) {
    auto folder = PrivateFolder::create(path, "advice");
    REQUIRE(folder);
    return std::move(*folder);
}

// A folder that is another user's: one of the system's, or for root one that is given away.
fs::path find_foreign_folder(const ScratchFolder& scratch) {
    if (::geteuid() != 0) {
        return "/usr";
    }
    const fs::path given = scratch.path() / "given";
    fs::create_directory(given);
    REQUIRE(::chown(given.c_str(), kAnother, static_cast<gid_t>(-1)) == 0);
    return given;
}

}  // namespace

TEST_CASE("private folder: what is replaced is read again, by its owner alone") {
    const ScratchFolder scratch;
    const PrivateFolder folder = folder_at(scratch.path() / "a" / "b");
    const fs::path at = scratch.path() / "a" / "b";
    CHECK_FALSE(*folder.read("x", kAnyLength));
    REQUIRE(folder.replace("x", bytes_of("first")) == 0);
    REQUIRE(folder.replace("x", bytes_of("second")) == 0);
    CHECK(**folder.read("x", 6) == bytes_of("second"));
    CHECK_FALSE(folder.read("x", 5));
    struct stat about {};
    REQUIRE(::stat((at / "x").c_str(), &about) == 0);
    CHECK((about.st_mode & 0777U) == 0600);
    const auto files = folder.list();
    REQUIRE(files.size() == 1);
    CHECK(files.front().name == "x");
    CHECK(files.front().bytes == 6);
    folder.remove("x");
    folder.remove("x");
    CHECK(folder.list().empty());
    CHECK_FALSE(*PrivateFolder::open(scratch.path() / "nowhere", "advice"));
}

TEST_CASE("private folder: a link, a file, another's and what others may write to are refused") {
    const ScratchFolder scratch;
    folder_at(scratch.path() / "own");
    fs::create_directory_symlink(scratch.path() / "own", scratch.path() / "link");
    scratch.write("file", "");
    fs::create_directory(scratch.path() / "open");
    const auto refused = [&](const fs::path& path, const std::string& sentence) {
        const auto opened = PrivateFolder::open(path, "choose another");
        const auto created = PrivateFolder::create(path, "choose another");
        return !opened && !created &&
               to_sentence(opened.error()) == path.string() + ": " + sentence + "; choose another.";
    };
    CHECK(refused(scratch.path() / "link", "this is a link, where a folder should be"));
    CHECK_FALSE(PrivateFolder::open(scratch.path() / "file", ""));
    CHECK_FALSE(PrivateFolder::create(scratch.path() / "file", ""));
    for (const auto mode : {fs::perms::group_write, fs::perms::others_write}) {
        fs::permissions(scratch.path() / "open", fs::perms::owner_all | mode);
        CHECK(refused(scratch.path() / "open", "others may write to this folder"));
    }
    fs::permissions(scratch.path() / "open", fs::perms::owner_all | fs::perms::group_read);
    CHECK(PrivateFolder::open(scratch.path() / "open", ""));
    CHECK(refused(find_foreign_folder(scratch), "this folder is another user's"));
}

TEST_CASE("private folder: a link, a pipe, a folder and another user's file are not read") {
    const ScratchFolder scratch;
    const PrivateFolder folder = folder_at(scratch.path() / "own");
    const fs::path at = scratch.path() / "own";
    scratch.write("elsewhere", "secret");
    fs::create_symlink(scratch.path() / "elsewhere", at / "link");
    const auto read = folder.read("link", kAnyLength);
    REQUIRE_FALSE(read);
    CHECK(read.error().message == "this is a link, where a file should be");
    REQUIRE(::mkfifo((at / "pipe").c_str(), 0600) == 0);
    CHECK_FALSE(folder.read("pipe", kAnyLength));
    fs::create_directory(at / "folder");
    CHECK_FALSE(folder.read("folder", kAnyLength));
    if (::geteuid() == 0) {
        REQUIRE(folder.replace("given", bytes_of("x")) == 0);
        REQUIRE(::chown((at / "given").c_str(), kAnother, static_cast<gid_t>(-1)) == 0);
        CHECK_FALSE(folder.read("given", kAnyLength));
    }
    CHECK(folder.list().empty());
    // What is written replaces the link and not what it leads to.
    REQUIRE(folder.replace("link", bytes_of("mine")) == 0);
    CHECK(**folder.read("link", kAnyLength) == bytes_of("mine"));
    CHECK(text_of(scratch.path() / "elsewhere") == "secret");
}

TEST_CASE("private folder: a link put in its place later leads nobody elsewhere") {
    const ScratchFolder scratch;
    const PrivateFolder folder = folder_at(scratch.path() / "own");
    folder_at(scratch.path() / "elsewhere");
    fs::rename(scratch.path() / "own", scratch.path() / "moved");
    fs::create_directory_symlink(scratch.path() / "elsewhere", scratch.path() / "own");
    REQUIRE(folder.replace("x", bytes_of("mine")) == 0);
    CHECK(text_of(scratch.path() / "moved" / "x") == "mine");
    CHECK_FALSE(fs::exists(scratch.path() / "elsewhere" / "x"));
}

TEST_CASE("private folder: a file that another program is writing is left alone") {
    const ScratchFolder scratch;
    const PrivateFolder folder = folder_at(scratch.path());
    const auto temporary = [](int n) {
        return "x." + std::to_string(::getpid()) + "." + std::to_string(n) + ".tmp";
    };
    scratch.write(temporary(0), "another's");
    REQUIRE(folder.replace("x", bytes_of("mine")) == 0);
    CHECK(text_of(scratch.path() / "x") == "mine");
    CHECK(text_of(scratch.path() / temporary(0)) == "another's");
    for (int n = 0; n < 64; ++n) {
        scratch.write(temporary(n), "another's");
    }
    CHECK(folder.replace("x", bytes_of("mine again")) == EEXIST);
    for (int n = 0; n < 64; ++n) {
        CHECK(text_of(scratch.path() / temporary(n)) == "another's");
    }
    CHECK(text_of(scratch.path() / "x") == "mine");
}

TEST_CASE("private folder: a file that may not become so long leaves all as it was") {
    const ScratchFolder scratch;
    const PrivateFolder folder = folder_at(scratch.path());
    REQUIRE(folder.replace("x", bytes_of("before")) == 0);
    CHECK(wait_for_program(start_program([&] {
        const rlimit limit{1000, 1000};
        return ::signal(SIGXFSZ, SIG_IGN) != SIG_ERR && ::setrlimit(RLIMIT_FSIZE, &limit) == 0 &&
               folder.replace("x", std::vector<std::byte>(5000)) == EFBIG &&
               folder.replace("y", std::vector<std::byte>(1000)) == 0;
    })));
    CHECK(**folder.read("x", kAnyLength) == bytes_of("before"));
    CHECK(folder.list().size() == 2);
}

TEST_CASE("private folder: whose unfinished file it is stands in its name") {
    CHECK(find_target_name("x.shape.12.0.tmp") == "x.shape");
    CHECK(find_target_name("x.1.2.tmp") == "x");
    for (const char* name : {"x.tmp", "x.1.tmp", "x.a.1.tmp", "x.1.a.tmp", "x.1.2", "x.1..tmp",
                             ".tmp", "", "1.2.tmp", "x.1.2.tmp.old"}) {
        CHECK(find_target_name(name).empty());
    }
}

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
