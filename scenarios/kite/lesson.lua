-- A kite that the pupil builds and flies: what holds it up, what pulls it back, what is felt in the hand.
--
-- The answer key is the simulated flight: whether a change was good is known when the kite has been flown with it, and which force
-- is the stronger is read from the air on its cloth, over seconds. Change the kite, its line or the wind below and the right
-- answers change.

local game = require "game"
local story, explain_line, answers = require "story", require "line", require "answers"
local wait, wait_until = story.wait, story.wait_until

local L = lesson { id = "kite", title = "Why does a kite fly?", icon = "kite", order = 5, level = "A2", minutes = 15, free_english = true }

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

-- Asks what is answered as answers.lua has it.
local function question(name, asked)
  for field, value in pairs(answers[name]) do asked[field] = value end
  L:question(name)(asked)
end

-- ---- building ---------------------------------------------------------------------------------------------------------------

-- What becomes of a part of which that is said; nil when it cannot be changed that way any further.
local function change_of(answer)
  local part, wanted = answers.wanted(answer)
  if not wanted then return {}, part end
  if part == "tail" then
    local tail = math.max(0, math.min(kite.tail + (wanted == "shorter" and -1 or 2), 8))
    return { tail = tail ~= kite.tail and tail or nil }, part
  elseif part == "knot" then
    local knot = math.max(lowest_knot, math.min(kite.knot + (wanted == "up" and 0.06 or -0.06), highest_knot))
    return { knot = math.abs(knot - kite.knot) > 0.001 and knot or nil }, part
  end
  return { cloth = wanted ~= kite.cloth and wanted or nil }, part
end

-- Anything may be tried that can be done: the flight is the judge.
question("change", {
  prompt = "How do you want to change the tail, the knot or the cloth?", again = "Say something else.",
  right = function(a) return next((change_of(a))) ~= nil end,
})

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
      say(world, answer.part and which_way[part] or part == nil and "We can change the tail, the knot or the cloth."
        or part == "tail" and kite.tail == 0 and "It has no tail yet." or "That is as far as it goes.", 2.5)
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

question("up", {
  prompt = "Which force holds the kite up?", again = "Look at the arrows.",
  -- It flew, and so what pointed up was the air's force across the wind, as long as it was more than the weight.
  right = function(a) return not (a.down or a.no_force) and a.force == "lift" and flown.lift > flown.weight end,
})

question("hand", {
  prompt = "Which force do you feel in your hand?", again = "Look at the line, and feel it.",
  right = function(a) return not a.no_force and (a.force or "tension") == "tension" and flown.pull > 0 end,   -- of the four the line's alone acts on the hand
})

question("stronger", {
  prompt = "Which force is stronger: the lift or the drag?", again = "Read the newtons.",
  right = function(a) return not a.same and a.force ~= a.other and (flown.lift > flown.drag) == (a.force == "lift") end,
})

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

question("pull", {
  prompt = "Now the wind is stronger. Does the line pull more or less?", again = "Feel the line again.", feedback = { "replay", "prompt", "rule" },
  right = function(a)
    local less = a.amount == "less" or a.size == "weaker" or a.with == "less force" or a.stronger == "smaller"
    return not (a.same or a.denied or a.difference) and pulls_more() == not less
  end,
})

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

question("why", {
  prompt = "Why did the kite come down?", again = "Look at lift and weight.",
  -- It lies: what the air did to it there.
  right = function(a)
    local calm, heavy = lain.wind < 1, lain.lift < lain.weight
    if a.burden then return heavy and a.burden == "heavy" end   -- its weight is more than the lift
    if a.enough then return calm end
    if a.size and not (a.force or a.part) then return calm and (a.size == "weak" or a.size == "small") end
    if a.lift and (a.lift ~= "lift" or a.nothing ~= "wind") then return false end   -- "there is no wind without lift"
    if a.part == "lift" and (a.size == "small" or a.size == "weak") then return heavy end
    if a.part == "weight" and (a.size == "big" or a.size == "strong" or a.size == "great") then return heavy end
    if a.part == "kite" and a.much == "heavy" then return heavy end
    if a.part or a.blame or a.plenty or a.blowing or a.body or a.much then return false end
    if a.nothing == "wind" or a.gone then return calm end
    if a.nothing == "lift" or a.pull or not a.force then return heavy end   -- "it is heavier than the lift", "nothing holds it up"
    local more = a.size == "big" or a.size == "strong" or a.size == "great" or a.amount == "more"
    local other = a.other or (a.force == "lift" and "weight" or "lift")
    return a.force ~= other and (lain[a.force] > lain[other]) == more
  end,
})

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
