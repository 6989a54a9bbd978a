-- Blocks that lie, fall and are stacked: heavier and lighter, taller, on top of, under and between.
--
-- The answer key is the simulated world: what is heavier follows from the masses, what lies on what from where the blocks are.

local game = require "game"
local know = require "know"
local story = require "story"
local wait, wait_until = story.wait, story.wait_until

local L = lesson { id = "stacks", title = "Blocks", level = "A1", minutes = 10 }

know.things(L)

local edge = 0.08             -- of the cubes, metres
local lifted = 0.04           -- so high above where it lay a block is lifted
local blocks = {
  { name = "wood", noun = "wooden block", material = "wood", mass = 0.1, size = { edge, edge, edge }, x = -0.2,
    about = "This block is made of wood, from a tree." },
  { name = "rock", noun = "stone block", material = "rock", mass = 0.2, size = { edge, 2 * edge, edge }, x = 0,
    about = "This block is made of rock. It is rough." },
  { name = "metal", noun = "metal block", material = "metal", mass = 0.35, size = { edge, edge, edge }, x = 0.2,
    about = "This block is made of metal. It is hard and smooth." },
}
local bodies = {}             -- by name and by noun
local height = {}             -- of each body, by name

function L:start(world)
  world:ground(0)
  world:camera { eye = { 0, 0.45, 1.1 }, target = { 0, 0.16, 0 }, angle = 40 }
  world:hand { centre = { 0, 0.22, 0 }, scale = 2, cursor = "ball", cursor_size = 0.008 }
  for _, block in ipairs(blocks) do
    local body = world:body {
      name = block.name, noun = block.noun, model = "box", size = block.size, rigid = true, mass = block.mass,
      material = block.material, about = block.about, at = { block.x, block.size[2] / 2, 0 },
    }
    bodies[block.name], bodies[block.noun] = body, body
    height[block.name] = block.size[2]
  end
  game.play(L, world, function() play(world) end)
end

-- ---- physics is the answer key ----------------------------------------------------------------------------------------

local function is_heavier(a, b) return a and b and a.mass > b.mass end
local function is_taller(a, b) return a and b and height[a.name] > height[b.name] end

local function is_on(a, b)
  local gap = (a.y - height[a.name] / 2) - (b.y + height[b.name] / 2)
  return math.abs(gap) < 0.004 and math.abs(a.x - b.x) < edge / 2 and math.abs(a.z - b.z) < edge / 2
end

local function is_between(a, b, c)
  return a and b and c and (a.x - b.x) * (a.x - c.x) < 0
end

-- ---- questions ----------------------------------------------------------------------------------------------------------

-- "The wooden block" or "the wooden one".
local called = { "wooden block|wooden one", "stone block|stone one", "metal block|metal one" }

L:question "heavier" {
  prompt = "Which block is heavier: the wooden block or the metal block?",
  again = "Lift both again.",
  answers = { "[the|a] {thing} is <comparative:heavy> [than [the|a] {other}]",
              "[the|a] {thing} is the <comparative:heavy> one",
              "the <comparative:heavy> (one|block) is [the|a] {thing}" },
  lists = { thing = called, other = called },
  -- Of the two that are asked about; what else that one is heavier than may be said with it.
  right = function(a)
    local thing = bodies[a.thing]
    local asked = thing == bodies.wood and bodies.metal or thing == bodies.metal and bodies.wood
    return is_heavier(thing, asked) and (a.other == nil or is_heavier(thing, bodies[a.other]))
  end,
  examples = { right = { "The metal block is heavier.", "the metal one is heavier", "the metal one" },
               wrong = { "the wooden block is heavier", "the stone block is heavier", "the stone block" } },
}

L:question "taller" {
  prompt = "Which block is the tallest?",
  again = "Look at the blocks again.",
  answers = { "[the|a] {thing} is the <superlative:tall> [one|block]",
              "the <superlative:tall> (one|block) is [the|a] {thing}" },
  lists = { thing = called },
  right = function(a)
    local thing = bodies[a.thing]
    return is_taller(thing, bodies.wood) and is_taller(thing, bodies.metal)
  end,
}

L:question "between" {
  prompt = "Which block is between the wooden block and the metal block?",
  again = "Look from left to right.",
  answers = { "[the|a] {thing} is between (them|the wooden block and the metal block|the metal block and the wooden block)",
              "it is [the|a] {thing}" },
  nearly = { "[the|a] {thing} is between" },
  lists = { thing = called },
  right = function(a) return is_between(bodies[a.thing], bodies.wood, bodies.metal) end,
}

L:question "on_top" {
  prompt = "Where is the wooden block now?",
  again = "Look at both blocks.",
  answers = { "[(it|the wooden block) is] {place} [the] {thing}" },
  lists = { place = { "on top of|on", "under|below" }, thing = called },
  right = function(a)
    local thing = bodies[a.thing]
    if not thing or thing == bodies.wood then return false end
    if a.place == "on top of" then return is_on(bodies.wood, thing) end
    return is_on(thing, bodies.wood)
  end,
}

-- ---- the game -----------------------------------------------------------------------------------------------------------

local function lift(world, body)
  local rest = height[body.name] / 2
  world:caption("Touch the " .. body.noun .. ", hold the button and lift it.")
  wait_until(function() return body.where == "held" and body.y > rest + lifted end)
  world:sound "pop"
  game.point()
  world:caption("Feel how heavy the " .. body.noun .. " is. Now put it down.")
  wait_until(function() return body.where ~= "held" end)
  wait_until(function() return body.resting end, 5)
  world:caption ""
end

-- What has fallen out of reach or over comes back.
local function tidy_up()
  for _, block in ipairs(blocks) do
    bodies[block.name]:place { at = { block.x, block.size[2] / 2, 0 } }
  end
end

local function stack(world, top, bottom)
  world:caption("Put the " .. top.noun .. " on top of the " .. bottom.noun .. ".")
  local done = wait_until(function() return is_on(top, bottom) and top.where ~= "held" and top.resting end, 90)
  if done then game.point() else game.miss() end
  world:caption ""
  return done
end

function play(world)
  world:level(1, "Heavy and light")
  tidy_up()
  lift(world, bodies.wood)
  lift(world, bodies.metal)
  game.ask("heavier", { hint = "Which one pulls your hand down more?", solution = "The metal block is heavier." })
  tidy_up()
  game.ask("taller", { hint = "Which one goes up higher?", solution = "The stone block is the tallest." })
  game.ask("between", { hint = "One is on its left and one on its right.",
                        solution = "The stone block is between them." })
  world:level(2, "A tower")
  if not stack(world, bodies.wood, bodies.metal) then
    bodies.wood:place { at = { bodies.metal.x, 1.5 * edge, 0 } }
    wait(1)
  end
  game.ask("on_top", { hint = "Is it higher or lower than the metal block?",
                       solution = "It is on top of the metal block." })
end

L:test {
  hand = "stacker.lua",
  say = { "the metal block is heavier than the wooden block", "the stone block is the tallest",
          "the stone block is between them", "it is on top of the metal block" },
  expect = { finished = true, stars = 3 },
}

return L
