-- A kite that the pupil builds and flies: what holds it up, what pulls it back, what is felt in the hand.
--
-- The answer key is the simulated flight: whether a change was good is known when the kite has been flown with it, and which force
-- is the stronger is read from the air on its cloth. Change the kite, its line or the wind below and the right answers change.

local game = require "game"
local story = require "story"
local wait, wait_until = story.wait, story.wait_until

local L = lesson { id = "kite", title = "Why does a kite fly?", level = "A2", minutes = 15 }

local breeze, strong = 4.5, 6.2     -- metres a second, 10 metres up
local short, long = 12, 17          -- metres of line

local kite, balloon

function L:start(world)
  world:ground(0)
  world:camera { eye = { 2.5, 1.7, 19 }, target = { 3.5, 7.9, 0 }, angle = 50 }
  world:hand { centre = { 0, 1.2, 0 }, scale = 4 }
  world:wind { speed = breeze, towards = { 0.78, 0, -0.62 } }
  -- Its knot is right; what it lacks is a tail.
  kite = world:kite { tail = 0, line = short, seen = 4 }
  balloon = world:body { name = "balloon", model = "sphere", radius = 0.5, movable = true }
  for i, x in ipairs { -9, -6.5, 17, 20 } do
    world:body { name = "tree" .. i, noun = "tree", model = "tree", visible = true, at = { x, 0, -6 - 2 * i } }
  end
  game.play(L, world, function() play(world) end)
end

-- ---- the flight is the judge --------------------------------------------------------------------------------------------

-- Flies it for some seconds, and gives whether it stayed up.
local function stays_up(world, seconds)
  kite:fly()
  wait(seconds)
  local lowest = kite.altitude
  wait_until(function()
    lowest = math.min(lowest, kite.altitude)
    return false
  end, 3)
  return lowest > 0.5 * kite.line and not kite.snapped
end

-- ---- building ---------------------------------------------------------------------------------------------------------------

-- What is said of a part, and what becomes of it.
local function change_of(answer)
  if answer.missing or answer.size == "longer" or answer.tail_size == "longer" then
    return { tail = math.min(kite.tail + 2, 8) }, "tail"
  elseif answer.size == "shorter" or answer.tail_size == "shorter" then
    return { tail = math.max(kite.tail - 1, 0) }, "tail"
  elseif answer.way == "up" then
    return { knot = math.min(kite.knot + 0.06, 0.85) }, "knot"
  elseif answer.way == "down" then
    return { knot = math.max(kite.knot - 0.06, 0.55) }, "knot"
  elseif answer.weight == "lighter" then
    return { cloth = "silk" }, "cloth"
  end
  return { cloth = "paper" }, "cloth"
end

L:question "change" {
  prompt = "What must we change: the tail, the knot or the cloth?",
  again = "Say it again.",
  answers = {
    "[(I|we|you)] [(must|should|can|have to)] make the tail {size}",
    "it needs a {tail_size} tail",
    "it needs [a] {missing}",
    "the tail (must|should|has to) be {size}",
    "[(I|we|you)] [(must|should|can|have to)] (move|put|push|tie) the knot {way}",
    "[it needs] a {weight} cloth",
    "a {tail_size} tail",
    "[(I|we|you)] [(must|should|can|have to)] (add|give it|put on|make|use) a {missing}",
    "[(I|we|you)] [(must|should|can|have to)] (use|take) a {weight} cloth",
    "a {missing}",
  },
  nearly = {
    "make tail {size}", "tail {size}", "(more {tail_size}|{tail_size}) tail", "{missing}",
    "it must has [a] {missing}", "it need [a] {missing}", "knot {way}", "{weight} cloth",
  },
  lists = {
    size = { "longer", "shorter" }, tail_size = { "longer|long|bigger", "shorter|short|smaller" },
    missing = { "tail|kite tail" }, way = { "up|higher|further up", "down|lower|further down" },
    weight = { "lighter|light", "heavier|heavy" },
  },
  right = function() return true end,
}

local tried = {
  tail = "The tail holds the kite's foot back, so that its nose points into the wind.",
  knot = "The knot says how steeply the kite stands in the wind.",
  cloth = "The cloth makes it lighter or heavier.",
}

-- Until it flies; three points at the first change, one less for each more.
local function build_one_that_flies(world)
  world:level(1, "Build a kite")
  world:caption "This kite has no tail. Let's see if it flies."
  local points = 3
  if stays_up(world, 9) then
    game.point(points)
    return
  end
  for try = 1, 5 do
    world:caption "It turned over and came down."
    wait(2)
    local change, part = change_of(story.ask(world, "change"))
    wait(2.5)
    kite:build(change)
    world:caption(tried[part])
    if stays_up(world, 12) then
      world:sound "pop"
      world:caption "It flies!"
      wait(2.5)
      game.point(points)
      if points < 3 then game.miss(3 - points) end
      return
    end
    points = math.max(points - 1, 1)
  end
  world:caption "I give it a tail of two metres."
  kite:build { tail = 2, knot = 0.68, cloth = "ripstop" }
  game.miss(3)
  stays_up(world, 10)
end

-- ---- four forces ------------------------------------------------------------------------------------------------------------

local function newtons(name)
  return ({ lift = kite.lift, drag = kite.drag, weight = kite.weight, tension = kite.tension })[name]
end

local forces = { "lift", "drag", "weight", "tension" }

