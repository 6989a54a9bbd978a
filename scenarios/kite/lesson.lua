-- A kite that the pupil builds and flies: what holds it up, what pulls it back, what is felt in the hand.
--
-- The answer key is the simulated flight: whether a change was good is known when the kite has been flown with it, and which force
-- is the stronger is read from the air on its cloth, over seconds. Change the kite, its line or the wind below and the right
-- answers change.

local game = require "game"
local story, explain_line = require "story", require "line"
local wait, wait_until = story.wait, story.wait_until

local L = lesson { id = "kite", title = "Why does a kite fly?", level = "A2", minutes = 15, free_english = true }

local breeze, strong = 4.5, 5.8     -- metres a second, 10 metres up; in the strong wind the line still pulls less than 4.5 N
local most_in_breeze = 2.8          -- newtons in the hand
local short, long, longest = 12, 17, 18   -- metres of line
local lowest_knot, good_knot, highest_knot = 0.56, 0.68, 0.85   -- metres from the foot
local kite, balloon

function L:start(world)
  world:ground(0)
  world:camera { eye = { 3, 1.7, 22 }, target = { 3.6, 10.2, 0 }, angle = 60 }
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

local function say(world, words, seconds)
  world:caption(words)
  wait(seconds)
end

-- ---- what the air does, over seconds ----------------------------------------------------------------------------------------

local felt_over = 1.5   -- seconds
local measured = { "lift", "drag", "weight", "pull", "wind" }

-- Means over the last seconds in which it flew, in which it stood still in the air, and in which it lay on the ground: a hand that
-- shakes changes none of them much. A kite that flies is held up by its lift; on the ground the air's force may point anywhere.
local flown, still, lain = {}, {}, {}

local function take_into(mean, dt)
  for _, name in ipairs(measured) do
    mean[name] = mean[name] and mean[name] + math.min(dt / felt_over, 1) * (kite[name] - mean[name]) or kite[name]
  end
end

local function flies() return kite.altitude > 0.5 * kite.line and not kite.snapped end
local function lies() return kite.altitude < 0.5 and kite.speed < 0.2 end
require "asked" (L, function() return kite end)
local stays, may_reel = false, false   -- stays: it is launched again whenever it has come down
local down, quiet = 0, 0               -- seconds

function L:update(_, dt)
  if flies() then
    take_into(flown, dt)
    quiet = kite.speed < 0.5 and quiet + dt or 0
    if quiet > 1 then take_into(still, dt) end
    down = 0
  else
    down = down + dt
    if lies() then take_into(lain, dt) end
  end
  if stays and down > 4 then kite:fly() down = 0 end
  local most = may_reel and longest or short
  if kite.line > most + 0.2 then kite:reel(most) end
end

local function give_tail(world)
  world:caption "I give it a tail of two metres."
  kite:build { tail = 2, knot = good_knot, cloth = "nylon" }
  wait(10)
end

-- Waits until it flies, and has flown as long as is measured over. One that does not gets what it lacks.
local function fly_again(world)
  wait_until(flies, 12)
  wait(2 * felt_over)
  if not flies() then give_tail(world) end
end

-- Flies it for some seconds, and gives whether it stayed up.
local function stays_up(world, seconds)
  kite:fly()
  explain_line(world, kite)
  wait(seconds)
  local up = true
  wait_until(function() up = up and flies() end, 3)
  return up
end

-- ---- building ---------------------------------------------------------------------------------------------------------------

-- What is said of a part, and what becomes of it; nil when it cannot be changed that way any further.
local function change_of(answer)
  local size = answer.size or answer.tail_size
  if answer.part then return {}, answer.part end
  if size or answer.missing then
    local tail = math.max(0, math.min(kite.tail + (size == "shorter" and -1 or 2), 8))
    return { tail = tail ~= kite.tail and tail or nil }, "tail"
  elseif answer.way then
    local knot = math.max(lowest_knot, math.min(kite.knot + (answer.way == "up" and 0.06 or -0.06), highest_knot))
    return { knot = math.abs(knot - kite.knot) > 0.001 and knot or nil }, "knot"
  end
  local cloth = answer.cloth or (answer.weight == "lighter" and "silk" or "paper")
  return { cloth = cloth ~= kite.cloth and cloth or nil }, "cloth"
