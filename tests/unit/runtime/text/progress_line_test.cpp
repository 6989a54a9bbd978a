#include "runtime/text/progress_line.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <sys/ioctl.h>
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
    void make_wide(unsigned short columns) const {
        winsize size{};
        size.ws_col = columns;
        REQUIRE(::ioctl(master_, TIOCSWINSZ, &size) == 0);
    }
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

TEST_CASE("progress line: it is shorter than the terminal is wide, in whole characters") {
    const Terminal terminal;
    ProgressLine line("Building", {.after_s = 0.0, .between_s = 0.0, .stream = terminal.stream()});
    const std::string wide(200, 'x');
    line.say(0.42, wide);
    CHECK(terminal.read() == kEmptied + "Building  42 % " + std::string(50, 'x'));
    terminal.make_wide(24);
    line.say(0.42, wide);
    CHECK(terminal.read() == kEmptied + "Building  42 % " + std::string(8, 'x'));
    // A place of 24 columns holds eight letters of one column behind the number, four of two.
    line.say(0.42, "\u00FC\u00FC\u00FC\u00FC\u00FC\u00FC\u00FC\u00FC\u00FC");
    CHECK(terminal.read() ==
          kEmptied + "Building  42 % \u00FC\u00FC\u00FC\u00FC\u00FC\u00FC\u00FC\u00FC");
    line.say(0.42, "\uC9C0\uB81B\uB300\uC9C0\uB81B");
    CHECK(terminal.read() == kEmptied + "Building  42 % \uC9C0\uB81B\uB300\uC9C0");
    terminal.make_wide(6);
    line.say(0.42, "a\nb");
    CHECK(terminal.read() == kEmptied + "Build");
    terminal.make_wide(40);
    line.say(0.42, "a\n\033[2Jb");
    CHECK(terminal.read() == kEmptied + "Building  42 % a [2Jb");
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
