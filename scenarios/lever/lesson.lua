-- "Give me a place to stand, and I shall move the Earth": Archimedes' lever.
--
-- The answer key is the simulated lever: what a force at a place can lift follows from its torque and from that of the toy
-- Earth on the other end. Change the Earth's weight or the support's place below and the right answers change with it.

local game = require "game"
local story = require "story"
local wait, wait_until = story.wait, story.wait_until

local L = lesson { id = "lever", title = "Can you lift the Earth?", level = "A2", minutes = 12 }

local height = 0.3            -- of the support's edge, on which the lever lies
local earth_x = -0.5          -- where the toy Earth presses
local end_x = 0.5             -- where a hand presses best
local top = 0.03              -- half the lever's thickness, and the ball's radius
local strongest = 4           -- newtons that every arm can give

-- The toy Earth's weight in newtons and how many times longer the hand's arm is than the Earth's.
local levels = {
  { title = "Near or far?", weight = 2, ratio = 1 },
  { title = "Move the support", weight = 20, ratio = 1 },
  { title = "A place to stand", weight = 1000, ratio = 1000 },
}

local lever, support, star
local level                   -- the one that is played
local support_x = 0

-- Where the support stands when the hand's arm is so many times longer.
local function place_of(ratio) return earth_x + (end_x - earth_x) / (1 + ratio) end

-- ---- physics is the answer key ----------------------------------------------------------------------------------------

-- Newtons that a hand needs at `x` against the Earth when the support stands at `at`.
local function needed(x, at)
  return level.weight * (at - earth_x) / math.abs(x - at)
end

local function can_lift(x) return needed(x, support_x) <= strongest end

function L:start(world)
  world:ground(0)
  world:camera { eye = { 0, 0.75, 1.75 }, target = { 0, 0.36, 0 }, angle = 40 }
  world:hand { centre = { 0.1, 0.45, 0 }, scale = 4, cursor = "ball", cursor_size = 0.01 }
  support = world:body { name = "support", model = "support", visible = true, movable = true,
    at = { 0, height - 0.02, 0 } }
  lever = world:body {
    name = "lever", model = "lever", visible = true, solid = true, at = { 0, height, 0 },
    hinge = { at = { 0, height - 0.02, 0 }, inertia = 0.4, friction = 0.01, lowest = -7, highest = 7,
              load = levels[1].weight, load_at = { earth_x, height - 0.02, 0 } },
  }
  star = world:body { name = "star", model = "star", radius = 0.03 }
  game.play(L, world, function() play(world) end)
end

-- ---- what the hand does -------------------------------------------------------------------------------------------------

local function move_support(x)
  support_x = x
  support:place { at = { x, height - 0.02, 0 } }
  lever:turn { at = { x, height - 0.02, 0 } }
end

-- Waits until the hand presses near the star, and gives whether the Earth left the ground.
local function press(world, x, seconds)
  star:place { at = { x, height + 0.22, 0 } }
  wait_until(function()
    return lever.arm > 0 and math.abs(world:tool().x - x) < 0.12 and math.abs(lever.torque) > 0.01
  end)
  local left = seconds
  wait_until(function()
    left = left - 1 / 60
    return lever.angle < 0 or left <= 0
  end)
  local lifted = lever.angle < 0
  star:hide()
  return lifted
end

-- Until it is lifted. Some arms may give too little for it: then the Earth gets lighter.
local function lift(world, x)
  local load, tries = level.weight, 0
  while not press(world, x, 6) do
    tries = tries + 1
    if tries < 3 then
      world:caption "Press harder, under the star."
    else
      load = load / 2
      lever:turn { load = load }
      world:caption(("I make the Earth lighter: %.4g newtons. Press again, under the star."):format(load))
    end
  end
  world:sound "pop"
end

-- The same, for a point.
local function lift_for_a_point(world, x)
  lift(world, x)
  game.point()
end

-- ---- questions ----------------------------------------------------------------------------------------------------------

local places = { near = 0.12, far = end_x }

L:question "near_far" {
  prompt = "Where is it easier to press: near the support or far from it?",
  again = "Let's press again.",
  answers = { "[it is easier [to press]] {where} [(from|to)] [(the support|it)]", "[press] {where} [(from|to)] [(the support|it)]" },
  lists = { where = { "near", "far" } },
  right = function(a)
    local other = a.where == "near" and "far" or "near"
    return needed(places[a.where], support_x) < needed(places[other], support_x)
  end,
}