end

local who, it = "[(I|we|you)] [(must|should|can|have to|want to|would)] ", "(it|the kite) "

L:question "change" {
  prompt = "How do you want to change the tail, the knot or the cloth?", again = "Say something else.",
  answers = {
    who .. "make the tail {size}", it .. "needs a {tail_size} tail", it .. "needs a {missing}",
    "(I|we) (need|want) a {tail_size} tail", "(I|we) (need|want) a {missing}", it .. "(must|should|has to) have a {tail_size} tail",
    it .. "(must|should|has to) have a {missing}", it .. "has no {missing}", "there is no {missing}",
    "the tail (must|should|has to) be {size}", who .. "(move|put|push|tie) the knot {way}", who .. "make the cloth {weight}",
    "the cloth (must|should|has to) be {weight}", it .. "needs a {weight} cloth", who .. "(use|take) a {weight} cloth",
    who .. "(use|take) {cloth}", who .. "(add|give it|give the kite|put on|put|make|use) a {tail_size} tail",
    who .. "(add|give it|give the kite|put on|put|make|use) a {missing}", "a {tail_size} tail", "a {weight} cloth", "a {missing}", who .. "change the {part}", "the {part}",
  },
  nearly = {
    "make tail {size}", "tail {size}", "more {tail_size} tail", "{tail_size} tail", "{missing}", "the {missing}",
    it .. "must has [a] {missing}", "need [a] {missing}", "needs [a] {missing}", "add {missing}", "tail must be {size}",
    "(I|we) must to (add|make|use) [a] {missing}", "knot {way}", "{weight} cloth", "make cloth {weight}",
  },
  lists = {
    size = { "longer|long|bigger", "shorter|short|smaller" }, tail_size = { "longer|long|bigger", "shorter|short|smaller" },
    missing = { "tail|kite tail" }, part = { "knot", "cloth" }, way = { "up|higher|further up", "down|lower|further down" },
    weight = { "lighter|light", "heavier|heavy" }, cloth = { "silk", "paper", "plastic", "nylon" },
  },
  -- Anything may be tried that can be done: the flight is the judge.
  right = function(a) return next((change_of(a))) ~= nil end,
}

local tried = {
  tail = "The tail holds the kite's foot back, so that its nose points into the wind.",
  knot = "The knot says how steeply the kite stands in the wind.",
  cloth = "The cloth makes it lighter or heavier.",
}

local which_way = { knot = "Up or down?", cloth = "Lighter or heavier?" }

-- Asks what to change until it is something that can be done, and does it; gives which part it was.
local function change_it(world)
  local answer, change, part
  repeat
    answer = story.ask(world, "change")
    change, part = change_of(answer)
    if answer.understood and not answer.right and not answer.over then
      wait(2)
      say(world, answer.part and which_way[part] or part == "tail" and kite.tail == 0 and "It has no tail yet." or "That is as far as it goes.", 2.5)
    end
  until answer.over
  wait(2.5)
  if answer.right then
    world:caption "Let's try it."
  elseif kite.tail < 2 then
    world:caption "Let's try a tail."
    change, part = { tail = 2 }, "tail"
  else
    world:caption "Let's tie the knot where it was, with the first cloth."
    change, part = { knot = good_knot, cloth = "nylon" }, "knot"
  end
  wait(1.5)
  kite:build(change)
  world:caption(tried[part])
end

