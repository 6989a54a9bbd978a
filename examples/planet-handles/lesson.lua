-- A stick turns planets by their handles: first the Earth, then Jupiter, which is harder to turn. The answer key is the inertia
-- that the hand felt.
--
-- Another word for `method` below is another way to keep the stick outside things: "field_sampling", "voxel_sampling",
-- "implicit_penalty" or "god_object". With implicit_penalty, `contact` may be "levels": then contact is found among triangles, by levels of
-- detail, instead of points in fields. `./fulcrum explain examples/planet-handles --analyze` tells what each costs here.

local game = require "game"
local planets = require "planets"
local story = require "story"
local wait, wait_until = story.wait, story.wait_until

local method, contact = "field_sampling", nil

local L = lesson { id = "planet-handles", title = "Turn a planet by its handles", level = "A2", minutes = 4 }

local radius = 0.12           -- of each planet, metres: it is the inertia that differs
local place = { 0, 0.35, 0 }
local names = { "Earth", "Jupiter" }
local planet, handles = {}, {}
local shown                   -- the one that is there

-- The fourth root of its mass: Jupiter's true inertia no hand would move.
local function felt_inertia(name)
  return 0.01 * (planets.facts(name).mass / planets.facts("Earth").mass) ^ 0.25
end

function L:start(world)
  world:space()
  world:camera { eye = { 0, 0.85, 1 }, target = { 0, 0.35, 0 }, angle = 38 }
  world:hand { centre = { 0, 0.42, 0.2 }, scale = 2.5, tool = { shape = "capsule", radius = 0.015, length = 0.12, method = method, contact = contact } }
  world:body { name = "sun", noun = "Sun", model = "sun", radius = 0.25, movable = true, visible = true, at = { -1.1, 0.7, -1.6 } }
  for _, name in ipairs(names) do
    local hinge = { axis = { 0, 1, 0 }, inertia = felt_inertia(name), friction = 0.004 }
    planet[name] = world:body { name = name:lower(), noun = name, model = name:lower(), radius = radius, solid = true, at = place, hinge = hinge }
    handles[name] = world:body { name = name:lower() .. "-handles", noun = "handle", model = "handles", solid = true, at = place, hinge = hinge }
    planet[name]:hide()
    handles[name]:hide()
  end
  game.play(L, world, function() play(world) end)
end

local function show(name)
  if shown then
    planet[shown]:hide()
    handles[shown]:hide()
  end
  shown = name
  planet[name]:place { at = place }
  handles[name]:place { at = place }
end

-- Until the stick has turned it so far. The planet goes with its handles: a stick slides on a ball and does not turn it.
local function push(name, degrees)
  local body = handles[name]
  local from = body.angle
  wait_until(function()
    planet[name]:turn { spin = 10 * (body.angle - planet[name].angle) }
    return math.abs(body.angle - from) >= degrees
  end)
end

L:question "harder" {
  prompt = "Which one is harder to turn: the Earth or Jupiter?",
  again = "Push Jupiter again, and feel it.",
  answers = {
    "[the] {planet} is <comparative:hard> [to turn] [than [the] {other}]",
    "it is <comparative:hard> to turn [the] {planet} [than [the] {other}]",
    "[it is] [the] {planet}",
  },
  nearly = { "[the] {planet} (is|is more) hard [to turn] [than [the] {other}]" },
  lists = { planet = { "Earth", "Jupiter" }, other = { "Earth", "Jupiter" } },
  right = function(a)
    local other = a.planet == "Earth" and "Jupiter" or "Earth"
    return handles[a.planet].inertia > handles[other].inertia and (a.other == nil or a.other == other)
  end,
}

function play(world)
  for i, name in ipairs(names) do
    world:level(i, name == "Earth" and "The Earth" or name)
    show(name)
    wait(0.5)
    world:caption "Push a handle with the stick. The planet turns."
    push(name, 90)
    world:sound "pop"
    game.point()
  end
  world:caption ""
  game.ask("harder", { hint = "Jupiter has 318 times the mass of the Earth.", solution = "Jupiter is harder to turn: it has more inertia." })
end

L:test {
  hand = "pusher.lua",
  say = { "Jupiter is harder to turn" },
  expect = { finished = true, stars = 3 },
}

return L
