#include "dialogue/template/resolve_articles.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace fulcrum::dialogue;

namespace {

Piece piece(Role role, const std::string& right, const std::string& said) {
    Piece made;
    made.element.role = role;
    made.right = right;
    made.said = said;
    return made;
}

}  // namespace

TEST_CASE("resolve articles: neighbours are pieces that belong in the sentence") {
    const std::vector<Piece> pieces = {piece(Role::determiner, "the", "the"),
                                       piece(Role::modifier, "", "a"),
                                       piece(Role::noun, "egg", "egg")};
    CHECK(before(pieces, 2) == 0);
    CHECK(before(pieces, 0) == kNone);
    CHECK(after(pieces, 0) == 2);
    CHECK(after(pieces, 2) == kNone);
    CHECK(after({}, kNone) == kNone);
}

TEST_CASE(
    "resolve articles: of two determiners the second goes, or the first before a noun's own") {
    std::vector<Piece> two = {piece(Role::determiner, "my", "my"),
                              piece(Role::determiner, "the", "the"),
                              piece(Role::noun, "egg", "egg")};
    part_determiners(two, 1);
    CHECK(two[0].right == "my");
    CHECK(two[1].right.empty());
    CHECK(two[1].code == ErrorCode::extra_determiner);
    CHECK(two[1].cost > 0);

    std::vector<Piece> number = {piece(Role::determiner, "the", "the"),
                                 piece(Role::noun, "a", "a")};
    number[1].element.slot = 0;
    part_determiners(number, 1);
    CHECK(number[0].right.empty());
    CHECK(number[1].right == "a");

    // What was not said is no error.
    std::vector<Piece> missing = {piece(Role::determiner, "the", "the"),
                                  piece(Role::determiner, "an", "")};
    missing[1].code = ErrorCode::missing_determiner;
    missing[1].cost = 10;
    part_determiners(missing, 1);
    CHECK(missing[1].code == ErrorCode::none);
    CHECK(missing[1].cost == 0);
}

TEST_CASE("resolve articles: a word that only looks like a determiner stays") {
    std::vector<Piece> that = {piece(Role::word, "that", "that"),
                               piece(Role::determiner, "the", "the")};
    part_determiners(that, 1);
    CHECK(that[1].right == "the");
    std::vector<Piece> pronoun = {piece(Role::noun, "this", "this"),
                                  piece(Role::determiner, "the", "the")};
    part_determiners(pronoun, 1);
    CHECK(pronoun[1].right == "the");
}
