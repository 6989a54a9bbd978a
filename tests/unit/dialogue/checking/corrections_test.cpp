#include "dialogue/checking/corrections.h"

#include <catch2/catch.hpp>

#include <rapidcheck.h>
#include <string>
#include <vector>

using namespace fulcrum::dialogue;

namespace {

Proposal put(std::size_t begin, std::size_t end, const char* right,
             ErrorCode code = ErrorCode::agreement) {
    return {code, begin, end, right};
}

std::string mended(std::string_view text, const std::vector<Proposal>& proposals) {
    return carried_out(text, 0, text.size(), proposals);
}

}  // namespace

TEST_CASE("corrections: carried out in the text's order, with blanks outside the marks") {
    const std::vector<Proposal> two = {put(8, 8, "a "), put(3, 7, "has")};
    CHECK(mended("it have tail", two) == "it has a tail");
    CHECK(carried_out("it have tail", 0, 12, two, "*") == "it *has* *a* tail");
    CHECK(carried_out("it have tail", 3, 7, {two[1]}) == "has");
}

TEST_CASE("corrections: what is mended in the outcome is told of the text") {
    // "it needs tail" got its article behind the verb that was mended.
    const std::string text = "it need tail";
    const auto both = joined(text, {put(3, 7, "needs")}, {put(9, 9, "a ")});
    REQUIRE(both.size() == 2);
    CHECK(both[1].begin == 8);
    CHECK(both[1].end == 8);
    CHECK(mended(text, both) == "it needs a tail");
    // Before a place that was mended, and a verb in front of another correction.
    const auto in_front = joined("it more heavy", {put(3, 13, "heavier")}, {put(3, 3, "is ")});
    CHECK(mended("it more heavy", in_front) == "it is heavier");
    CHECK(in_front.size() == 2);
}

TEST_CASE("corrections: two at one place are one, of the first one's kind") {
    const std::string text = "it is push";
    const auto one = joined(text, {put(3, 6, "", ErrorCode::verb_form)},
                            {put(3, 7, "pushes", ErrorCode::agreement)});
    REQUIRE(one.size() == 1);
    CHECK(one[0].code == ErrorCode::verb_form);
    CHECK(one[0].begin == 3);
    CHECK(one[0].end == 10);
    CHECK(one[0].right == "pushes");
    // Two rules that undo each other say nothing.
    CHECK(joined("a b", {put(2, 3, "c")}, {put(2, 3, "b")}).empty());
}

TEST_CASE("corrections: joined, they make of the text what they made of it one after the other") {
    CHECK(rc::check([] {
        const auto text = *rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab ")));
        const auto any = [](std::string_view of) {
            std::vector<Proposal> list;
            std::size_t at = 0;
            while (at <= of.size() && list.size() < 4) {
                const std::size_t begin = at + *rc::gen::inRange<std::size_t>(0, 4);
                const std::size_t end = begin + *rc::gen::inRange<std::size_t>(0, 4);
                if (end > of.size()) {
                    break;
                }
                list.push_back(put(begin, end, *rc::gen::element("", "x", "yz ", "a")));
                at = end + 1;
            }
            return list;
        };
        const std::vector<Proposal> first = any(text);
        const std::string outcome = mended(text, first);
        const std::vector<Proposal> then = any(outcome);
        const std::vector<Proposal> both = joined(text, first, then);
        RC_ASSERT(mended(text, both) == mended(outcome, then));
        for (std::size_t i = 1; i < both.size(); ++i) {
            RC_ASSERT(both[i - 1].end <= both[i].begin);
        }
    }));
}
