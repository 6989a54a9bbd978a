#include "runtime/lua/api/nouns.h"

#include "tests/unit/runtime/lua/hosted_lesson.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

constexpr const char* kBalls = R"(
local b1
function L:start(world)
  b1 = world:body { name = "b1", noun = "tennis ball" }
  world:body { name = "b2", noun = "football" }
  world:body { name = "s1", noun = "stone" }
  world:body { name = "s2", noun = "stone" }
end
)";

}  // namespace

TEST_CASE("nouns: a noun means a body only when one has it") {
    LessonDescription lesson;
    for (const char* noun : {"apple", "tennis ball", "the Moon", "apple"}) {
        lesson.bodies.emplace_back();
        lesson.bodies.back().noun = noun;
    }
    CHECK(body_with_noun(lesson, "tennis ball") == 1);
    CHECK(body_with_noun(lesson, "Moon") == 2);
    CHECK(body_with_noun(lesson, "apple") == kNoBody);
    CHECK(count_noun(lesson, "apple") == 2);
    CHECK(body_with_noun(lesson, "egg") == kNoBody);
}

TEST_CASE("nouns: an answer knows the bodies that its slots speak of") {
    HostedLesson lesson;
    REQUIRE(lesson.load(std::string(kBalls) + R"(
L:question "q" { prompt = "?", answers = { "a" }, right = function(a) return a.bodies.thing == b1 end }
function L:answered(a) print(a.thing, a.bodies.thing == b1, a.bodies.other, a.bodies.size) end)") ==
            "");
    REQUIRE(lesson.play(lesson.frame(
                {JudgeEvent{"q", {{"thing", "tennis ball"}}},
                 AnsweredEvent{
                     "q", "", {{"thing", "tennis ball"}, {"other", "stone"}, {"size", "big"}}}})) ==
            "");
    REQUIRE(lesson.commands<VerdictCommand>().size() == 1);
    CHECK(lesson.commands<VerdictCommand>()[0].right);
    CHECK(lesson.prints == "tennis ball\ttrue\tnil\tnil;");
}

TEST_CASE("nouns: world:find takes a name, or a noun that one body has") {
    HostedLesson lesson;
    REQUIRE(lesson.load(std::string(kBalls) +
                        "function L:update(world) print(world:find('tennis ball') == b1, "
                        "world:find('b1') == b1) world:find('stone') end") == "");
    CHECK(lesson.play() ==
          "lesson.lua:10: several bodies have the noun \"stone\"; find one by its name.");
    CHECK(lesson.reply.commands.empty());
    REQUIRE(lesson.load(std::string(kBalls) +
                        "function L:update(world) world:find('fotball') end") == "");
    CHECK(lesson.play() ==
          "lesson.lua:10: there is no body \"fotball\"; did you mean \"football\"?");
}
