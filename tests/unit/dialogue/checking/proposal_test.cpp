#include "dialogue/checking/proposal.h"

#include "tests/unit/dialogue/checking/checked.h"

using namespace fulcrum::dialogue;

TEST_CASE("proposal: capitals and blanks go with the words") {
    static const Lexicon lexicon = opened_lexicon();
    const auto sentences = read_sentences(lexicon, "These rock's it there's.");
    Proposals proposals(sentences.front());
    proposals.replace(0, ErrorCode::wrong_determiner, "this");
    proposals.replace(1, ErrorCode::extra_determiner, "");
    proposals.insert(1, ErrorCode::missing_determiner, "the");
    const auto list = proposals.take();
    REQUIRE(list.size() == 3);
    CHECK(list[0].right == "This");
    CHECK(list[0].begin == 0);
    CHECK(list[0].end == 5);
    CHECK(list[1].right.empty());
    CHECK(list[2].right == "the ");
    CHECK(list[2].begin == list[2].end);
}
