-- "Give me a place to stand, and I shall move the Earth": Archimedes' lever.
--
-- The answer key is the simulated lever: what a force at a place can lift follows from its torque and from that of the toy
-- Earth on the other end. Change the Earth's weight or the support's place below and the right answers change with it.

local game = require "game"
local know = require "know"
local numbers = require "numbers"
local story = require "story"
local wait, wait_until, wait_with_help = story.wait, story.wait_until, story.wait_with_help

local L = lesson { id = "lever", title = "Can you lift the Earth?", icon = "lever", order = 4, level = "A2", minutes = 12, free_english = true }

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
    local at = world:tool().position
    repeat   -- as long as it takes: nothing may jump under a hand
    until wait_with_help(world, function() return lever.arm == 0 end, {
      hint = "Go up, away from the lever.", show = { { at.x, height + top, 0 }, { at.x, height + 0.25, 0 } },
    })
    world:caption ""
  end
  stand_support_at(x)
end

local function presses_at(world, x)
  return lever.arm > 0 and math.abs(world:tool().x - x) < 0.12 and math.abs(lever.torque) > 0.01
end

-- Waits until the hand presses near the star, and gives whether the Earth left the ground; nil where nobody presses. What there is to
-- explain is told while the hand still presses, for only then both arms and forces are drawn.
local function press(world, x, seconds, explain)
  star:place { at = { x, height + 0.22, 0 } }
  local function is_pressed() return presses_at(world, x) end
  local above = height + 0.2
  local pressed = wait_with_help(world, is_pressed, {
    hint = "Go above the lever, under the star. Then go down and press.",
    show = { { x, above, 0 }, { x, height + top, 0 }, { x, height - 0.01, 0 } },
  })
  if not pressed then
    star:hide()
    return nil
  end
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
    local lifted = press(world, x, 6, explain)
    if lifted then return true end
    if lifted == nil then break end   -- nobody presses
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

-- A length as it is said: "1 millimetre", "30 centimetres", "0.999 metres".
local function length(metres)
  if metres < 0.0095 then
    local n = math.floor(1000 * metres + 0.5)
    return n .. (n == 1 and " millimetre" or " millimetres")
  elseif metres < 0.995 then
    local n = math.floor(100 * metres + 0.5)
    return n .. (n == 1 and " centimetre" or " centimetres")
  end
  return math.abs(metres - 1) < 0.005 and "1 metre" or ("%.2g metres"):format(metres)
end

L:knows "arm" {
  asked = { "how long is (my|the|your) arm", "how long is the arm of (the Earth|the toy Earth)", "how long are the arms" },
  nearly = { "how long (my arm|the arm|arm) [is]", "how long is arm" },
  examples = { right = { "How long is my arm?", "how long are the arms" }, form = { "how long my arm is" } },
  answer = function()
    return ("Your arm is at most %s, and the Earth's arm is %s."):format(length(end_x - support_x), length(support_x - earth_x))
  end,
}

L:knows "length" {
  asked = { "how long is the lever", "how long is (it|this)" },
  nearly = { "how long (the lever|lever|it) [is]", "how long is lever" },
  examples = { right = { "How long is the lever?" }, form = { "how long the lever is" } },
  answer = function() return ("The lever is %s long, from the Earth to its other end."):format(length(end_x - earth_x)) end,
}

know.words(L, {
  "lever", "support", "torque", "arm", "arrow", "force", "newton", "weight", "weigh", "toy", "metre", "millimetre", "multiply",
})

L:knows "force" {
  asked = { "how much force do I need", "how strong must I be", "how many newtons do I need", "how hard must I press" },
  nearly = { "how (much|many) force I need", "how many (newton|newtons) I need", "how many newton do I need" },
  examples = { right = { "How much force do I need?", "how many newtons do I need" }, form = { "how much force I need" } },
  answer = function() return level and level.ratio < 1000 and ("At the end of the lever you need %.1f newtons."):format(needed(end_x, support_x)) or nil end,
}

-- ---- questions ----------------------------------------------------------------------------------------------------------

local places = { near = 0.12, far = end_x }

