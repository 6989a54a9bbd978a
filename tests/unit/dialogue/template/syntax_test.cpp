#include "dialogue/template/syntax.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("syntax: hostile depth and length are refused") {
    CHECK(parse_template(std::string(24, '[') + "a" + std::string(24, ']')));
    CHECK_FALSE(parse_template(std::string(25, '[') + "a" + std::string(25, ']')));
    CHECK_FALSE(parse_template(std::string(4000, '(')));
    CHECK_FALSE(parse_template(std::string(5000, 'a')));
    CHECK_FALSE(parse_template(std::string(1 << 20, '[')));
}
