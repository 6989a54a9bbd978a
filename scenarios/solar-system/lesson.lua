-- The Sun and its eight planets: where they are today, what is known of them, and how hard it is to turn one.
--
-- The answer keys are the planets' facts (scripts/lib/planets.lua) and the simulation: which push turns more follows from the
-- lever arms that the hand had, which planet is harder to turn from the inertia that it felt.

local game = require "game"
local planets = require "planets"
local story = require "story"
local wait, wait_until = story.wait, story.wait_until

local L = lesson { id = "solar-system", title = "Can you turn a planet?", level = "A2", minutes = 15 }

local middle = { 0, 0.36, 0 }      -- of the Sun
local near = { 0, 0.5, 0.3 }      -- where a planet is looked at and turned

local sun, star
local small = {}     -- name -> body: on its way round the Sun
local big = {}       -- name -> body: seen from near, and turned by the hand

-- Nothing here has its true size or distance: Neptune would be 4500 times as far from the Sun as the Sun is wide.
local function way_of(place) return 0.06 + 0.088 * place end
local function small_radius(name)
  return 0.014 * (planets.facts(name).radius / planets.facts("Earth").radius) ^ 0.45
end
local function big_radius(name)
  return 0.08 + 0.08 * (planets.facts(name).radius / planets.facts("Earth").radius) ^ (1 / 3)
end
-- Kilogram square metres in the hand; the Earth's true 8e37 no hand would move.
local function felt_inertia(name)
  return 0.02 * (planets.facts(name).mass / planets.facts("Earth").mass) ^ 0.25
end

function L:start(world)
  world:ground(0)
  world:camera { eye = { 0, 1.15, 1.5 }, target = { 0, 0.42, 0 }, angle = 38 }
  world:hand { centre = { 0, 0.5, 0.5 }, scale = 3 }
  -- Rough enough to take a planet along, and felt as it passes.
  local ground = world:material {
    name = "planet", stiffness = 700, damping = 2, friction = 1.2, sliding_friction = 1.0,
    texture = { bumps = 0.006, height = 0.0002 },
  }
  sun = world:body { name = "sun", noun = "Sun", model = "sun", radius = 0.05, movable = true, visible = true, at = middle }
  for _, name in ipairs(planets.names) do
    local model = name:lower()
    small[name] = world:body { name = model .. "-far", noun = name, model = model, radius = small_radius(name), movable = true }
    big[name] = world:body {
      name = model, noun = name, model = model, radius = big_radius(name), solid = true, material = ground, at = near,
      hinge = { axis = { 0, 1, 0 }, inertia = felt_inertia(name), friction = 0.004 },
    }
    big[name]:hide()
  end
  star = world:body { name = "star", model = "star", radius = 0.03 }
  game.play(L, world, function() play(world) end)
end

-- ---- the sky ------------------------------------------------------------------------------------------------------------

local shown_day      -- nil: the planets are not seen from far

local function place_planets(day)
  for i, name in ipairs(planets.names) do
    local angle = math.rad(planets.longitude(name, day))
    small[name]:place { at = { middle[1] + way_of(i) * math.cos(angle), middle[2], middle[3] - way_of(i) * math.sin(angle) } }
  end
end

local function show_sky(day)
  shown_day = day
  sun:place { at = middle }
  place_planets(day)
end

local function hide_sky()
  shown_day = nil
  sun:hide()
  for _, body in pairs(small) do body:hide() end
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
local function look_at(name)
  if shown then big[shown]:hide() end
  shown = name
  if name then big[name]:place { at = near } end
end

-- ---- what the hand does ---------------------------------------------------------------------------------------------------

local best_arm = {}   -- place -> the longest lever arm with which it was pushed

-- Waits until the planet has been turned by so many degrees by pushes at a place; the star shows where.
local function turn(place, at, degrees)
  local body = big[shown]
  star:place { at = at }
  best_arm[place] = 0
  local turned, last = 0, body.angle
  wait_until(function()
    if body.arm > 0 and math.abs(body.torque) > 0.002 then
      best_arm[place] = math.max(best_arm[place], body.arm)
      turned = turned + math.abs(body.angle - last)
    end
    last = body.angle
    return turned >= degrees
  end)
  star:hide()
  body:turn { spin = 0 }
end

local function at_the_side() return { near[1], near[2], near[3] + big_radius(shown) + 0.03 } end
local function near_the_pole()
  local r = big_radius(shown) + 0.03
  return { near[1], near[2] + r * math.cos(0.35), near[3] + r * math.sin(0.35) }
end

-- ---- questions ------------------------------------------------------------------------------------------------------------

local count = { "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten" }
local numbers = {}
for i, word in ipairs(count) do numbers[i] = word .. "|" .. i end
local function number_of(word)
  for i, known in ipairs(count) do
    if known == word then return i end
  end
  return word == "no" and 0 or tonumber(word)
end

L:question "planets" {
  prompt = "How many planets go round the Sun?",
  again = "Let's count them.",
  answers = { "[there are] {number} [<plural:planet>] [go round the Sun]" },
  lists = { number = numbers },
  right = function(a) return number_of(a.number) == #planets.names end,
}

