#include "runtime/arms/haply/message_log.h"

#include "tests/support/refused.h"
#include "tests/support/scratch_folder.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/stat.h>

namespace fulcrum::runtime {
namespace {

std::string read_log(const std::string& path) {
    std::ifstream file(path);
    std::ostringstream all;
    all << file.rdbuf();
    return all.str();
}

}  // namespace

TEST_CASE("message log: one message a line, with time and way") {
    const ScratchFolder folder;
    const std::string path = folder.file("haply.log");
    {
        auto log = MessageLog::open(path);
        REQUIRE(log);
        log->write('<', "{\"a\":\n1}");
        log->write('>', "{}");
    }
    std::istringstream lines(read_log(path));
    std::string first;
    std::string second;
    std::getline(lines, first);
    std::getline(lines, second);
    CHECK(first.ends_with(" < {\"a\": 1}"));
    CHECK(second.ends_with(" > {}"));
    CHECK(std::stod(second) >= std::stod(first));
}

TEST_CASE(
    "message log: it ends with a whole line where it is full, and without a file is nothing") {
    const ScratchFolder folder;
    const std::string path = folder.file("small.log");
    {
        auto log = MessageLog::open(path, 100);
        REQUIRE(log);
        for (int i = 0; i < 50; ++i) {
            log->write('<', "0123456789");
        }
    }
    const std::string kept = read_log(path);
    CHECK(kept.size() <= 100);
    CHECK(kept.size() > 50);
    CHECK(kept.ends_with("0123456789\n"));
    MessageLog none;
    none.write('<', "nobody keeps this");
    CHECK(is_refused(MessageLog::open(folder.file("no/such.log")), "cannot be kept there"));
    // A pipe that nobody empties would hold up the thread that gives the force.
    REQUIRE(::mkfifo(folder.file("pipe").c_str(), 0600) == 0);
    CHECK_FALSE(MessageLog::open(folder.file("pipe")));
    std::filesystem::create_symlink(path, folder.file("link.log"));
    CHECK(is_refused(MessageLog::open(folder.file("link.log")), "cannot be kept there"));
}

}  // namespace fulcrum::runtime