-- "It is easier far from the support." The two words go with other prepositions, so each has rules of its own; both are said in the
-- same sentences.
local function easier(place)
  local where, there, press = "<" .. place .. "_support>", "<" .. place .. "_place>", "(when|if) (I|you|we) (press|push) [down] [(it|the lever)] "
  return {
    "(it is|it gets|it becomes) <comparative:easy> " .. where,
    "(it is|it gets|it becomes) <comparative:easy> <to_press> " .. there, "<comparative:easy> " .. there,
    "(it is <comparative:easy>|it is less hard|(I|you|we) need less force|it takes less force) " .. press .. there,
    "[(I|you|we)] [(must|should|can|have to)] (press|push) [less] [(it|the lever)] " .. there, "((I|you|we) need|it (needs|takes)) less force <to_press> " .. there,
    "<" .. place .. "_whole>", there .. " (it is|it gets) <comparative:easy> <to_press>", press .. there .. " [it is <comparative:easy>]", "(when|if) (I am|you are|we are) " .. there, "less force is needed " .. there,
    "(when|if|where) the (arm|lever arm) is {" .. place .. "_arm}", "(pressing|pushing) [(it|the lever)] " .. there .. " is <comparative:easy>",
    "it is <comparative:easy> (when|if|where) (the|my|your) (arm|lever arm) is {" .. place .. "_arm}",
  }
end

local function nearly_easier(place)
  return {
    "[the] {" .. place .. "} is <comparative:easy> [to press]",
    "it is <comparative:easy> [to press] in the {" .. place .. "}",
    "(when|if) (I|you|we) press {" .. place .. "} [from (the support|it)] [it] [is] <comparative:easy>",
    "is <comparative:easy> <to_press> <" .. place .. "_place>", "more {" .. place .. "} [from] [(the support|it)]", "the more {" .. place .. "} the more easy",
  }
end

