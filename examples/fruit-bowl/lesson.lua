-- A banana in the hand goes into a bowl, once round inside, and out again: two meshes with hollows, which touch in several places at once.
--
-- `contact = "levels"` finds these places among the triangles themselves, by levels of detail; "fields" by points of the banana in a distance
-- field of the bowl. `./fulcrum explain examples/fruit-bowl --analyze` tells what each costs here.

local game = require "game"
local story = require "story"
local wait_until = story.wait_until

local contact = "levels"

local L = lesson { id = "fruit-bowl", title = "A banana in a bowl", level = "A1", minutes = 4 }

local rim = 0.3                -- how high the bowl's rim is, metres

function L:start(world)
  world:camera { eye = { 0, 0.72, 0.62 }, target = { 0, 0.28, 0 }, angle = 38 }
  hand = world:hand {
    centre = { 0, 0.36, 0 },
    tool = { model = "banana", mass = 0.05, method = "implicit_penalty", contact = contact },
  }
  world:body { name = "table", model = "box", size = { 0.6, 0.04, 0.4 }, solid = true, visible = true, at = { 0, rim - 0.114, 0 } }
  world:body { name = "bowl", model = "bowl", solid = true, visible = true, at = { 0, rim, 0 }, about = "This is the bowl." }
  game.play(L, world, function() play(world) end)
end

-- Until the banana has been on all four sides of the bowl, as seen from its middle, and touched it there.
local function stir()
  local sides, n = {}, 0
  wait_until(function()
    local tool = hand.tool
    if tool.y < rim + 0.05 and tool.force > 0.2 then
      local side = (tool.x > 0 and 1 or 0) + (tool.z > 0 and 2 or 0)
      if not sides[side] then
        sides[side] = true
        n = n + 1
      end
    end
    return n == 4
  end)
end

L:question "with" {
  prompt = "What is in your hand?",
  answers = { "[it is|there is] a banana [in my hand]" },
  nearly = { "[it is|there is] banana [in my hand]" },
  right = function() return true end,
}

function play(world)
  world:level(1, "Into the bowl")
  world:caption "Put the banana into the bowl."
  wait_until(function() return hand.tool.y < rim + 0.04 and hand.tool.force > 0.2 end)
  world:sound "pop"
  game.point()
  world:level(2, "Round the bowl")
  world:caption "Go round in the bowl, along its side."
  stir()
  world:sound "pop"
  game.point()
  world:caption "Take the banana out."
  wait_until(function() return hand.tool.y > rim + 0.12 end)
  world:caption ""
  game.ask("with", { hint = "It is a fruit, and it is yellow.", solution = "It is a banana." })
end

L:test {
  hand = "stirrer.lua",
  say = { "a banana" },
  expect = { finished = true, stars = 3 },
}

return L
