-- The Sun and its eight planets: where they are today, what is known of them, and how hard it is to turn one.
--
-- The answer keys are the planets' facts (scripts/lib/planets.lua) and the simulation: which push turns more follows from the
-- lever arms that the hand had, which planet is harder to turn from the inertia that it felt.

local about = require "about"
local answers = require "answers"
local choose = require "choose"
local game = require "game"
local know = require "know"
local known = require "known"
local numbers = require "numbers"
local planets = require "planets"
local story = require "story"
local wait, wait_until, wait_with_help = story.wait, story.wait_until, story.wait_with_help

local L = lesson { id = "solar-system", title = "Can you turn a planet?", icon = "saturn", order = 3, level = "A2", minutes = 15, free_english = true }

local middle = { 0, 0.37, -0.25 }  -- of the Sun; so far back that all ways stand above what is written
local eye = { 0, 1.15, 1.5 }
local near = { 0, 0.5, 0.3 }      -- where a planet is turned
local visited = { 0, 0.45, -1.1 }  -- where it is looked at: behind any hand that has chosen it
local aside = { -0.56, 0.5, 0.3 }  -- where the Earth stands that it is compared with

local sun, star
local small = {}     -- name -> body: on its way round the Sun
local ways = {}      -- name -> body: the line along which it goes
local big = {}       -- name -> body: seen from near, and turned by the hand
local earth_aside    -- seen beside it
local moon, small_moon   -- from near, and on its way

-- Nothing here has its true size or distance: Neptune would be 3200 times as far from the Sun as the Sun is wide.
local function way_of(place) return 0.06 + 0.095 * place end
local function small_radius(name)
  return 0.014 * (known.facts(name).radius / planets.facts("Earth").radius) ^ 0.45
end
local function big_radius(name)
  return 0.08 + 0.08 * (planets.facts(name).radius / planets.facts("Earth").radius) ^ (1 / 3)
end
-- Kilogram square metres in the hand; the Earth's true 8e37 no hand would move.
local function felt_inertia(name)
  return 0.02 * (planets.facts(name).mass / planets.facts("Earth").mass) ^ 0.25
end

function L:start(world)
  world:space()
  world:camera { eye = eye, target = { 0, 0.42, 0 }, angle = 38 }
  world:hand { centre = { 0, 0.5, 0.5 }, scale = 3 }
  -- Rough enough to take a planet along, and felt as it passes.
  local ground = world:material {
    name = "planet", stiffness = 700, damping = 2, friction = 1.2, sliding_friction = 1.0,
    texture = { bumps = 0.006, height = 0.0002 },
  }
  sun = world:body { name = "sun", noun = "Sun", model = "sun", radius = 0.05, movable = true, visible = true, at = middle }
  for i, name in ipairs(planets.names) do
    local model = name:lower()
    ways[name] = world:body { name = model .. "-way", model = "orbit", radius = way_of(i), visible = true, at = middle }
    small[name] = world:body { name = model .. "-far", noun = name, model = model, radius = small_radius(name), movable = true }
    big[name] = world:body {
      name = model, noun = name, model = model, radius = big_radius(name), solid = true, material = ground, at = near,
      hinge = { axis = { 0, 1, 0 }, inertia = felt_inertia(name), friction = 0.004 }, about = about[name].touched,
    }
    big[name]:hide()
  end
  earth_aside = world:body { name = "earth-aside", noun = "Earth", model = "earth", radius = big_radius "Earth", movable = true }
  star = world:body { name = "star", model = "star", radius = 0.03 }
  -- As grey and full of craters as Mercury; beside the Earth as large as it is.
  local beside_earth = known.facts "Moon".radius / known.facts "Earth".radius
  moon = world:body { name = "moon", noun = "Moon", model = "mercury", radius = beside_earth * big_radius "Earth", movable = true }
  small_moon = world:body { name = "moon-far", noun = "Moon", model = "mercury", radius = small_radius "Moon", movable = true }
  game.play(L, world, function() play(world) end)
end

