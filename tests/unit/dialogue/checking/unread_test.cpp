#include "dialogue/checking/unread.h"

#include <catch2/catch.hpp>

#include <optional>
#include <string>
#include <vector>

using namespace fulcrum::dialogue;

namespace {

// Finds no place for a word of what has "zig" in it, and keeps what it was asked.
class ZigJudge final : public SentenceJudge {
  public:
    std::optional<int> misfits(std::string_view sentence) override {
        asked.emplace_back(sentence);
        return sentence.find("zig") == std::string_view::npos ? 0 : 1;
    }
    std::vector<std::string> asked;
};

std::string unread(SentenceJudge& judge, std::string_view text) {
    const auto lexicon = Lexicon::open();
    REQUIRE(lexicon);
    return find_unread(judge, read_sentences(*lexicon, text), text);
}

}  // namespace

TEST_CASE("unread: the first clause that the judge has no place for, as it stands there") {
    ZigJudge judge;
    CHECK(unread(judge, "It is heavy. Lift it: it goes zig with you! Here it is zig too.") ==
          "it goes zig with you");
    CHECK(judge.asked ==
          std::vector<std::string>{"it goes zig with you.", "it goes zig with you."});
    CHECK(unread(judge, "It is heavy here.").empty());
    CHECK(unread(judge, "").empty());
}

TEST_CASE("unread: a title, a call and what has no verb are no clauses") {
    ZigJudge judge;
    CHECK(unread(judge, "Lift the zig! The long and narrow zig for the Earth. Which zig?").empty());
    CHECK(judge.asked.empty());
}
