#include "runtime/lua/api/reference_sections.h"
#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace fulcrum::runtime {
namespace {

using test::HostedLesson;

constexpr const char* kShowAll = R"(
function L:start(world)
  world:body { name = "egg" }
  L:listen(function(e)
    if e.name == "update" then return end
    local names = {}
    for name in pairs(e) do names[#names + 1] = name end
    table.sort(names)
    local out = {}
    for _, name in ipairs(names) do out[#out + 1] = name .. "=" .. tostring(e[name]) end
    print(table.concat(out, " "))
  end)
end
L:question "q" { prompt = "?", answers = { "a" }, right = function(a) for k, v in pairs(a) do print(k, v) end return false end })";

TEST_CASE("events: each has its name and what belongs to it, and nothing else") {
    HostedLesson lesson;
    REQUIRE(lesson.load(kShowAll) == "");
    REQUIRE(
        lesson.play(lesson.frame(
            {BodyEvent{BodyEvent::Kind::caught, 0, 1.5}, BodyEvent{BodyEvent::Kind::landed, 0, 2.5},
             BodyEvent{BodyEvent::Kind::touched, 0, 0.0},
             BodyEvent{BodyEvent::Kind::released, 0, 0.0}, KeyEvent{"left"},
             AnsweredEvent{
                 "q", "an egg", {{"thing", "egg"}}, true, false, true, false, 3, true}})) == "");
    CHECK(lesson.prints ==
          "body=egg name=caught speed=1.5;body=egg name=landed speed=2.5;body=egg name=touched "
          "speed=0.0;"
          "body=egg name=released speed=0.0;key=left name=key;"
          "attempt=3 bodies=table form_known=true form_right=true name=answered over=false "
          "question=q replay=false "
          "right=false "
          "said=an egg "
          "thing=egg turned_round=true understood=true;");
}

TEST_CASE("events: a slot can't hide what the program says of an answer") {
    HostedLesson lesson;
    REQUIRE(lesson.load(kShowAll) == "");
    REQUIRE(lesson.play(lesson.frame({AnsweredEvent{
                "q", "x", {{"right", "yes"}, {"said", "y"}}, true, false, false, true, 1}})) == "");
    CHECK_THAT(lesson.prints, Catch::Contains("right=false said=x"));
}

TEST_CASE("events: the answer key sees the slots and its truth is the verdict") {
    HostedLesson lesson;
    REQUIRE(lesson.load(kShowAll) == "");
    REQUIRE(lesson.play(lesson.frame({JudgeEvent{"q", {{"thing", "egg"}}}})) == "");
    CHECK_THAT(lesson.prints, Catch::Contains("thing\tegg;"));
    REQUIRE(lesson.commands<VerdictCommand>().size() == 1);
    CHECK_FALSE(lesson.commands<VerdictCommand>()[0].right);
    CHECK(lesson.commands<VerdictCommand>()[0].question == "q");
}

TEST_CASE(
    "events: a slot that no sentence of the question has is a mistake, one that was left out is "
    "nil") {
    const std::string question =
        "L:question 'q' { prompt = '?', answers = { '[the] {thing} is {size:how}', 'it is {size} "
        "[<where>]' }, rules = { where = 'on the {place}' },\n"
        "lists = { size = { 'big' }, place = { 'table' } }, right = function(a) return ";
    const std::string start = "function L:start(world) world:body { name = 'egg' } end\n";
    const JudgeEvent judged{"q", {{"thing", "egg"}, {"how", "big"}}};
    const auto play = [&](const char* right) {
        HostedLesson lesson;
        REQUIRE(lesson.load((start + question + right + " end }").c_str()) == "");
        return lesson.play(lesson.frame({judged}));
    };
    CHECK(play("a.thing == 'egg' and a.how == 'big' and a.size == nil and a.place == nil") == "");
    CHECK_THAT(play("a.thnig == 'egg'"),
               Catch::Contains("lesson.lua:4: no sentence of the question \"q\" has {thnig}; did "
                               "you mean answer.thing?"));
    CHECK_THAT(play("a.colour"), Catch::Contains("has {colour}; is it spelt right?"));
    CHECK_THAT(play("a.attempt < 2"),
               Catch::Contains("answer.attempt is known when `right` has judged"));
    CHECK(play("getmetatable(a)") == "");
}

TEST_CASE("events: the reference names exactly the fields that each event has") {
    HostedLesson lesson;
    REQUIRE(lesson.load("function L:start(world) world:body { name = 'egg' } L:listen(function(e) "
                        "local t = {} for k in pairs(e) do t[#t + 1] = k end table.sort(t) print("
                        "e.name .. ':' .. table.concat(t, ' ')) end) end") == "");
    REQUIRE(lesson.play(lesson.frame({BodyEvent{BodyEvent::Kind::caught, 0, 1.5},
                                      BodyEvent{BodyEvent::Kind::landed, 0, 2.5},
                                      BodyEvent{BodyEvent::Kind::touched, 0, 0.0},
                                      BodyEvent{BodyEvent::Kind::released, 0, 0.0},
                                      KeyEvent{"left"}, AnsweredEvent{"q", "x", {}}})) == "");
    std::string expected;
    for (const EventText& event : event_texts()) {
        std::vector<std::string> fields{"name"};
        fields.insert(fields.end(), event.fields.begin(), event.fields.end());
        std::sort(fields.begin(), fields.end());
        expected += std::string(event.name) + ':';
        for (std::size_t i = 0; i < fields.size(); ++i) {
            expected += (i == 0 ? "" : " ") + fields[i];
        }
        expected += ';';
    }
    CHECK(lesson.prints == expected);
}

}  // namespace
}  // namespace fulcrum::runtime