-- ---- the sky ------------------------------------------------------------------------------------------------------------

local shown_day      -- nil: the planets are not seen from far

local function round(at, way, degrees)
  local angle = math.rad(degrees)
  return { at[1] + way * math.cos(angle), at[2], at[3] - way * math.sin(angle) }
end

-- The Moon's mean longitude, at most 8 degrees from the true one: J. Meeus, "Astronomical algorithms", 1998, equation 47.1.
local function moon_longitude(day) return 218.3164477 + 481267.88123421 / 36525 * day end
local moon_way = 0.034

local function place_planets(day)
  for i, name in ipairs(planets.names) do
    local at = round(middle, way_of(i), planets.longitude(name, day))
    small[name]:place { at = at }
    if name == "Earth" then small_moon:place { at = round(at, moon_way, moon_longitude(day)) } end
  end
end

local function show_sky(day)
  shown_day = day
  sun:place { at = middle }
  for _, way in pairs(ways) do way:place { at = middle } end
  place_planets(day)
end

local function hide_sky()
  shown_day = nil
  sun:hide()
  for _, body in pairs(small) do body:hide() end
  small_moon:hide()
  for _, way in pairs(ways) do way:hide() end
end

-- Lets so many days go by in so many seconds.
local function let_go_by(days, seconds)
  local from, left = shown_day, seconds
  wait_until(function()
    left = left - 1 / 60
    place_planets(from + days * (1 - math.max(left, 0) / seconds))
    return left <= 0
  end)
  shown_day = from + days
end

local shown   -- the planet that is seen from near
local function look_at(name, at)
  if shown then big[shown]:hide() end
  shown = name
  if name then
    big[name]:place { at = at or near }
    big[name]:turn { spin = at and 25 or 0 }
  end
end

-- ---- what the hand does ---------------------------------------------------------------------------------------------------

local best_arm = {}   -- place -> the longest lever arm with which it was pushed

-- Does the hand push a planet near that place?
local function is_pushed(world, body, at)
  local tool = world:tool()
  local away = math.sqrt((tool.x - at[1]) ^ 2 + (tool.y - at[2]) ^ 2 + (tool.z - at[3]) ^ 2)
  return away < 0.13 and body.arm > 0 and math.abs(body.torque) > 0.002
end

-- Waits until the planet has been turned by so many degrees by pushes at a place; the star shows where. What there is to
-- explain is told while the hand still pushes, for only then its arm and force are drawn. Where nobody manages to, the planet is turned.
local function turn(world, place, at, degrees, explain)
  local body = big[shown]
  star:place { at = at }
  best_arm[place] = 0
  local turned, last = 0, body.angle
  local done = wait_with_help(world, function()
    if is_pushed(world, body, at) then
      best_arm[place] = math.max(best_arm[place], body.arm)
      turned = turned + math.abs(body.angle - last)
    end
    last = body.angle
    return turned >= degrees
  end, {
    hint = "Go to the star until you touch the planet. Press, and go slowly to the right.",
    show = { { at[1] - 0.1, at[2], at[3] + 0.05 }, { at[1] - 0.05, at[2], at[3] - 0.02 }, { at[1] + 0.1, at[2], at[3] - 0.02 } },
  })
  if not done then
    world:caption "Look: I turn it."
    best_arm[place] = math.sqrt(at[1] ^ 2 + (at[3] - near[3]) ^ 2)   -- as a hand there would have had
    body:turn { spin = degrees }
    wait(2)
  elseif explain then
    world:caption(explain)
    story.wait_while(function() return is_pushed(world, body, at) end, 4)
  end
  star:hide()
  wait(0.5)
  body:turn { spin = 0 }
end
local function at_the_side() return { near[1], near[2], near[3] + big_radius(shown) + 0.03 } end
local function near_the_pole()
  local r = big_radius(shown) + 0.03
  return { near[1], near[2] + r * math.cos(0.35), near[3] + r * math.sin(0.35) }
end

