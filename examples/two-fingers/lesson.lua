-- Two fingers, one at each side of a block: they lift it, turn it in the air and put it on another one. Whoever has one hand
-- grips with its button instead.
--
-- The answer key is the simulated world: friction holds the block between the fingers, or it falls.

local game = require "game"
local story = require "story"
local wait, wait_until = story.wait, story.wait_until

local L = lesson { id = "two-fingers", title = "Two fingers", level = "A1", minutes = 4, hands = 2 }

local edge = 0.06             -- of the wooden block, metres
local half = edge / 2
local lifted = 0.05           -- so high above where it lay it is lifted
local turned = 25             -- degrees
local wood, rock
local right_hand, left_hand

function L:start(world)
  world:ground(0)
  world:camera { eye = { 0, 0.3, 0.75 }, target = { 0, 0.1, 0 }, angle = 40 }
  right_hand = world:hand { centre = { 0.1, 0.12, 0 }, cursor = "ball", cursor_size = 0.008 }
  left_hand = world:hand { centre = { -0.1, 0.12, 0 }, cursor = "ball", cursor_size = 0.008 }
  wood = world:body {
    name = "wood", noun = "wooden block", model = "box", size = { edge, edge, edge }, rigid = true, mass = 0.1,
    material = "wood", at = { 0, half, 0 },
  }
  rock = world:body {
    name = "rock", noun = "stone block", model = "box", size = { 0.09, edge, 0.09 }, rigid = true, mass = 0.4,
    material = "rock", at = { 0.17, half, 0 },
  }
  game.play(L, world, function() play(world) end)
end

local function is_on(a, b)
  return math.abs(a.y - b.y - edge) < 0.004 and math.abs(a.x - b.x) < 0.05 and math.abs(a.z - b.z) < 0.05
end

L:question "where" {
  prompt = "Where is the wooden block now?",
  again = "Look at both blocks.",
  answers = { "[(it|the wooden block) is] {place} the stone block" },
  nearly = { "[(it|the wooden block) is] {place} stone block" },
  lists = { place = { "on top of|on", "under|below", "beside|next to" } },
  right = function(a) return (a.place == "on top of") == is_on(wood, rock) and a.place ~= "under" end,
}

-- ---- the game -----------------------------------------------------------------------------------------------------------

-- What fell or rolled away lies where it was.
local function put_back(done)
  return function()
    if wood.resting and (math.abs(wood.x) > 0.3 or math.abs(wood.z) > 0.15) then
      wood:place { at = { 0, half, 0 } }
    end
    return done()
  end
end

local function lift(world, two)
  world:caption(two and "Put one finger at each side of the wooden block. Press and lift it."
                or "Touch the wooden block, hold the button and lift it.")
  wait_until(put_back(function() return wood.y > half + lifted end))
  world:sound "pop"
  game.point()
end

-- One finger up, the other one down.
local function turn(world)
  world:caption "Turn it in the air: one finger up, one finger down."
  wait_until(put_back(function() return wood.tilt > turned and wood.y > half + lifted / 2 end))
  world:sound "pop"
  game.point()
end

local function stack(world)
  world:caption "Put the wooden block on top of the stone block."
  local done = wait_until(put_back(function()
    return is_on(wood, rock) and wood.where ~= "held" and wood.resting
  end), 120)
  if done then game.point() else game.miss() end
  world:caption ""
end

function play(world)
  wait(0.5)
  local two = left_hand.there
  world:level(1, two and "Press from both sides" or "Grip it")
  lift(world, two)
  if two then turn(world) end
  stack(world)
  game.ask("where", { hint = "Is it higher or lower than the stone block?",
                      solution = "It is on top of the stone block." })
end

L:test {
  hand = "right.lua", second_hand = "left.lua",
  say = { "it is on top of the stone block" },
  expect = { finished = true, stars = 3 },
}

return L