local ways = { left = -0.1, right = 0.1 }

L:question "which_way" {
  prompt = "Where must the support go: to the Earth or to your hand?",
  again = "Look at the two arms.",
  answers = { "[(the support|it) (must go|must move|goes|moves)] {way}", "[move (it|the support)] {way}" },
  lists = { way = { "left|to the left|to the Earth|near the Earth|nearer to the Earth",
                    "right|to the right|to the hand|to my hand|to your hand|near my hand" } },
  right = function(a) return needed(end_x, support_x + ways[a.way]) < needed(end_x, support_x) end,
}

local numbers = { one = 1, ten = 10, hundred = 100, thousand = 1000 }

L:question "how_strong" {
  prompt = "The toy Earth weighs 1000 newtons. Your arm is 1000 times longer. How many newtons do you need?",
  again = "Multiply: force times arm is the same on both sides.",
  answers = { "[I (need|must press)] {number} [(newton|newtons)]", "[it is] {number} [(newton|newtons)]" },
  lists = { number = { "one|1", "ten|10", "hundred|a hundred|100|one hundred", "thousand|a thousand|1000|one thousand" } },
  right = function(a)
    local need = math.abs(lever.load_torque) / (end_x - support_x)
    return math.abs(numbers[a.number] - need) < 0.1 * need
  end,
}

-- ---- the game -----------------------------------------------------------------------------------------------------------

local function begin_level(world, number)
  level = levels[number]
  world:level(number, level.title)
  move_support(place_of(level.ratio))
  lever:turn { load = level.weight }
  wait(1.5)
end

local function near_or_far(world)
  begin_level(world, 1)
  world:caption "This is a toy Earth. It weighs 2 newtons. Press the lever near the support."
  press(world, places.near, 2.5)
  world:caption "That is hard. Now press far from the support."
  lift_for_a_point(world, places.far)
  world:caption "You lifted it! Force times arm: that is the torque."
  wait(3)
  game.ask("near_far", {
    hint = "Press at both places. Where do you need less force?",
    again = function()
      press(world, places.near, 2.5)
      lift(world, places.far)
    end,
  })
end

local function move_it(world)
  begin_level(world, 2)
  world:caption "Now it weighs 20 newtons. Press as hard as you can."
  press(world, end_x, 2.5)
  world:caption "It is too heavy."
  wait(2)
  repeat
    game.ask("which_way", {
      hint = "A long arm for you, a short arm for the Earth.",
      again = function() press(world, end_x, 2) end,
    })
    move_support(support_x - 0.1)
    if not can_lift(end_x) then
      world:caption "Good. Move it further with the arrow keys, or let it go."
      local left = 2.5
      wait_until(function()
        left = left - 1 / 60
        return left <= 0 or can_lift(end_x)
      end)
    end
    while not can_lift(end_x) do
      move_support(support_x - 0.05)
      wait(0.4)
    end
  until can_lift(end_x)
  world:caption "Press again, under the star."
  lift_for_a_point(world, end_x)
  world:caption "The two torques balance. A small force on a long arm moves a heavy thing."
  wait(3)
end

function L:key(name)
  local step = name == "left" and -0.05 or name == "right" and 0.05
  if step and level == levels[2] and lever.angle > 0 then
    move_support(math.max(place_of(20), math.min(support_x + step, 0.2)))
  end
end

local function place_to_stand(world)
  begin_level(world, 3)
  world:caption "The Earth's arm is 1 millimetre now. Your arm is 1 metre."
  wait(4)
  game.ask("how_strong", {
    hint = "1000 newtons times 1 millimetre is 1 newton metre. So is your force times 1 metre.",
    again = function() press(world, end_x, 2) end,
  })
  world:caption "Try it. Press under the star."
  lift_for_a_point(world, end_x)
  world:caption "You moved it! You go a long way, and the Earth only a little."
  wait(4)
end

function play(world)
  near_or_far(world)
  move_it(world)
  place_to_stand(world)
end

L:test {
  hand = "presser.lua",
  say = { "it is easier far from the support", "to the Earth", "I need one newton" },
  expect = { finished = true, stars = 3, form_errors = 0 },
}

return L
