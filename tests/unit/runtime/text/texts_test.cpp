#include "runtime/text/json.h"
#include "runtime/text/progress_line.h"
#include "runtime/text/terminal_text.h"
#include "runtime/text/utf8.h"
#include "tests/unit/runtime/rig.h"

#include <chrono>
#include <fcntl.h>
#include <random>
#include <sys/ioctl.h>
#include <thread>
#include <unistd.h>

using namespace fulcrum::runtime::test;

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

}  // namespace

TEST_CASE("json: members keep their order, whatever their kinds") {
    Json json = Json::object({{"z", 1}, {"a", 2.5}, {"word", "x\"y"}, {"yes", true}});
    json.add("list", Json::array({1, std::string("two"), Json()}));
    CHECK(json.to_text() ==
          "{\n  \"z\": 1,\n  \"a\": 2.5,\n  \"word\": \"x\\\"y\",\n  \"yes\": true,\n"
          "  \"list\": [\n    1,\n    \"two\",\n    null\n  ]\n}\n");
}

TEST_CASE("json: what is empty is told as what it is") {
    CHECK(Json::object().to_text() == "{}\n");
    CHECK(Json::array().to_text() == "[]\n");
    CHECK(Json().to_text() == "null\n");
}

TEST_CASE("json: a number that is none is null, and what is no UTF-8 is replaced") {
    CHECK(Json(std::numeric_limits<double>::quiet_NaN()).to_text() == "null\n");
    CHECK(Json(std::numeric_limits<double>::infinity()).to_text() == "null\n");
    CHECK(Json("a\xff").to_text() == "\"a\xEF\xBF\xBD\"\n");
}

TEST_CASE("json: an item of a list can be added to") {
    Json list = Json::array({Json::object()});
    list.at(0).add("n", 3);
    list.push_back(4);
    CHECK(list.to_text() == "[\n  {\n    \"n\": 3\n  },\n  4\n]\n");
}

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

TEST_CASE("terminal text: whole characters, as many as fit") {
    CHECK(fit_to_columns("a ball", 20) == "a ball");
    CHECK(fit_to_columns("a ball", 6) == "a ball");
    CHECK(fit_to_columns("a ball", 5) == "a bal");
    CHECK(fit_to_columns("a ball", 0).empty());
    CHECK(fit_to_columns("a ball", -3).empty());
    // Two bytes a letter, one column; an accent of its own takes none.
    CHECK(fit_to_columns("\u00FC\u00FC\u00FC", 2) == "\u00FC\u00FC");
    CHECK(fit_to_columns("u\u0308u\u0308", 1) == "u\u0308");
    // Two columns each: a half is not drawn.
    CHECK(fit_to_columns("\uC9C0\uB81B\uB300", 5) == "\uC9C0\uB81B");
    CHECK(fit_to_columns("\U0001F30D!", 2) == "\U0001F30D");
}

TEST_CASE("terminal text: nothing that a terminal obeys comes through") {
    CHECK(fit_to_columns("red\033[31m\r\nline\a", 40) == "red[31m line");
    CHECK(fit_to_columns("\xFFz", 40) == "\uFFFDz");
}

TEST_CASE("utf8: well-formed text comes through") {
    CHECK(decode_for_display("apple") == U"apple");
    CHECK(decode_for_display("caf\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x8D\x8E") ==
          U"caf\u00E9 \u20AC \U0001F34E");
    CHECK(decode_for_display("a\nb\tc") == U"a\nb c");
}

TEST_CASE("utf8: ill-formed bytes become one replacement each") {
    CHECK(decode_for_display("a\x80z") == U"a\uFFFDz");
    CHECK(decode_for_display("\xC3") == U"\uFFFD");
    CHECK(decode_for_display("\xC0\x80") == U"\uFFFD\uFFFD");            // overlong
    CHECK(decode_for_display("\xED\xA0\x80") == U"\uFFFD\uFFFD\uFFFD");  // surrogate
    CHECK(decode_for_display("\xF4\x90\x80\x80") == U"\uFFFD\uFFFD\uFFFD\uFFFD");
    CHECK(decode_for_display("\xE2\x82z") == U"\uFFFD\uFFFDz");
}

TEST_CASE("utf8: what draws nothing or turns text around is left out") {
    CHECK(decode_for_display(std::string("a\0b\x07\x1B[31m\x7F", 10)) == U"ab[31m");
    // But joiners work in the scripts that have them, and in no other.
    CHECK(decode_for_display("\u0628\u200C\u0628\u200D") == U"\u0628\u200C\u0628\u200D");
    CHECK(decode_for_display("a\u200Cb\u200D") == U"ab");
    CHECK(decode_for_display("x\xE2\x80\xAEy\xE2\x80\x8Bz\xEF\xBB\xBF") == U"xyz");
}

TEST_CASE("utf8: any bytes are decoded, and never into more than the limit") {
    std::mt19937 random(3);
    for (int i = 0; i < 300; ++i) {
        std::string bytes(random() % 300, '\0');
        for (char& byte : bytes) {
            byte = static_cast<char>(random());
        }
        CHECK(decode_for_display(bytes).size() <= bytes.size());
    }
    CHECK(decode_for_display(std::string(1'000'000, 'w')).size() == kMostCodePoints);
}