-- Until it flies; three points at the first change, one less for each more.
local function build_one_that_flies(world)
  world:level(1, "Build a kite")
  world:caption "This kite has no tail. Let's see if it flies."
  local points = 3
  if stays_up(world, 9) then
    kite:build { tail = 2 }
    say(world, "You pull so well that it flies! Now I give it a tail.", 4)
    game.point(points)
    return
  end
  for _ = 1, 5 do
    say(world, "It came down.", 2)
    change_it(world)
    if stays_up(world, 12) then
      world:sound "pop"
      say(world, "It flies!", 2.5)
      game.point(points)
      if points < 3 then game.miss(3 - points) end
      -- The hand is to feel more of it in more wind.
      if still.pull and still.pull > most_in_breeze then
        kite:build { knot = good_knot }
        say(world, "It pulls very hard. I tie the knot where it was.", 3)
        fly_again(world)
      end
      return
    end
    points = math.max(points - 1, 1)
  end
  give_tail(world)
  game.miss(3)
end

-- ---- four forces ------------------------------------------------------------------------------------------------------------

L:question "up" {
  prompt = "Which force holds the kite up?", again = "Look at the arrows.",
  answers = { "the {force} holds (it|the kite) up", "the {force} (pulls|pushes|keeps) (it|the kite) up",
              "the {force} lifts (it|the kite) [up]", "it is the {force}", "the {force}" }, examples = { right = { "The lift pulls it up.", "The lift pushes it up." } },
  nearly = { "[the] {force} (hold|holds|is hold|is holding|keep|lift) [(it|the kite)] up",
             "[the] {force} (pull|push) [(it|the kite)] up", "[the] {force} it (hold|holds) [(it|the kite)] [up]", "{force}", "it is {force}" },
  lists = { force = { "lift|lift force", "drag|drag force", "weight|gravity", "tension|tension force" } },
  -- It flew, and so what pointed up was the air's force across the wind, as long as it was more than the weight.
  right = function(a) return a.force == "lift" and flown.lift > flown.weight end,
}

L:question "hand" {
  prompt = "Which force do you feel in your hand?", again = "Look at the line, and feel it.",
  answers = { "(I|we) [can] feel the {force} [of the line]", "it is the {force} [of the line]", "the {force} [of the line]" },
  nearly = { "(I|we) (am feel|am feeling|feels|feeling) [the] {force}", "(I|we) feel {force}", "it is {force}", "{force}" },
  lists = { force = { "lift|lift force", "drag|drag force", "weight|gravity", "tension|pull|tension force|force of the line" } },
  right = function(a) return a.force == "tension" and flown.pull > 0 end,   -- of the four the line's alone acts on the hand
}

L:question "stronger" {
  prompt = "Which force is stronger: the lift or the drag?", again = "Read the newtons.",
  answers = { "the {force} is <comparative:strong> [than the {other}]", "the {force} is <comparative:big> [than the {other}]",
              "it is the {force}", "the {force}" },
  nearly = { "[the] {force} (are|be) <comparative:strong>", "it is {force}", "{force}" },
  lists = { force = { "lift", "drag" }, other = { "lift", "drag" } },
  right = function(a) return a.force ~= a.other and (flown.lift > flown.drag) == (a.force == "lift") end,
}

local function show_forces(world)
  stays = true
  world:level(2, "Four forces")
  kite:show_forces(true)
  say(world, "The air pushes the kite up: that is lift. It pushes it along: that is drag.", 5)
  say(world, "The Earth pulls it down: that is its weight. The line holds it: that is tension.", 5)
  fly_again(world)
  local look = { hint = "Look at the four arrows.", solution = "The lift holds the kite up.", again = function() fly_again(world) end }
  game.ask("up", look)
  look.solution = "You feel the tension of the line."
  game.ask("hand", look)
  look.hint = "How many newtons does the lift have, and how many does the drag have?"
  look.solution = function()
    return flown.lift > flown.drag and "The lift is stronger than the drag." or "The drag is stronger than the lift."
  end
  game.ask("stronger", look)
end

-- ---- wind and line ----------------------------------------------------------------------------------------------------------

local before      -- newtons in the hand and the wind, in the breeze

-- What a still hand felt, before and now; the pull on one that swings is its own, and there the wind says what it does to the line.
local function pulls_more()
  if before.pull and still.pull then return still.pull > before.pull end
  return flown.wind > before.wind
