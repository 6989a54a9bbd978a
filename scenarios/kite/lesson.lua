-- A kite that the pupil builds and flies: what holds it up, what pulls it back, what is felt in the hand.
--
-- The answer key is the simulated flight: whether a change was good is known when the kite has been flown with it, and which force
-- is the stronger is read from the air on its cloth, over seconds. Change the kite, its line or the wind below and the right
-- answers change.

local game = require "game"
local story = require "story"
local wait, wait_until = story.wait, story.wait_until

local L = lesson { id = "kite", title = "Why does a kite fly?", level = "A2", minutes = 15 }

local breeze, strong = 4.5, 5.8     -- metres a second, 10 metres up; in the strong wind the line still pulls less than 4.5 N
local short, long = 12, 17          -- metres of line
local longest = 18
local lowest_knot, good_knot, highest_knot = 0.56, 0.68, 0.85   -- metres from the foot

local kite, balloon

function L:start(world)
  world:ground(0)
  world:camera { eye = { 3, 1.7, 22 }, target = { 3.6, 7.2, 0 }, angle = 60 }
  world:hand { centre = { 0, 1.2, 0 }, scale = 4 }
  -- Nearly from the side, so that lift and drag are seen as long as they are.
  world:wind { speed = breeze, towards = { 0.97, 0, -0.26 } }
  -- Its knot is right; what it lacks is a tail.
  kite = world:kite { tail = 0, line = short, seen = 5 }
  balloon = world:body { name = "balloon", model = "sphere", radius = 0.5, movable = true }
  for i, x in ipairs { -9, -6.5, 17, 20 } do
    world:body { name = "tree" .. i, noun = "tree", model = "tree", visible = true, at = { x, 0, -6 - 2 * i } }
  end
  game.play(L, world, function() play(world) end)
end

-- ---- what the air does, over seconds ----------------------------------------------------------------------------------------

local felt_over = 1.5   -- seconds
local measured = { "lift", "drag", "weight", "tension", "pull" }

-- Means over the last seconds in which it flew, and in which it lay on the ground: a hand that shakes changes neither much. A kite
-- that flies is held up by its lift; on the ground the air's force may point anywhere.
local flown, lain = {}, {}

local function take_into(mean, dt)
  for _, name in ipairs(measured) do
    local share = mean[name] and math.min(dt / felt_over, 1) or 1
    mean[name] = (mean[name] or 0) + share * (kite[name] - (mean[name] or 0))
  end
end

local function flies() return kite.altitude > 0.5 * kite.line and not kite.snapped end
local function lies() return kite.altitude < 0.5 and kite.speed < 0.2 end

local stays = false     -- it is launched again whenever it has come down
local may_reel = false
local down = 0          -- seconds

function L:update(_, dt)
  if flies() then
    take_into(flown, dt)
    down = 0
  else
    down = down + dt
    if lies() then take_into(lain, dt) end
  end
  if stays and down > 4 then
    kite:fly()
    down = 0
  end
  local most = may_reel and longest or short
  if kite.line > most + 0.2 then kite:reel(most) end
end

-- Waits until it flies, and has flown as long as is measured over.
local function fly_again()
  wait_until(flies, 12)
  wait(2 * felt_over)
end

-- Flies it for some seconds, and gives whether it stayed up.
local function stays_up(seconds)
  kite:fly()
  wait(seconds)
  local up = true
  wait_until(function()
    up = up and flies()
    return false
  end, 3)
  return up
end

-- ---- building ---------------------------------------------------------------------------------------------------------------

-- What is said of a part, and what becomes of it; nil when it cannot be changed that way any further.
local function change_of(answer)
  local size, change = answer.size or answer.tail_size, {}
  if size == "shorter" then
    change.tail = kite.tail > 0 and math.max(kite.tail - 1, 0) or nil
    return change, "tail"
  elseif answer.missing or size then
    change.tail = kite.tail < 8 and math.min(kite.tail + 2, 8) or nil
    return change, "tail"
  elseif answer.way then
    local knot = math.max(lowest_knot, math.min(kite.knot + (answer.way == "up" and 0.06 or -0.06), highest_knot))
    change.knot = math.abs(knot - kite.knot) > 0.001 and knot or nil
    return change, "knot"
  end
  local cloth = answer.cloth or (answer.weight == "lighter" and "silk" or "paper")
  change.cloth = cloth ~= kite.cloth and cloth or nil
  return change, "cloth"