local tell, n_told = require "asked" (L, function() return shown end)
know.words(L, {
  "arm", "axis", "cloud", "dust", "inertia", "kilogram", "kilometre", "lever", "metre", "newton", "planet", "pole", "rust", "thick", "torque", "weigh", orbit = "An orbit is the way of a planet round its star.",
  ["solar system"] = "A solar system is a star with all that goes round it.",
})

-- ---- questions ------------------------------------------------------------------------------------------------------------

-- Asks what is answered as answers.lua has it.
local function question(name, asked, said)
  for field, value in pairs(said or answers[name]) do asked[field] = value end
  L:question(name)(asked)
end

question("planets", {
  prompt = "How many planets go round the Sun?", again = "Let's count them.",
  right = function(a) return numbers.value(a.number) == #planets.names end,
})

for _, name in ipairs { "Earth", "Mars" } do
  local called = name == "Earth" and "the Earth" or name
  question("moons_" .. name:lower(), {
    prompt = "How many moons does " .. called .. " have?", again = "Let's look again.",
    right = function(a)
      if a.many then return false end
      return (a.none and 0 or a.number and numbers.value(a.number) or 1) == planets.facts(name).moons
    end,
  }, answers.moons(name, called))
end

-- Whatever asked.lua knows is a right answer, too, and answered from there.
question("your_turn", {
  prompt = "Now you ask me about a planet! For example: How many moons does Jupiter have? Or: How big is Mars?",
  again = "Ask about another planet.",
  right = function(a) return planets.facts(a.planet) ~= nil end,
})

question("side_or_pole", {
  prompt = "Where does the same push turn it more: at the side or near the pole?",
  again = "Let's push again.", feedback = { "replay", "prompt", "rule" },
  right = function(a)
    if a.same or a.place and a.place == a.other then return false end
    local side = a.place == "side" or a.from == "far from" or a.arm == "longer"
    if a.less or a.harder or a.torque == "small" then side = not side end
    return side == (best_arm.side > best_arm.pole)
  end,
})

question("harder", {
  prompt = "Which one is harder to turn: the Earth or Jupiter?",
  again = "Let's feel it again.",
  right = function(a)
    local other = a.planet == "Earth" and "Jupiter" or "Earth"
    return not a.same and big[a.planet].inertia > big[other].inertia and (a.other == nil or a.other == other)
  end,
})

-- ---- the lesson -----------------------------------------------------------------------------------------------------------

local function moons_of(name)
  local moons = planets.facts(name).moons
  local found = moons > 20 and ", found by " .. planets.moons_counted or ""
  return (moons > 20 and moons or numbers.word(moons)) .. (moons == 1 and " moon" or " moons") .. found
end
local function called(name) return name == "Earth" and "the Earth" or name end
local function sentence(text) return text:sub(1, 1):upper() .. text:sub(2) .. "." end

-- What is told of a planet where asked.lua has not told it.
local function reply_to(asked, world)
  local about = { big = "size", far = "distance", heavy = "mass", day = "day", year = "year" }
  return tell(about[asked.distance and "far" or asked.quality or asked.time] or "moons", asked.planet, world)
end

local function light_all(how)
  for _, name in ipairs(planets.names) do small[name]:light(how) end
end

-- One after the other, from the Sun outwards.
local function count_planets()
  light_all "offered"
  for _, name in ipairs(planets.names) do
    small[name]:light "lit"
    wait(0.7)
  end
end