for _, name in ipairs { "Earth", "Mars" } do
  local called = name == "Earth" and "the Earth" or name
  L:question("moons_" .. name:lower()) {
    prompt = "How many moons does " .. called .. " have?",
    again = "Let's look again.",
    answers = { "[(it|the Earth|Mars) has] {number} [(moon|moons)]" },
    lists = { number = numbers },
    right = function(a) return number_of(a.number) == planets.facts(name).moons end,
  }
end

local asked_about = {}
for i, name in ipairs(planets.names) do asked_about[i] = name == "Earth" and "Earth|the Earth" or name end

L:question "your_turn" {
  prompt = "Now you ask me about a planet! For example: How many moons does Jupiter have?",
  again = "Ask about another planet.",
  answers = { "how many moons does {planet} {own}", "how many moons has {planet} got" },
  lists = { planet = asked_about, own = { "have" } },   -- after "does" it never agrees: no word of the template
  right = function(a) return planets.facts(a.planet) ~= nil end,
}

L:question "side_or_pole" {
  prompt = "Where does the same push turn it more: at the side or near the pole?",
  again = "Let's push again.",
  answers = { "[it turns more] (at|near|on) [the] {place} [it turns more]", "[the] {place}" },
  lists = { place = { "side|rim|equator", "pole" } },
  right = function(a) return best_arm[a.place] > best_arm[a.place == "side" and "pole" or "side"] end,
}

L:question "harder" {
  prompt = "Which one is harder to turn: the Earth or Jupiter?",
  again = "Let's feel it again.",
  answers = { "[the] {planet} is <comparative:hard> [to turn] [than [the] {other}]", "[the] {planet} [is]" },
  lists = { planet = { "Earth", "Jupiter" }, other = { "Earth", "Jupiter" } },
  right = function(a)
    local other = a.planet == "Earth" and "Jupiter" or "Earth"
    return big[a.planet].inertia > big[other].inertia and (a.other == nil or a.other == other)
  end,
}

-- ---- the lesson -----------------------------------------------------------------------------------------------------------

local function moons_of(name)
  local moons = planets.facts(name).moons
  if moons == 0 then return "no moons" end
  return (count[moons] or tostring(moons)) .. (moons == 1 and " moon" or " moons")
end
local function called(name) return name == "Earth" and "The Earth" or name end

local function sky(world)
  world:level(1, "Today's sky")
  look_at(nil)
  show_sky(world.day)
  world:caption "The Sun and its planets, as they stand today. Sizes and distances are not true here: space is too big."
  wait(5)
  world:caption "A year goes by: the Earth goes round once. The far planets are slow."
  let_go_by(planets.facts("Earth").year, 8)
  game.ask("planets", { hint = "Count them: Mercury, Venus, Earth, Mars …" })
end

local function closer(world)
  world:level(2, "A closer look")
  hide_sky()
  look_at "Earth"
  big.Earth:turn { spin = 25 }
  world:caption("This is the Earth. It turns once a day. It has " .. moons_of "Earth" .. ".")
  wait(4)
  game.ask("moons_earth", { hint = "You see it at night. There is only one." })
  look_at "Mars"
  big.Mars:turn { spin = 25 }
  world:caption("This is Mars, the red planet. It has " .. moons_of "Mars" .. ", and both are small.")
  wait(4)
  game.ask("moons_mars", { hint = "They are called Phobos and Deimos." })
  local asked = game.ask("your_turn", { hint = "Say: How many moons does Saturn have?" })
  if asked.planet then
    look_at(asked.planet)
    big[asked.planet]:turn { spin = 25 }
    local found = planets.facts(asked.planet).moons > 2 and ", found by " .. planets.moons_counted or ""
    world:caption(called(asked.planet) .. " has " .. moons_of(asked.planet) .. found .. ".")
    wait(4)
  end
end

local function push_at_side(world)
  world:caption "Push the side under the star: press, and go left or right."
  turn("side", at_the_side(), 40)
end

local function push_at_pole(world)
  world:caption "Now push near the pole: under the star, where the axis comes out."
  turn("pole", near_the_pole(), 15)
end

local function turning(world)
  world:level(3, "Turn a planet")
  look_at "Earth"
  big.Earth:turn { spin = 0 }
  push_at_side(world)
  world:caption "The blue bar is the arm. Force times arm is the torque: it turns the planet."
  wait(3)
  push_at_pole(world)
  world:caption "Near the pole the arm is short, so the torque is small."
  wait(2.5)
  game.ask("side_or_pole", {
    hint = "Look at the blue bar: where is it longer?",
    again = function()
      push_at_side(world)
      push_at_pole(world)
    end,
  })
  look_at "Jupiter"
  world:caption "This is Jupiter. No hand can turn a true planet: we made the Earth easy to turn, and Jupiter too, but less easy."
  wait(3)
  push_at_side(world)
  game.ask("harder", {
    hint = "Jupiter has 318 times the mass of the Earth.",
    again = function() push_at_side(world) end,
  })
end

function play(world)
  sky(world)
  closer(world)
  turning(world)
  look_at(nil)
end

L:test {
  hand = "turner.lua",
  say = { "eight planets", "one moon", "it has two moons", "how many moons does Saturn have", "at the side",
          "Jupiter is harder to turn" },
  expect = { finished = true, stars = 3, form_errors = 0 },
}

return L