L:question "up" {
  prompt = "Which force holds the kite up?",
  again = "Look at the arrows.",
  answers = { "[the] {force} holds [(it|the kite)] up", "[the] {force} (pulls|pushes) [(it|the kite)] up", "it is [the] {force}",
              "[the] {force}" },
  nearly = { "[the] {force} (hold|pull|push|is hold) [(it|the kite)] up" },
  lists = { force = forces },
  -- What points up: the air's force across the wind, as long as it is more than the weight.
  right = function(a) return a.force == "lift" and kite.lift > kite.weight end,
}

L:question "hand" {
  prompt = "Which force do you feel in your hand?",
  again = "Look at the line, and feel it.",
  answers = { "(I|we) feel [the] {force}", "it is [the] {force}", "[the] {force} [of the line]" },
  nearly = { "(I|we) (am feel|feels|feeling) [the] {force}" },
  lists = { force = forces },
  -- The pull in the hand is as strong as the one that it comes from.
  right = function(a) return math.abs(newtons(a.force) - kite.pull) < 0.5 and a.force == "tension" end,
}

L:question "stronger" {
  prompt = "Which force is stronger: the lift or the drag?",
  again = "The longer arrow is the stronger force.",
  answers = { "[the] {force} is <comparative:strong> [than the {other}]", "[the] {force} is <comparative:big> [than the {other}]",
              "it is [the] {force}", "[the] {force}" },
  nearly = { "[the] {force} (are|be) <comparative:strong>" },
  lists = { force = { "lift", "drag", "weight", "tension" }, other = { "lift", "drag", "weight", "tension" } },
  right = function(a)
    local other = a.other or (a.force == "lift" and "drag" or "lift")
    return newtons(a.force) > newtons(other)
  end,
}

local function show_forces(world)
  world:level(2, "Four forces")
  kite:show_forces(true)
  world:caption "The air pushes the kite up: that is lift. It pushes it along: that is drag."
  wait(5)
  world:caption "The Earth pulls it down: that is its weight. The line holds it: that is tension."
  wait(5)
  local look = { hint = "Look at the four arrows.", again = function() wait(3) end }
  look.solution = "The lift holds the kite up."
  game.ask("up", look)
  look.solution = "You feel the tension of the line."
  game.ask("hand", look)
  look.solution = function()
    return kite.lift > kite.drag and "The lift is stronger than the drag." or "The drag is stronger than the lift."
  end
  game.ask("stronger", look)
end

-- ---- wind and line ----------------------------------------------------------------------------------------------------------

local before      -- newtons in the hand, in the breeze

L:question "pull" {
  prompt = "Now the wind is stronger. Does the line pull more or less?",
  again = "Feel the line again.",
  answers = { "[(it|the line)] pulls {amount} [than before]", "[it is] {amount} [than before]" },
  nearly = { "[(it|the line)] (pull|is pull) {amount}" },
  lists = { amount = { "more|harder|more strongly", "less|more weakly" } },
  right = function(a) return (kite.pull > before) == (a.amount == "more") end,
}

local function raise_the_wind(world)
  world:level(3, "More wind, more line")
  kite:show_forces(false)
  world:caption "Feel how hard the line pulls."
  wait(4)
  before = kite.pull
  world:wind_speed(strong)
  world:caption "The wind grows."
  wait(6)
  game.ask("pull", {
    hint = "First the wind was weak. Now it is strong.",
    again = function()
      world:wind_speed(breeze)
      wait(5)
      world:wind_speed(strong)
      wait(5)
    end,
    solution = "It pulls more: twice as fast, the wind pushes four times as hard.",
  })
  world:wind_speed(breeze)
  balloon:place { at = { kite.x + 3, long - 1.5, kite.z } }
  world:caption "Let the line out: turn the wheel, or press the first button. Fly as high as the balloon."
  if wait_until(function() return kite.altitude > long - 1.5 end, 60) then
    world:sound "pop"
    world:caption "You are there!"
    game.point()
  else
    game.miss()
  end
  balloon:hide()
  kite:reel(short)
  wait(3)
end

-- ---- why it comes down ------------------------------------------------------------------------------------------------------

L:question "why" {
  prompt = "Why does the kite come down?",
  again = "Look at lift and weight.",
  answers = {
    "[because] the {force} is <comparative:{size}> than the {other}",
    "[because] there is no {nothing}",
    "[because] it has no {nothing}",
    "no {nothing}",
  },
  nearly = { "[because] (have|has|is) no {nothing}", "[because] the {force} <comparative:{size}> than the {other}" },
  lists = { force = { "lift", "weight" }, other = { "lift", "weight" }, size = { "small", "big", "weak", "strong" },
            nothing = { "wind|air", "lift" } },
  right = function(a)
    if a.nothing == "wind" then return kite.wind < 1 end
    if a.nothing == "lift" then return kite.lift < kite.weight end
    local more = a.size == "big" or a.size == "strong"
    return a.force ~= a.other and (newtons(a.force) > newtons(a.other)) == more
  end,
}

local function stop_the_wind(world)
  world:level(4, "No wind")
  world:caption "And now the wind stops."
  kite:show_forces(true)
  world:wind_speed(0)
  wait_until(function() return kite.altitude < 3 end, 30)
  wait(1)
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
  kite:show_forces(false)
  world:wind_speed(breeze)
  kite:build { tail = 0, knot = 0.68, cloth = "ripstop" }
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
