#include "runtime/text/json.h"

#include <catch2/catch.hpp>

#include <limits>

using fulcrum::runtime::Json;

TEST_CASE("json: members keep their order, whatever their kinds") {
    Json json = Json::object({{"z", 1}, {"a", 2.5}, {"word", "x\"y"}, {"yes", true}});
    json.add("list", Json::array({1, std::string("two"), Json()}));
    CHECK(json.to_text() ==
          "{\n  \"z\": 1,\n  \"a\": 2.5,\n  \"word\": \"x\\\"y\",\n  \"yes\": true,\n"
          "  \"list\": [\n    1,\n    \"two\",\n    null\n  ]\n}\n");
}

TEST_CASE("json: what is empty is told as what it is") {
    CHECK(Json::object().to_text() == "{}\n");
    CHECK(Json::array().to_text() == "[]\n");
    CHECK(Json().to_text() == "null\n");
}

TEST_CASE("json: a number that is none is null, and what is no UTF-8 is replaced") {
    CHECK(Json(std::numeric_limits<double>::quiet_NaN()).to_text() == "null\n");
    CHECK(Json(std::numeric_limits<double>::infinity()).to_text() == "null\n");
    CHECK(Json("a\xff").to_text() == "\"a\xEF\xBF\xBD\"\n");
}

TEST_CASE("json: an item of a list can be added to") {
    Json list = Json::array({Json::object()});
    list.at(0).add("n", 3);
    list.push_back(4);
    CHECK(list.to_text() == "[\n  {\n    \"n\": 3\n  },\n  4\n]\n");
}
