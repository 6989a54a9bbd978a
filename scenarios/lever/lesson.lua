-- "Give me a place to stand, and I shall move the Earth": Archimedes' lever.
--
-- The answer key is the simulated lever: what a force at a place can lift follows from its torque and from that of the toy
-- Earth on the other end. Change the Earth's weight or the support's place below and the right answers change with it.

local game = require "game"
local numbers = require "numbers"
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
  world:hand { centre = { 0.1, 0.45, 0 }, scale = 4, tool = { shape = "cylinder", radius = 0.02, length = 0.12 } }
  support = world:body { name = "support", model = "support", visible = true, movable = true,
    at = { 0, height - 0.02, 0 } }
  lever = world:body {
    name = "lever", model = "lever", visible = true, solid = true, at = { 0, height, 0 },
    about = "This is a lever. It turns on its support.",
    hinge = { axis = { 0, 0, 1 }, at = { 0, height - 0.02, 0 }, inertia = 0.4, friction = 0.01, lowest = -7, highest = 7,
              load = levels[1].weight, load_at = { earth_x, height - 0.02, 0 } },
  }
  star = world:body { name = "star", model = "star", radius = 0.03 }
  game.play(L, world, function() play(world) end)
end

-- ---- what the hand does -------------------------------------------------------------------------------------------------

local function stand_support_at(x)
  support_x = x
  support:place { at = { x, height - 0.02, 0 } }
  lever:turn { at = { x, height - 0.02, 0 } }
end

-- The lever never jumps under a hand.
local function move_support(world, x)
  if lever.arm > 0 then
    world:caption "Lift your hand."
    wait_until(function() return lever.arm == 0 end)
    world:caption ""
  end
  stand_support_at(x)
end

local function presses_at(world, x)
  return lever.arm > 0 and math.abs(world:tool().x - x) < 0.12 and math.abs(lever.torque) > 0.01
end

-- Waits until the hand presses near the star, and gives whether the Earth left the ground. What there is to explain is told
-- while the hand still presses, for only then both arms and forces are drawn.
local function press(world, x, seconds, explain)
  star:place { at = { x, height + 0.22, 0 } }
  local function is_pressed() return presses_at(world, x) end
  wait_until(is_pressed)
  local lifted = wait_until(function() return lever.angle < 0 end, seconds)
  if lifted and explain then
    world:sound "pop"
    world:caption(explain)
    story.wait_while(is_pressed, 4)
  end
  star:hide()
  return lifted
end

-- Until it is lifted; gives whether it was. Some arms may give too little for it: then the Earth gets lighter.
local function lift(world, x, explain)
  local load = level.weight
  for try = 1, 12 do
    if press(world, x, 6, explain) then return true end
    wait(0.5)
    if try < 3 then
      world:caption "Press harder, under the star."
    else
      load = load / 2
      lever:turn { load = load }
      world:caption(("I make the Earth lighter: %.4g newtons. Press again, under the star."):format(load))
    end
  end
  world:caption "Let's go on."
  wait(2)
  return false
end

-- The same, for a point.
local function lift_for_a_point(world, x, explain)
  if lift(world, x, explain) then game.point() else game.miss() end
end

-- ---- what may be asked ----------------------------------------------------------------------------------------------------

L:knows "this" {
  asked = { "what is (this|that|it)", "what am I (touching|pressing)" },
  examples = { right = { "What is this?" } },
  answer = function() return "This is a lever. It lies on a support, and the toy Earth is on the other end." end,
}

L:knows "weight" {
  asked = { "how heavy is (it|the Earth|the toy Earth)", "how much does (it|the Earth|the toy Earth) weigh", "what does the Earth weigh" },
  nearly = { "how heavy (it|Earth|the Earth) [is]", "how much (weigh|weighs) (it|the Earth)" },
  examples = { right = { "How heavy is it?", "how much does the Earth weigh" }, form = { "how heavy the Earth is" } },
  answer = function() return level and ("The toy Earth weighs %.4g newtons."):format(level.weight) end,
}