end

L:question "change" {
  prompt = "What do you want to change: the tail, the knot or the cloth?",
  again = "Say something else.",
  answers = {
    "[(I|we|you)] [(must|should|can|have to|want to|would)] make the tail {size}",
    "(it|the kite) needs a {tail_size} tail",
    "(it|the kite) needs a {missing}",
    "(I|we) (need|want) a {tail_size} tail",
    "(I|we) (need|want) a {missing}",
    "(it|the kite) (must|should|has to) have a {tail_size} tail",
    "(it|the kite) (must|should|has to) have a {missing}",
    "(it|the kite) has no {missing}",
    "there is no {missing}",
    "the tail (must|should|has to) be {size}",
    "[(I|we|you)] [(must|should|can|have to|want to|would)] (move|put|push|tie) the knot {way}",
    "[(I|we|you)] [(must|should|can|have to|want to|would)] make the cloth {weight}",
    "the cloth (must|should|has to) be {weight}",
    "(it|the kite) needs a {weight} cloth",
    "[(I|we|you)] [(must|should|can|have to|want to|would)] (use|take) a {weight} cloth",
    "[(I|we|you)] [(must|should|can|have to|want to|would)] (use|take) {cloth}",
    "[(I|we|you)] [(must|should|can|have to|want to|would)] (add|give it|give the kite|put on|put|make|use) a {tail_size} tail",
    "[(I|we|you)] [(must|should|can|have to|want to|would)] (add|give it|give the kite|put on|put|make|use) a {missing}",
    "a {tail_size} tail",
    "a {weight} cloth",
    "a {missing}",
  },
  nearly = {
    "make tail {size}", "tail {size}", "more {tail_size} tail", "{tail_size} tail", "{missing}", "the {missing}",
    "(it|the kite) must has [a] {missing}", "need [a] {missing}", "needs [a] {missing}", "add {missing}", "tail must be {size}",
    "(I|we) must to (add|make|use) [a] {missing}", "knot {way}", "{weight} cloth", "make cloth {weight}",
  },
  lists = {
    size = { "longer|long|bigger", "shorter|short|smaller" }, tail_size = { "longer|long|bigger", "shorter|short|smaller" },
    missing = { "tail|kite tail" }, way = { "up|higher|further up", "down|lower|further down" },
    weight = { "lighter|light", "heavier|heavy" }, cloth = { "silk", "paper", "plastic", "ripstop" },
  },
  -- Anything may be tried that can be done: the flight is the judge.
  right = function(a)
    return next((change_of(a))) ~= nil
  end,
}

local tried = {
  tail = "The tail holds the kite's foot back, so that its nose points into the wind.",
  knot = "The knot says how steeply the kite stands in the wind.",
  cloth = "The cloth makes it lighter or heavier.",
}

-- Asks what to change until it is something that can be done, and does it; gives which part it was.
local function change_it(world)
  local answer, change, part
  repeat
    answer = story.ask(world, "change")
    change, part = change_of(answer)
    if answer.understood and not answer.right and not answer.over then
      wait(2)
      local size = answer.size or answer.tail_size
      world:caption(part == "tail" and size == "shorter" and "It has no tail yet." or "That is as far as it goes.")
      wait(2.5)
    end
  until answer.over
  wait(2.5)
  if not answer.understood or next(change) == nil then
    local has_tail = kite.tail >= 2
    change, part = { tail = math.max(kite.tail, 2), knot = has_tail and good_knot or nil, cloth = has_tail and "ripstop" or nil }, "tail"
    world:caption(has_tail and "Let's tie the knot where it was." or "Let's try a tail.")
  else
    world:caption "Let's try it."
  end
  wait(1.5)
  kite:build(change)
  world:caption(tried[part])
end

-- In the breeze it is to pull so much that the hand feels more of it in more wind.
local most_in_breeze = 2.8

local function build_for_the_hand(world)
  if flown.pull > most_in_breeze then
    world:caption "It pulls very hard. I tie the knot where it was."
    kite:build { tail = 2, knot = good_knot, cloth = "ripstop" }
    wait(3)
    fly_again()
  end
end

