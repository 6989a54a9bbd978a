#include "dialogue/marking/meanings.h"

#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum::dialogue;

namespace {

Meanings of(const std::vector<std::string>& answers, const NamedLists& lists,
            std::size_t most = 100) {
    return meanings_of(compiled({"q", "Which one?", answers, lists}), most);
}

bool has(const Meanings& meanings, const std::string& said) {
    return std::ranges::any_of(meanings.some,
                               [&](const Meaning& meaning) { return meaning.said == said; });
}

const NamedLists kTwo{{"thing", {"egg", "rock"}}, {"kind", {"big", "small", "red"}}};

}  // namespace

TEST_CASE("meanings: each word of each list, with and without what may be left out") {
    const Meanings all = of({"the {thing} is [very] {kind}"}, kTwo);
    CHECK(all.all);
    CHECK(all.some.size() == 6);
    CHECK(has(all, "The rock is red."));
    const Meanings may = of({"the {thing} is here [and {kind}]"}, kTwo);
    CHECK(may.all);
    CHECK(may.some.size() == 8);
    CHECK(has(may, "The rock is here."));
    CHECK(has(may, "The rock is here and red."));
}

TEST_CASE(
    "meanings: what two answers both mean comes once, and an answer without slots means one") {
    CHECK(
        of({"the {thing} is big", "it is the {thing}"}, {{"thing", {"egg", "rock"}}}).some.size() ==
        2);
    const Meanings plain = of({"it is big"}, {});
    REQUIRE(plain.some.size() == 1);
    CHECK(plain.some[0].slots.empty());
    CHECK(plain.some[0].said == "It is big.");
    CHECK(plain.all);
}

TEST_CASE("meanings: where there are too many each word comes at least") {
    NamedLists many{{"one", {}}, {"two", {}}};
    for (int i = 0; i < 40; ++i) {
        many[0].second.push_back("a" + std::string(1, static_cast<char>('a' + i % 26)) +
                                 std::to_string(i));
        many[1].second.push_back("b" + std::to_string(i));
    }
    const Meanings some = of({"{one} and {two}"}, many, 10);
    CHECK_FALSE(some.all);
    CHECK(some.some.size() == 79);
}
