// scripts/lib/maze.lua, run in a lesson as teachers use it.
#include "tests/unit/runtime/lua/lesson_folder.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

/// What the lines print while the lesson begins; the error's sentence when they raise one.
std::string printed(const std::string& lines) {
    return LessonFolder().begin("local maze = require 'maze'\nfunction L:start(world)\n" + lines +
                                "\nend");
}

// A graph without circles that joins n cells has n - 1 ways (a tree); ways go both ways.
const std::string kIsTree = R"(
local function check(garden)
  local n, ways = garden.columns * garden.rows, 0
  for cell = 1, n do
    for _, direction in ipairs(maze.ways(garden, cell)) do
      local back = { left = "right", right = "left", up = "down", down = "up" }
      local beyond = maze.beside(garden, cell, direction)
      assert(beyond and maze.leads(garden, beyond, back[direction]))
      ways = ways + 1
    end
  end
  assert(ways == 2 * (n - 1), "no tree")
  for cell = 1, n do
    local at = 1
    for _, direction in ipairs(maze.way(garden, 1, cell)) do
      assert(maze.leads(garden, at, direction), "through a wall")
      at = maze.beside(garden, at, direction)
    end
    assert(at == cell, "not reached")
  end
end
)";

}  // namespace

TEST_CASE("maze: whatever the seed, each cell is reached in one way, with dead ends enough") {
    CHECK(printed(kIsTree + R"(
for seed = 0, 11 do
  local garden = maze.make { columns = 7, rows = 5, seed = seed, dead_ends = 7 }
  check(garden)
  assert(#maze.dead_ends(garden) >= 7)
end
check(maze.make { columns = 2, rows = 2, seed = -5 })
check(maze.make { columns = 12, rows = 3, seed = math.maxinteger })
assert(#maze.way(maze.make { columns = 20, rows = 10, seed = 8 }, 1, 200) >= 28)
print "all")") == "all;");
}

TEST_CASE("maze: the same seed makes the same one, others make others") {
    CHECK(printed(R"(
local function drawn(seed)
  local garden, text = maze.make { columns = 6, rows = 4, seed = seed }, ""
  for cell = 1, 24 do text = text .. table.concat(maze.ways(garden, cell), ",") .. ";" end
  return text
end
assert(drawn(3) == drawn(3))
local seen, n = {}, 0
for seed = 1, 30 do
  if not seen[drawn(seed)] then n = n + 1 end
  seen[drawn(seed)] = true
end
print(n))") == "30;");
}

// Along a line through the middles of two cells beside each other there is a wall exactly where no way leads.
TEST_CASE("maze: its walls stand where no way leads, and gates are left open") {
    CHECK(printed(R"(
local size = { cell = 0.1, thick = 0.02, high = 0.05 }
local function covers(boxes, x, z)
  for _, box in ipairs(boxes) do
    if math.abs(x - box.at[1]) <= box.size[1] / 2 and math.abs(z - box.at[3]) <= box.size[3] / 2 then return true end
  end
  return false
end
local steps = { left = { -1, 0 }, right = { 1, 0 }, up = { 0, -1 }, down = { 0, 1 } }
for seed = 1, 5 do
  local garden = maze.make { columns = 7, rows = 5, seed = seed }
  local boxes = maze.walls(garden, size, { { cell = 1, direction = "left" }, { cell = 35, direction = "right" } })
  assert(#boxes <= 60)
  for cell = 1, 35 do
    local column, row = maze.place(garden, cell)
    for direction, step in pairs(steps) do
      local gate = cell == 1 and direction == "left" or cell == 35 and direction == "right"
      local x, z = (column - 4 + step[1] / 2) * 0.1, (row - 3 + step[2] / 2) * 0.1
      assert(covers(boxes, x, z) == (not gate and not maze.leads(garden, cell, direction)), cell .. direction)
      assert(not covers(boxes, (column - 4) * 0.1, (row - 3) * 0.1))
    end
  end
  for _, box in ipairs(boxes) do
    assert(box.at[2] == 0.025 and box.size[2] == 0.05)
    assert(math.abs(box.at[1]) + box.size[1] / 2 < 0.361 and math.abs(box.at[3]) + box.size[3] / 2 < 0.261)
  end
end
print "all")") == "all;");
}