end

-- What is felt now.
local function feel(world)
  still = {}
  fly_again(world)
  if not still.pull then
    world:caption "Hold your hand still, and feel the line."
    wait_until(function() return still.pull end, 5)
    wait(felt_over)
  end
  return { pull = still.pull, wind = flown.wind }
end

L:question "pull" {
  prompt = "Now the wind is stronger. Does the line pull more or less?", again = "Feel the line again.", feedback = { "replay", "prompt", "rule" },
  answers = { "(it|the line) pulls {amount} [than before]", "(it|the pull|the tension) is <comparative:strong> [than before]",
              "(it|the pull|the tension) is {size} [than before]", "<comparative:strong> [than before]", "{size} [than before]", "{amount} [than before]" },
  nearly = { "(it|the line|they) (pull|is pull) {amount}", "(it|the line|they) (pull|pulls|is pull) {size}", "(it|the line|they) (pull|pulls|is pull) more strong",
             "(it|the pull|the tension) is {amount} [than before]" },
  lists = { amount = { "more|harder|more strongly", "less|more weakly" }, size = { "bigger|greater", "weaker|smaller" } },
  right = function(a) return pulls_more() == (a.amount ~= "less" and a.size ~= "weaker") end,
}

local function from_breeze_to_strong(world)
  if kite.wind > 1.1 * before.wind then world:wind_speed(breeze) wait(5) end
  world:wind_speed(strong)
  wait(3)
  feel(world)
end

local function raise_the_wind(world)
  world:level(3, "More wind, more line")
  kite:show_forces(false)
  say(world, "Feel how hard the line pulls.", 1)
  before = feel(world)
  world:caption "The wind grows."
  from_breeze_to_strong(world)
  game.ask("pull", {
    hint = "First the wind was weak. Now it is strong.",
    again = function() from_breeze_to_strong(world) end,
    solution = function()
      return pulls_more() and "It pulls more: a little more wind, and the line pulls much harder." or "It pulls less."
    end,
  })
  world:wind_speed(breeze)
  fly_again(world)
  balloon:place { at = { kite.x + 3, long - 1.5, kite.z } }
  world:caption "Let the line out: turn the wheel, or press the first button. Fly as high as the balloon."
  may_reel = true
  if wait_until(function() return kite.altitude > long - 1.5 end, 60) then
    world:sound "pop"
    say(world, "You are there!", 2)
    game.point()
  else
    game.miss()
  end
  balloon:hide()
end

-- ---- why it comes down ------------------------------------------------------------------------------------------------------

L:question "why" {
  prompt = "Why did the kite come down?", again = "Look at lift and weight.",
  answers = {
    "[because] the {force} is <comparative:{size}> than the {other}", "[because] the {force} was <comparative:{size}> than the {other}",
    "[because] there (is|was) no {nothing}", "[because] there (isn't|is not|wasn't|was not) any {nothing}",
    "[because] (it|the kite) (has|had) no {nothing}", "[because] (it|the kite) (doesn't|didn't) have [any] {nothing}",
    "[because] the {nothing} (stopped|has stopped|is gone)", "[because] the {nothing} (is|was) too weak",
    "[because] without {nothing} (it|the kite) (can't|cannot|doesn't) fly", "no {nothing}",
  },
  nearly = {
    "[because] (have|has|is) no {nothing}", "[because] the {force} <comparative:{size}> than the {other}", "because no {nothing}",
    "[because] there (is|was) not {nothing}", "[because] (it|the kite) (don't|doesn't|didn't) (has|had) [any] {nothing}",
    "[because] {nothing} (stopped|stop|is stop|has stopped)", "[because] the {nothing} (stop|is stop)",
  },
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
  say(world, "With wind it flies again.", 4)
end

function play(world)
  stays, may_reel = false, false
  kite:show_forces(false)
  world:wind_speed(breeze)
  kite:build { tail = 0, knot = good_knot, cloth = "nylon" }
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