-- Until it flies; three points at the first change, one less for each more.
local function build_one_that_flies(world)
  world:level(1, "Build a kite")
  world:caption "This kite has no tail. Let's see if it flies."
  local points = 3
  if stays_up(9) then
    game.point(points)
    return
  end
  for _ = 1, 5 do
    world:caption "It came down."
    wait(2)
    change_it(world)
    if stays_up(12) then
      world:sound "pop"
      world:caption "It flies!"
      wait(2.5)
      game.point(points)
      if points < 3 then game.miss(3 - points) end
      build_for_the_hand(world)
      return
    end
    points = math.max(points - 1, 1)
  end
  world:caption "I give it a tail of two metres."
  kite:build { tail = 2, knot = good_knot, cloth = "ripstop" }
  game.miss(3)
  stays_up(10)
end

-- ---- four forces ------------------------------------------------------------------------------------------------------------

L:question "up" {
  prompt = "Which force holds the kite up?",
  again = "Look at the arrows.",
  answers = { "the {force} holds (it|the kite) up", "the {force} (pulls|pushes) (it|the kite) up", "it is the {force}",
              "the {force}" },
  nearly = { "[the] {force} (hold|is hold|is holding) [(it|the kite)] up", "[the] {force} (pull|push) [(it|the kite)] up", "{force}",
             "it is {force}" },
  lists = { force = { "lift|lift force", "drag|drag force", "weight|gravity", "tension|tension force" } },
  -- It flew, and so what pointed up was the air's force across the wind, as long as it was more than the weight.
  right = function(a) return a.force == "lift" and flown.lift > flown.weight end,
}

L:question "hand" {
  prompt = "Which force do you feel in your hand?",
  again = "Look at the line, and feel it.",
  answers = { "(I|we) feel the {force} [of the line]", "it is the {force} [of the line]", "the {force} [of the line]" },
  nearly = { "(I|we) (am feel|am feeling|feels|feeling) [the] {force}", "(I|we) feel {force}", "it is {force}", "{force}" },
  lists = { force = { "lift|lift force", "drag|drag force", "weight|gravity",
                      "tension|pull|tension force|force of the line" } },
  right = function(a) return a.force == "tension" end,
}

L:question "stronger" {
  prompt = "Which force is stronger: the lift or the drag?",
  again = "Read the newtons.",
  answers = { "the {force} is <comparative:strong> [than the {other}]", "the {force} is <comparative:big> [than the {other}]",
              "it is the {force}", "the {force}" },
  nearly = { "[the] {force} (are|be) <comparative:strong>", "it is {force}", "{force}" },
  lists = { force = { "lift", "drag" }, other = { "lift", "drag" } },
  right = function(a)
    local other = a.force == "lift" and "drag" or "lift"
    return (a.other or other) == other and flown[a.force] > flown[other]
  end,
}

local function show_forces(world)
  stays = true
  world:level(2, "Four forces")
  kite:show_forces(true)
  world:caption "The air pushes the kite up: that is lift. It pushes it along: that is drag."
  wait(5)
  world:caption "The Earth pulls it down: that is its weight. The line holds it: that is tension."
  wait(5)
  fly_again()
  local look = { hint = "Look at the four arrows.", again = fly_again }
  look.solution = "The lift holds the kite up."
  game.ask("up", look)
  look.solution = "You feel the tension of the line."
  game.ask("hand", look)
  look.hint = "How many newtons has the lift, and how many has the drag?"
  look.solution = function()
    return flown.lift > flown.drag and "The lift is stronger than the drag." or "The drag is stronger than the lift."
  end
  game.ask("stronger", look)
end

-- ---- wind and line ----------------------------------------------------------------------------------------------------------

local before      -- newtons in the hand, in the breeze

L:question "pull" {
  prompt = "Now the wind is stronger. Does the line pull more or less?",
  again = "Feel the line again.",
  answers = { "(it|the line) pulls {amount} [than before]", "(it|the pull|the tension) is {amount} [than before]",
              "{amount} [than before]" },
  nearly = { "(it|the line|they) (pull|is pull) {amount}" },
  lists = { amount = { "more|harder|more strongly|stronger|bigger", "less|more weakly|weaker|smaller" } },
  right = function(a) return (flown.pull > before) == (a.amount == "more") end,
}

