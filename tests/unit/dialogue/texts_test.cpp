#include "dialogue/catalogue.h"
#include "dialogue/conversation/conversation.h"
#include "dialogue/marked_text.h"
#include "dialogue/result.h"
#include "tests/support/english_words.h"
#include "tests/unit/dialogue/rig.h"

#include <rapidcheck.h>

using namespace fulcrum::dialogue;

namespace {

Catalogue parsed(std::string_view text) {
    auto catalogue = Catalogue::parse(text);
    REQUIRE(catalogue);
    return std::move(*catalogue);
}

}  // namespace

TEST_CASE("catalogue: fills slots, keeps the rest") {
    const Catalogue catalogue = parsed(
        "# words\n\n a.b = Yes. {sentence}  \r\nempty =\nlines = one\\ntwo\nstar = {x}{x} = {y}\n");
    CHECK(*catalogue.text("a.b", {{"sentence", "It {is} *big*."}}) == "Yes. It {is} *big*.");
    CHECK(catalogue.text("empty")->empty());
    CHECK(*catalogue.text("lines") == "one\ntwo");
    CHECK(*catalogue.text("star", {{"x", "1"}, {"y", "2"}, {"z", "unused"}}) == "11 = 2");
    CHECK(catalogue.keys() == std::vector<std::string>{"a.b", "empty", "lines", "star"});
}

TEST_CASE("catalogue: a missing key and an unknown slot are named") {
    const Catalogue catalogue = parsed("a = {who}");
    REQUIRE_FALSE(catalogue.text("b"));
    CHECK(catalogue.text("b").error().message == "the catalogue has no key \"b\"; add it");
    REQUIRE_FALSE(catalogue.text("a"));
    CHECK_THAT(catalogue.text("a").error().message, Catch::Contains("\"a\" asks for {who}"));
    CHECK(catalogue.say("b") == "[b]");
    CHECK(catalogue.say("a") == "[a]");
}

TEST_CASE("catalogue: mistakes have line and column") {
    const struct {
        const char* text;
        int line, column;
    } rows[] = {
        {"a = 1\nno sign\n", 2, 1},    {"A = 1", 1, 1},      {" = 1", 1, 1},     {"a b = 1", 1, 1},
        {"a = 1\nb = 2\na = 3", 3, 1}, {"a = x {who", 1, 7}, {"a = x} y", 1, 6}, {"a = {}", 1, 5},
        {"a = {A b}", 1, 5},           {"a = {a{b}}", 1, 5}};
    for (const auto& row : rows) {
        INFO(row.text);
        const auto catalogue = Catalogue::parse(row.text);
        REQUIRE_FALSE(catalogue);
        CHECK(catalogue.error().line == row.line);
        CHECK(catalogue.error().column == row.column);
    }
    CHECK_FALSE(Catalogue::parse(std::string((1 << 20) + 1, '#')));
}

TEST_CASE("catalogue: a series goes as far as its numbers do") {
    const Catalogue catalogue = parsed("p.1 = a\np.2 = b\np.4 = d\n");
    CHECK(catalogue.series("p") == std::vector<std::string>{"p.1", "p.2"});
    CHECK(catalogue.series("q").empty());
}

TEST_CASE("catalogue: what the program needs is checked at load") {
    const std::vector<CatalogueNeed> needs{{"a", {"x"}}, {"b", {}}};
    CHECK(parsed("a = {x}\nb = y").check(needs));
    CHECK(parsed("a = no slot\nb = y\nc = more").check(needs));
    CHECK_FALSE(parsed("a = {x}").check(needs));
    const auto unknown = parsed("a = {x} {z}\nb = y").check(needs);
    REQUIRE_FALSE(unknown);
    CHECK_THAT(unknown.error().message, Catch::Contains("{z}"));
}

TEST_CASE("catalogue: any bytes are parsed or refused") {
    CHECK(rc::check([](const std::string& text) {
        if (const auto catalogue = Catalogue::parse("k = " + text)) {
            (void)catalogue->say("k");
        }
        (void)Catalogue::parse(text);
    }));
}

TEST_CASE("catalogue: the English words hold all that a conversation needs and speak to children") {
    const Catalogue catalogue = english_words();
    CHECK(catalogue.check(conversation_needs()));
    CHECK(*catalogue.text("banner.stopped") == "The lesson stopped.");
    CHECK(*catalogue.text("hud.weight", {{"felt", "6.0"}, {"true", "5.9"}}) ==
          "felt 6.0 N, true 5.9 N");
    CHECK(*catalogue.text("feedback.wrong_meaning") == "Not yet. Try again.");
    // Feedback is read by children: short sentences.
    for (const std::string& key : catalogue.keys()) {
        if (key.rfind("feedback.", 0) != 0 && key.rfind("rule.", 0) != 0) {
            continue;
        }
        const std::string text = catalogue.say(key, {{"sentence", "S."},
                                                     {"gap", "S"},
                                                     {"frame", "S."},
                                                     {"choices", "a"},
                                                     {"rule", "R."},
                                                     {"base", "b"},
                                                     {"right", "r"},
                                                     {"said", "s"},
                                                     {"phrase", "p"}});
        for (const std::string& sentence : sentences_of(text)) {
            INFO(key << ": " << sentence);
            CHECK(sentence.size() <= 90);
        }
    }
}

TEST_CASE("marked text: asterisks part what is strong") {
    const MarkedText text = part_emphasis("A watermelon is *the heaviest*.");
    CHECK(text.plain == "A watermelon is the heaviest.");
    REQUIRE(text.strong.size() == 1);
    CHECK(text.plain.substr(text.strong[0].first, text.strong[0].second - text.strong[0].first) ==
          "the heaviest");
    CHECK(part_emphasis("*a* b *c*").strong ==
          std::vector<std::pair<std::size_t, std::size_t>>{{0, 1}, {4, 5}});
}

TEST_CASE("marked text: single and empty asterisks") {
    CHECK(part_emphasis("").plain.empty());
    CHECK(part_emphasis("2 * 3").plain == "2 * 3");
    CHECK(part_emphasis("2 * 3").strong.empty());
    CHECK(part_emphasis("a ** b").plain == "a  b");
    CHECK(part_emphasis("a ** b").strong.empty());
    CHECK(part_emphasis("*a* *").plain == "a *");
}

TEST_CASE("marked text: ranges lie in order inside any text") {
    CHECK(rc::check([](const std::string& any) {
        const MarkedText text = part_emphasis(any);
        std::size_t last = 0;
        for (const auto& [begin, end] : text.strong) {
            RC_ASSERT(last <= begin);
            RC_ASSERT(begin < end);
            RC_ASSERT(end <= text.plain.size());
            last = end;
        }
    }));
}

TEST_CASE("dialogue result: a failure carries its message and place") {
    const Expected<int> failed = fail("the list is empty; give it a word", 7, 3);
    REQUIRE_FALSE(failed);
    CHECK(failed.error().message == "the list is empty; give it a word");
    CHECK(failed.error().column == 7);
    CHECK(failed.error().line == 3);
    CHECK(concat({"a", "", "bc"}) == "abc");
    CHECK(concat({}).empty());
}