local function joined(one, other)
  for _, each in ipairs(other) do one[#one + 1] = each end
  return one
end

L:question "near_far" {
  prompt = "Where is it easier to press: near the support or far from it?",
  again = "Let's press again.", feedback = { "replay", "prompt", "rule" },
  -- The first is what help shows: the others have a word of their own for each place.
  answers = joined(joined(joined({ "pressing is <comparative:easy> {where}" }, easier "far"), easier "near"), {
    -- "The farther, the easier."
    "the <comparative:{how}> [<from>] the <comparative:easy> [it (is|gets|becomes)]",
    "it (is|gets|becomes) <comparative:easy> the <comparative:{how}> ((I|you|we) (press|push|go)|I am|you are) [(from|to) (the support|it)]", "<tip_of>",
    "not near {not_by}", "at {by}", "it is {same}", "in the {between}",
  }),
  nearly = joined(joined(nearly_easier "far", nearly_easier "near"), {
    "in the {far} (place|side|part|end) it is <comparative:easy>", "[the] more {far} is <comparative:easy>",
    "it is <comparative:easy> (farest|most far) [from] [(the support|it|support)]", "(I|you|we) need (few|fewer|lesser|little) force {far} from (the support|it)",
  }),
  rules = {
    to_press = "[to (press|push|move|lift) [down] [(it|the lever|the Earth)]]",
    far_support = "{far} from the support", far_place = "(<far_whole>|{far})",
    far_whole = "({far} from (the support|it)|as {far} [away] [from (the support|it)] as possible|at <tip_of>)", tip_of = "(the {tip}|the far end) [of the lever]",
    from = "[the (arm|lever|lever arm)] [away] [(from|to) (the support|it)] [((I|you|we) (press|push|go)|I am|you are) [(it|the lever)] [away] [(from|to) (the support|it)]]",
    near_support = "{near} the support", near_place = "(<near_whole>|{near})", near_whole = "({near} (the support|it|the middle)|as {near} (the support|it) as possible)",
  },
  lists = {
    near = { "near|nearer|close to|closer to|next to|near to|close|closer" },
    far = { "far|far away|further|further away|farther|farther away|a long way|away" }, tip = { "end|tip|other end|very end" },
    where = { "far from the support", "near the support", "at the end", "in the middle" }, not_by = { "the support" }, by = { "the support" },
    same = { "the same|the same everywhere|the same at both places|equally easy|just as easy" }, between = { "middle" },
    near_arm = { "short|shorter" }, far_arm = { "long|longer" }, how = { "far", "near", "close", "long", "short" },
  },
  right = function(a)
    if a.same or a.between or a.where == "in the middle" then return false end
    local near = a.where == "near the support" or a.by or a.near or a.near_arm or a.how == "near" or a.how == "close" or a.how == "short"
    local here, there = near and places.near or places.far, near and places.far or places.near
    return needed(here, support_x) < needed(there, support_x)
  end,
}

local ways = { Earth = -0.1, hand = 0.1 }   -- where the two are from the support

L:question "which_way" {
  prompt = "Where must the support go: to the Earth or to your hand?",
  again = "Look at the two arms.",
  answers = {
    "the support must go [(nearer|closer)] to the {goal}",
    "(the support|it) (must|should|has to|needs to|can) (go|move|come|be|be moved|be pushed|be put) <toward>",
    "(the support|it) (goes|moves|comes) <toward>",
    "[<who>] (move|push|put|bring|shift|slide) (it|the support) <toward>",
    "<toward>", "the {goal}", "(the support|it) (must|should|has to|needs to) {stay} [(in the middle|where it is)]",
  },
  nearly = {
    "(the support|it) (must to go|must goes|must going|go|going|is go|need go|have to go) <toward>",
    "[must] go <toward>", "more (near|close) to the {goal}", "(I|you|we) must to (move|push|put) (it|the support) <toward>",
    "(the support|it) must go more (near|close) to the {goal}",
  },
  rules = {
    who = "((I|you|we) [(must|should|can|could|would|will|have to|need to|want to)]|let us|(I|we) would like to)",
    toward = "<at>|<me>|<away>|{side}",
    at = "([(nearer|closer|close)] to|as (close to|near [to])|next to|near|nearer|towards|in the direction of) (the {goal}|the toy {goal}) [as possible]",
    me = "([(nearer|closer|close)] to|next to|near|nearer|towards) {me}",
    away = "[(further|farther|far)] away from the {from}|(further|farther|far) from the {from}",
  },
  lists = { goal = { "Earth|planet|left|left side", "hand|right|right side" }, from = { "Earth", "hand" }, me = { "me|us" }, stay = { "stay|stand still" }, side = { "left", "right" } },
  -- Both verbs are right: the learner's hand may be here or there.
  examples = { right = { "The support must go to the Earth.", "It must come to the Earth.", "The support goes nearer to the Earth.",
                         "It comes nearer to the Earth." } },
  right = function(a)
    if a.stay then return false end
    local goal = a.goal or (a.from == "hand" or a.side == "left") and "Earth" or "hand"
    return needed(end_x, support_x + ways[goal]) < needed(end_x, support_x)
  end,
}

L:question "how_strong" {
  prompt = "The toy Earth weighs 1000 newtons. Your arm of the lever is 1000 times longer than the Earth's. How many newtons do you need?",
  again = "Multiply: force times arm is the same on both sides.",
  answers = {
    "I need {number} <plural:newton>",
    "(I|you|we) [(must|have to|need to|can|would|will)] (need|press with|push with|use|lift it with) [(a force of|about)] {number} [<newtons>] <to_lift>",
    "(it is|it would be|that is|it takes|the force (is|must be)|the answer is) [(a force of|about)] {number} <newtons> <to_lift>",
    "[(a force of|about)] {number} <newtons> [((is|are|would be) enough|is all (I|you) need)] <to_lift>", "my hand needs {number} <newtons>",
  },
  nearly = { "(I|you|we) (must|am|is) need {number} [(newton|newtons|N)]", "need {number} [(newton|newtons|N)]", "is {number} [(newton|newtons|N)]",
             "(it|force|the force) [is] (need|needs) {number} [(newton|newtons|N)]",
             "with {number} [(newton|newtons|N)]", "(I|you|we) need of {number} (newton|newtons)", "(I|you|we) need force of {number} [(newton|newtons|N)]", "(I|you|we) must to (press|push) with {number} [(newton|newtons|N)]" },
  rules = { newtons = "(<plural:newton>|N) [of force]", to_lift = "[to (lift|move) (it|the Earth|the toy Earth)]" },
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
  world:caption "Near the support it is hard. Now press far from it."
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