local function raise_the_wind(world)
  world:level(3, "More wind, more line")
  kite:show_forces(false)
  world:caption "Feel how hard the line pulls."
  wait(1)
  fly_again()
  before = flown.pull
  world:wind_speed(strong)
  world:caption "The wind grows."
  wait(3)
  fly_again()
  game.ask("pull", {
    hint = "First the wind was weak. Now it is strong.",
    again = function()
      world:wind_speed(breeze)
      wait(5)
      world:wind_speed(strong)
      wait(2)
      fly_again()
    end,
    solution = function()
      return flown.pull > before and "It pulls more: a little more wind, and the line pulls much harder." or "It pulls less."
    end,
  })
  world:wind_speed(breeze)
  fly_again()
  balloon:place { at = { kite.x + 3, long - 1.5, kite.z } }
  world:caption "Let the line out: turn the wheel, or press the first button. Fly as high as the balloon."
  may_reel = true
  if wait_until(function() return kite.altitude > long - 1.5 end, 60) then
    world:sound "pop"
    world:caption "You are there!"
    game.point()
  else
    game.miss()
  end
  balloon:hide()
  wait(2)
end

-- ---- why it comes down ------------------------------------------------------------------------------------------------------

L:question "why" {
  prompt = "Why did the kite come down?",
  again = "Look at lift and weight.",
  answers = {
    "[because] the {force} is <comparative:{size}> than the {other}",
    "[because] the {force} was <comparative:{size}> than the {other}",
    "[because] there (is|was) no {nothing}",
    "[because] there (isn't|wasn't) any {nothing}",
    "[because] (it|the kite) (has|had) no {nothing}",
    "[because] (it|the kite) (doesn't|didn't) have [any] {nothing}",
    "[because] the {nothing} (stopped|has stopped|is gone)",
    "[because] the {nothing} (is|was) too weak",
    "[because] without {nothing} (it|the kite) (can't|cannot|doesn't) fly",
    "no {nothing}",
  },
  nearly = { "[because] (have|has|is) no {nothing}", "[because] the {force} <comparative:{size}> than the {other}",
             "because no {nothing}", "[because] (it|the kite) (don't|doesn't|didn't) (has|had) [any] {nothing}",
             "[because] {nothing} (stopped|stop|is stop|has stopped)", "[because] the {nothing} (stop|is stop)" },
  lists = { force = { "lift", "weight" }, other = { "lift", "weight" }, size = { "small", "big", "weak", "strong" },
            nothing = { "wind|air", "lift" } },
  -- It lies: what the air did to it there.
  right = function(a)
    if a.nothing == "wind" then return kite.wind < 1 end
    if a.nothing == "lift" then return lain.lift < lain.weight end
    local more = a.size == "big" or a.size == "strong"
    return a.force ~= a.other and (lain[a.force] > lain[a.other]) == more
  end,
}

local function stop_the_wind(world)
  stays, may_reel = false, false
  world:level(4, "No wind")
  world:caption "We take the line in again."
  kite:reel(short)
  -- In the wind, for a kite on a line that is taken in flies without any.
  wait_until(function() return kite.line <= short + 0.25 end, 20)
  wait(1)
  world:caption "And now the wind stops."
  kite:show_forces(true)
  for tenth = 9, 0, -1 do
    world:wind_speed(0.1 * tenth * breeze)
    wait(0.3)
  end
  lain = {}
  wait_until(lies, 20)
  take_into(lain, 0)
  wait(2 * felt_over)
  game.ask("why", {
    hint = "There is no wind. What does the air do then?",
    again = function() wait(2) end,
    solution = "The lift is smaller than the weight: without wind there is no lift.",
  })
  world:wind_speed(breeze)
  kite:show_forces(false)
  kite:fly()
  world:caption "With wind it flies again."
  wait(4)
end

function play(world)
  stays, may_reel = false, false
  kite:show_forces(false)
  world:wind_speed(breeze)
  kite:build { tail = 0, knot = good_knot, cloth = "ripstop" }
  kite:reel(short)
  build_one_that_flies(world)
  show_forces(world)
  raise_the_wind(world)
  stop_the_wind(world)
end

L:test {
  hand = "flyer.lua",
  say = { "it needs a tail", "the lift holds it up", "I feel the tension", "the lift is stronger than the drag", "it pulls more",
          "because the lift is smaller than the weight" },
  expect = { finished = true, stars = 3, form_errors = 0 },
}

return L
