#include "runtime/files/progress_line.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <thread>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

// Both ends of a terminal that nobody sees.
class Terminal {
  public:
    Terminal() : master_(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK)) {
        REQUIRE(master_ >= 0);
        REQUIRE(::grantpt(master_) == 0);
        REQUIRE(::unlockpt(master_) == 0);
        stream_ = std::fopen(::ptsname(master_), "w");
        REQUIRE(stream_ != nullptr);
    }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;
    ~Terminal() {
        std::fclose(stream_);
        ::close(master_);
    }
    [[nodiscard]] std::FILE* stream() const { return stream_; }
    // What has been shown since.
    [[nodiscard]] std::string read() const {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        std::string text(4096, '\0');
        const ssize_t n = ::read(master_, text.data(), text.size());
        text.resize(n < 0 ? 0 : static_cast<std::size_t>(n));
        return text;
    }

  private:
    int master_;
    std::FILE* stream_ = nullptr;
};

const std::string kEmptied = "\r\033[K";

TEST_CASE("progress line: what lasts is shown in one line, and goes in the end") {
    const Terminal terminal;
    {
        ProgressLine line("Building",
                          {.after_s = 0.0, .between_s = 0.0, .stream = terminal.stream()});
        CHECK(line.is_on_terminal());
        line.say(0.42, "the map");
        CHECK(terminal.read() == kEmptied + "Building  42 % the map");
        line.say(7.0, std::string(200, 'x'));
        CHECK(terminal.read() == kEmptied + "Building 100 % " + std::string(50, 'x'));
    }
    CHECK(terminal.read() == kEmptied);
    {
        ProgressLine line("Building",
                          {.after_s = 0.0, .between_s = 3600.0, .stream = terminal.stream()});
        line.say(0.1);
        line.say(0.2);
        CHECK(terminal.read() == kEmptied + "Building  10 % ");
    }
    CHECK(terminal.read() == kEmptied);
}

TEST_CASE("progress line: what is over soon is not shown, nor what goes to no terminal") {
    const Terminal terminal;
    {
        ProgressLine line("Building", {.after_s = 3600.0, .stream = terminal.stream()});
        line.say(0.5);
    }
    CHECK(terminal.read().empty());
    std::FILE* const file = std::tmpfile();
    REQUIRE(file != nullptr);
    {
        ProgressLine line("Building", {.after_s = 0.0, .stream = file});
        CHECK_FALSE(line.is_on_terminal());
        line.say(0.5);
    }
    CHECK(std::ftell(file) == 0);
    std::fclose(file);
}

}  // namespace
}  // namespace fulcrum::runtime
