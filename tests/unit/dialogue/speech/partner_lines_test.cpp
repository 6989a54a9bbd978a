#include "dialogue/speech/external/partner_lines.h"

#include "tests/unit/dialogue/rig.h"

using namespace fulcrum::dialogue;

namespace {

/// What is read of it, or what is wrong with it.
std::string read(const std::string& text_as_json) {
    const auto line = read_text_line("{\"turn\":3,\"text\":\"" + text_as_json + "\"}");
    return line ? line->text : line.error().message;
}

constexpr const char* kNoLine = "says a line that is no {\"turn\": …, \"text\": …}";

}  // namespace

TEST_CASE("partner's lines: a turn is told without the learner's name, a question as one") {
    TurnLine line{
        .turn = 3, .level = "A2", .prompt = "Which?", .said = "egg\n\"is\"", .kind = "recast"};
    line.attempt = 2;
    line.errors = {"R:SPELL"};
    line.corrected = "An egg.";
    line.ours = "Yes.";
    CHECK(write_line(line) ==
          R"({"attempt":2,"corrected":"An egg.","errors":["R:SPELL"],"kind":"recast","level":"A2",)"
          R"("ours":"Yes.","prompt":"Which?","said":"egg\n\"is\"","turn":3})");
    line.asks = "What is this?";
    CHECK(write_line(line) == R"({"asks":"What is this?","level":"A2","ours":"Yes.","turn":3})");
    line.asks = "\xff\n";
    CHECK(write_line(line).find('\n') == std::string::npos);
}

TEST_CASE("partner's lines: a text is read as it can be shown") {
    CHECK(read("Well done, *great*!") == "Well done, *great*!");
    CHECK(read("Très bien — “yes”… 5 €") == "Très bien — “yes”… 5 €");
    CHECK(read("a\\u001b[31m\\u0000b\\u202ec\\u200bd\\ne\\u0085") == "a[31mbcd e");
    const auto whole = read_text_line(R"({"text":"Yes.","turn":12,"right":false,"more":[1]})");
    REQUIRE(whole);
    CHECK(whole->turn == 12);
    CHECK(whole->text == "Yes.");
}

TEST_CASE("partner's lines: what is no line, too long or in other letters is refused in words") {
    for (const char* line : {"", "nonsense", "[3]", R"({"turn":3})", R"({"text":"a"})",
                             R"({"turn":"3","text":"a"})", R"({"turn":3,"text":4})",
                             "{\"turn\":3,\"text\":\"\xff\"}", R"({"turn":3,"text":"\ud800"})"}) {
        CAPTURE(line);
        const auto read_one = read_text_line(line);
        REQUIRE_FALSE(read_one);
        CHECK(read_one.error().message == kNoLine);
    }
    CHECK_FALSE(read_text_line("{\"turn\":3," + std::string(20'000, ' ') + "\"text\":\"a\"}"));
    const auto many = [](std::size_t n, const char* letter) {
        std::string text;
        for (std::size_t i = 0; i < n; ++i) {
            text += letter;
        }
        return text;
    };
    CHECK(read(many(kLongestPartnerText, "é")).size() == 2 * kLongestPartnerText);
    CHECK(read(many(kLongestPartnerText + 1, "a")) == "says more than 400 characters");
    CHECK(read("") == "says nothing in its text");
    CHECK(read("  \\n ") == "says nothing in its text");
    CHECK(read("Да") == "says what is not in the letters of English");
    CHECK(read("好") == "says what is not in the letters of English");
    CHECK(read("🎉") == "says what is not in the letters of English");
}