local function sky(world)
  world:level(1, "Today's sky")
  look_at(nil)
  show_sky(world.day)
  world:caption "The Sun and its planets, as they stand today. Sizes and distances are not true here: space is too big."
  wait(5)
  local half_year = planets.facts("Earth").year / 2
  world:caption "A year goes by: the Earth goes round once."
  let_go_by(half_year, 4)
  world:caption "The far planets are slow."
  let_go_by(half_year, 4)
  game.ask("planets", {
    hint = "Count them: they light up.",
    again = count_planets,
    solution = function() return "There are " .. numbers.word(#planets.names) .. " planets." end,
  })
  light_all "off"
end

local function visit(world, name)
  hide_sky()
  small[name]:light "lit"
  look_at(name, visited)
  if name == "Earth" then moon:place { at = { visited[1] + 0.3, visited[2] + 0.05, visited[3] } } end
  world:caption((about[name].seen:gsub("MOONS", moons_of(name))))
  wait(4)
  if name == "Earth" then
    game.ask("moons_earth", {
      hint = "You see it at night.",
      solution = function() return sentence("the Earth has " .. moons_of "Earth") end,
    })
    moon:hide()
  elseif name == "Mars" then
    game.ask("moons_mars", {
      hint = "They are called Phobos and Deimos.",
      solution = function() return sentence("Mars has " .. moons_of "Mars") end,
    })
  end
  look_at(nil)
  show_sky(world.day)
end

-- The learner chooses where to go next. Who does not choose is led to those that are asked about.
local function tour(world)
  show_sky(world.day)
  light_all "offered"
  local to_see, to_ask = { table.unpack(planets.names) }, { "Earth", "Mars" }
  local missed = false
  while #to_see > 0 do
    local offered = {}
    for i, name in ipairs(to_see) do offered[i] = small[name] end
    world:caption(#to_see == #planets.names and "Where do you want to go first? Go to a planet, and stay there."
      or "Where do you want to go next?")
    local chosen = choose.one(world, offered, {
      eye = eye, again = missed, hint = "Put your hand on a planet that has a line around it. Stay there.",
    })
    missed = not chosen
    local name = chosen and chosen.noun or to_ask[1]
    if not name then return end
    if missed then
      world:caption("Let's go to " .. called(name) .. ".")
      wait(2)
    end
    for _, names in ipairs { to_see, to_ask } do
      for i, each in ipairs(names) do
        if each == name then table.remove(names, i) break end
      end
    end
    visit(world, name)
  end
end

local function closer(world)
  world:level(2, "A closer look")
  tour(world)
  light_all "off"
  local before = n_told()
  local asked = game.ask("your_turn", { hint = "Say: How many moons does Saturn have?" })
  hide_sky()
  local planet = asked.planet
  if planet and big[planet] then look_at(planet, near) end
  if planet and n_told() == before then world:caption(reply_to(asked, world)) end
  wait(5)
end

local function push_at_side(world, explain)
  world:caption "Push the side under the star: press, and go left or right."
  turn(world, "side", at_the_side(), 40, explain)
end

local function push_at_pole(world, explain)
  world:caption "Now push near the pole: under the star, where the axis comes out."
  turn(world, "pole", near_the_pole(), 15, explain)
end

local function turning(world)
  world:level(3, "Turn a planet")
  look_at "Earth"
  push_at_side(world, "Push on! The blue bar is the arm. Force times arm is the torque: it turns the planet.")
  push_at_pole(world, "Push on! Near the pole the arm is short, so the torque is small.")
  game.ask("side_or_pole", {
    hint = "Look at the blue bar: where is it longer?",
    again = function()
      push_at_side(world)
      push_at_pole(world)
    end,
    solution = "It turns more at the side: the arm is longer there.",
  })
  look_at "Jupiter"
  world:caption "This is Jupiter. No hand can turn a true planet: we made the Earth easy to turn, and Jupiter too, but less easy."
  wait(3)
  push_at_side(world)
  earth_aside:place { at = aside }
  game.ask("harder", {
    hint = "Jupiter has 318 times the mass of the Earth.",
    again = function() push_at_side(world) end,
    solution = "Jupiter is harder to turn: it has more inertia.",
  })
  earth_aside:hide()
end

function play(world)
  sky(world)
  closer(world)
  turning(world)
  look_at(nil)
end

L:test {
  hand = "turner.lua",
  say = { "eight planets", "one moon", "it has two moons", "how many moons does Saturn have",
          "I think it turns more faster there", "at the side", "Jupiter is harder to turn" },
  expect = { finished = true, stars = 3, form_errors = 1 },   -- in a sentence of the pupil's own
}

return L
