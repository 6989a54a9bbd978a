#include "dialogue/conversation/recast.h"

#include <catch2/catch.hpp>

#include <string>

using namespace fulcrum::dialogue;

TEST_CASE("recast: how a right sentence is said back goes by how it begins and ends") {
    const auto key = [](const char* corrected) {
        Mark mark;
        mark.corrected = corrected;
        return std::string(recast_key(mark));
    };
    CHECK(key("The egg is heavier.") == "feedback.recast");
    CHECK(key("Yes, it is heavier.") == "feedback.recast_said");
    CHECK(key("No, it isn't.") == "feedback.recast_said");
    CHECK(key("No wind.") == "feedback.recast");
    CHECK(key("How heavy is it?") == "feedback.recast_question");
}
