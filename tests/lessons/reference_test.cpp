// What the reference shows runs as it stands there.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

/// The first Lua example under a heading of the reference.
std::string example_under(const std::string& heading) {
    const std::string text = bytes_of(FULCRUM_TEST_LESSONS "/../../scripts/meta/reference.md");
    const std::size_t section = text.find("\n## " + heading + '\n');
    const std::size_t begin = text.find("```lua\n", section) + 7;
    REQUIRE(section != std::string::npos);
    return text.substr(begin, text.find("```\n", begin) - begin);
}

constexpr const char* kHead = R"(local story = require "story"
local L = lesson { id = "x", title = "X" }
function L:start(world)
  world:body { name = "b1", noun = "apple", model = "apple", mass = 0.2, movable = true }
  world:body { name = "b2", noun = "egg", model = "egg", mass = 0.06, movable = true }
  story(L, function()
    local points = 0
    for _, question in ipairs { "heavier", "heavier", "count", "count" } do
      local answer
      repeat answer = story.ask(world, question) until answer.over or answer.understood
      if answer.right then points = points * 10 + answer.attempt end
    end
    world:score(points)
    world:finish { stars = 3 }
  end)
end
)";

}  // namespace

TEST_CASE("reference: its templates are understood and judged as they stand there") {
    const Sandbox sandbox;
    sandbox.write("x/lesson.lua",
                  kHead + example_under("Templates of answers") +
                      "L:test { say = { 'the egg is heavier than the apple', 'an apple is heavier "
                      "than the egg', '3 eggs', 'there are two eggs' }, expect = { score = 22, "
                      "finished = true, stars = 3 } }\nreturn L\n");
    check_run(sandbox.run("test x"), 0);
}