L:knows "arm" {
  asked = { "how long is my arm", "how long is the arm", "how long is the arm of the Earth", "how long is the lever" },
  nearly = { "how long (my arm|the arm|arm) [is]", "how long is arm" },
  examples = { right = { "How long is my arm?" }, form = { "how long my arm is" } },
  answer = function()
    return ("Your arm is at most %.2f metres, the Earth's is %.3f metres."):format(end_x - support_x, support_x - earth_x)
  end,
}

L:knows "force" {
  asked = { "how much force do I need", "how strong must I be", "how many newtons do I need", "how hard must I press" },
  nearly = { "how (much|many) force I need", "how many (newton|newtons) I need", "how many newton do I need" },
  examples = { right = { "How much force do I need?", "how many newtons do I need" }, form = { "how much force I need" } },
  answer = function() return level and level.ratio < 1000 and ("At the end of the lever you need %.1f newtons."):format(needed(end_x, support_x)) or nil end,
}

-- ---- questions ----------------------------------------------------------------------------------------------------------

local places = { near = 0.12, far = end_x }

-- "It is easier far from the support." The two words go with other prepositions, so each has sentences of its own.
local function easier(place, preposition)
  local where = ("{%s} %s (the support|it)"):format(place, preposition)
  return {
    ("it is <comparative:easy> [to press] {%s} %s the support"):format(place, preposition),
    "it is <comparative:easy> [to press] " .. where,
    "it is <comparative:easy> [to press] {" .. place .. "}",
    "(it is <comparative:easy>|I need less force) (when|if) (I|you|we) press " .. where,
    "(it is <comparative:easy>|I need less force) (when|if) (I|you|we) press {" .. place .. "}",
    "[(I|you|we)] [(must|should|can)] press " .. where,
    "[(I|you|we)] [(must|should|can)] press {" .. place .. "}",
    "I need less force " .. where,
    where .. " [it is <comparative:easy> [to press]]",
    "{" .. place .. "} it is <comparative:easy> [to press]",
  }
end

local function nearly_easier(place)
  return {
    "[the] {" .. place .. "} is <comparative:easy> [to press]",
    "it is <comparative:easy> [to press] in the {" .. place .. "}",
    "(when|if) (I|you|we) press {" .. place .. "} [from (the support|it)] [it] [is] <comparative:easy>",
  }
end

