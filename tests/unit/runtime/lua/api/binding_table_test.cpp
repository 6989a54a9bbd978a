#include "runtime/lua/api/binding_table.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

TEST_CASE("bindings: the nearest word is found, and nothing when none is near") {
    const std::vector<std::string> words = {"gravity", "ground", "caption", "body"};
    CHECK(nearest_word("gravty", words) == "gravity");
    CHECK(nearest_word("garvity", words) == "gravity");
    CHECK(nearest_word("grond", words) == "ground");
    CHECK(nearest_word("bdoy", words) == "body");
    CHECK(nearest_word("elephant", words).empty());
    CHECK(nearest_word("tork", {"turn", "tool", "torque"}) == "torque");
    CHECK(nearest_word("fizics", {"physics", "music"}) == "physics");
    CHECK(nearest_word("", words).empty());
    CHECK(nearest_word(std::string(100000, 'x'), words).empty());
}

TEST_CASE("bindings: choices stand between spaces") {
    using Names = std::vector<std::string>;
    const auto choices = [](const char* text) {
        return choices_of({"law", ParameterType::choice, "", 0, 0, "nil", "", text});
    };
    CHECK(choices("point ball box") == Names{"point", "ball", "box"});
    CHECK(choices("one") == Names{"one"});
    CHECK(choices("  a  b ") == Names{"a", "b"});
    CHECK(choices("").empty());
}

TEST_CASE("bindings: ranges as people say them") {
    CHECK(range_text({"mass", ParameterType::number, "kilograms", 0, 10000}) ==
          "in kilograms, 0 to 10000");
    CHECK(range_text({"stars", ParameterType::integer, "", 0, 3}) == "0 to 3");
    CHECK(range_text({"text", ParameterType::text, "", 0, 1000}) == "of at most 1000 letters");
    CHECK(range_text({"solid", ParameterType::flag, "", 0, 0}).empty());
}

}  // namespace
}  // namespace fulcrum::runtime