local function joined(one, other)
  for _, each in ipairs(other) do one[#one + 1] = each end
  return one
end

L:question "near_far" {
  prompt = "Where is it easier to press: near the support or far from it?",
  again = "Let's press again.", feedback = { "replay", "prompt", "rule" },
  answers = joined(easier("far", "from"), easier("near", "")),
  nearly = joined(nearly_easier "far", nearly_easier "near"),
  lists = {
    near = { "near|nearer|close to|closer to|next to|near to|close|closer" },
    far = { "far|far away|further|further away|farther|farther away|a long way" },
  },
  right = function(a)
    local here, there = places.near, places.far
    if a.far then here, there = there, here end
    return needed(here, support_x) < needed(there, support_x)
  end,
}

local ways = { Earth = -0.1, hand = 0.1 }   -- where the two are from the support

local toward = "([(nearer|closer|close)] to|near|nearer|towards) the {goal}"

L:question "which_way" {
  prompt = "Where must the support go: to the Earth or to your hand?",
  again = "Look at the two arms.",
  answers = {
    "the support must go [(nearer|closer)] to the {goal}",
    "(the support|it) (must|should|has to|needs to|can) (go|move|come|be) " .. toward,
    "(the support|it) (goes|moves|comes) " .. toward,
    "[(I|you|we)] [(must|should|can|have to)] (move|push|put|bring) (it|the support) " .. toward,
    toward,
  },
  nearly = {
    "(the support|it) (must to go|must goes|must going|go|going|is go|need go|have to go) " .. toward,
    "[must] go " .. toward,
  },
  lists = { goal = { "Earth|left|left side", "hand|right|right side" } },
  -- Both verbs are right: the learner's hand may be here or there.
  examples = { right = { "The support must go to the Earth.", "It must come to the Earth.", "The support goes nearer to the Earth.",
                         "It comes nearer to the Earth." } },
  right = function(a) return needed(end_x, support_x + ways[a.goal]) < needed(end_x, support_x) end,
}

L:question "how_strong" {
  prompt = "The toy Earth weighs 1000 newtons. Your arm of the lever is 1000 times longer than the Earth's. How many newtons do you need?",
  again = "Multiply: force times arm is the same on both sides.",
  answers = {
    "I need {number} <plural:newton>",
    "(I|you|we) [(must|have to|can)] (need|press with|push with|use|lift it with) {number} [(<plural:newton>|N)]",
    "it is {number} (<plural:newton>|N)",
    "{number} (<plural:newton>|N) [(is|are) enough]",
  },
  nearly = { "(I|you|we) (must|am|is) need {number} [(newton|newtons|N)]", "need {number} [(newton|newtons|N)]",
             "(it|force|the force) [is] (need|needs) {number} [(newton|newtons|N)]",
             "with {number} [(newton|newtons|N)]" },
  lists = { number = numbers.words { 0, 1, 2, 3, 4, 5, 6, 8, 10, 20, 50, 100, 200, 500, 1000, 2000, 10000, 100000 } },
  right = function(a)
    local need = math.abs(lever.load_torque) / (end_x - support_x)
    return math.abs(numbers.value(a.number) - need) < 0.1 * need
  end,
}

-- ---- the game -----------------------------------------------------------------------------------------------------------

local function begin_level(world, number)
  level = levels[number]
  world:level(number, level.title)
  move_support(world, place_of(level.ratio))
  lever:turn { load = level.weight }
  wait(1.5)
end

local function near_or_far(world)
  begin_level(world, 1)
  world:caption "This is a toy Earth. It weighs 2 newtons. Press the lever near the support."
  press(world, places.near, 2.5)
  world:caption "That is hard. Now press far from the support."
  lift_for_a_point(world, places.far, "You lifted it! Keep pressing. Blue is the arm. Force times arm: that is the torque.")
  game.ask("near_far", {
    hint = "Press at both places. Where do you need less force?",
    again = function()
      press(world, places.near, 2.5)
      lift(world, places.far)
    end,
    solution = "It is easier far from the support: the arm is longer.",
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
      solution = "It must go to the Earth: then your arm is longer.",
    })
    move_support(world, support_x - 0.1)
    if not can_lift(end_x) then
      world:caption "Good. Move it further with the arrow keys, or let it go."
      wait_until(function() return can_lift(end_x) end, 2.5)
    end
    while not can_lift(end_x) do
      move_support(world, support_x - 0.05)
      wait(0.4)
    end
  until can_lift(end_x)
  world:caption "Press again, under the star."
  lift_for_a_point(world, end_x, "Keep pressing. The two torques balance: a small force on a long arm moves a heavy thing.")
end

function L:key(name)
  local step = name == "left" and -0.05 or name == "right" and 0.05
  if step and level == levels[2] and lever.angle > 0 and lever.arm == 0 then
    stand_support_at(math.max(place_of(20), math.min(support_x + step, 0.2)))
  end
end

local function place_to_stand(world)
  begin_level(world, 3)
  world:caption "The Earth's arm is 1 millimetre now. Your arm is 1 metre."
  wait(4)
  game.ask("how_strong", {
    hint = "1000 newtons times 1 millimetre is 1 newton metre. So is your force times 1 metre.",
    again = function() press(world, end_x, 2) end,
    solution = "You need 1 newton: 1000 times less, with an arm that is 1000 times longer.",
  })
  world:caption "Try it. Press under the star."
  lift_for_a_point(world, end_x, "You moved it! You go a long way, and the Earth only a little.")
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
