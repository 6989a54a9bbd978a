-- The science room: each lesson has a place where its things stand and can be touched. Who walks there can go in; who leaves the
-- lesson is here again. A lesson that is not known here is behind the door, with all others.

local L = lesson { id = "science-room", title = "The science room", icon = "castle", level = "A1" }

local stand_width, stand_height = 0.13, 0.1
local spacing = 0.165
local row_z = -0.06           -- where all stand, so that a pointer meets them

-- The places from left to right: the way through them is the course's. `show` puts things on a stand whose top is there.
local places = {
  { lesson = "gravity", show = function(world, x, y, z)
    world:body { name = "apple_here", noun = "", model = "apple", at = { x - 0.03, y + 0.042, z }, felt_shape = "ball" }
    world:body { name = "egg_here", noun = "", model = "egg", at = { x + 0.04, y + 0.028, z + 0.01 }, felt_shape = "ball" }
  end },
  { lesson = "textures", show = function(world, x, y, z)
    for i, material in ipairs { "wood", "metal", "rock" } do
      world:body { name = material .. "_here", noun = "", model = "box", size = { 0.04, 0.06, 0.05 }, material = material,
                   at = { x + 0.045 * (i - 2), y + 0.03, z } }
    end
  end },
  { lesson = "solar-system", show = function(world, x, y, z)
    world:body { name = "planet_here", noun = "", model = "earth", radius = 0.05, at = { x, y + 0.05, z } }
  end },
  { lesson = "lever", show = function(world, x, y, z)
    world:body { name = "support_here", noun = "", model = "box", size = { 0.03, 0.05, 0.05 }, material = "rock", at = { x, y + 0.025, z } }
    world:body { name = "lever_here", noun = "", model = "box", size = { 0.15, 0.012, 0.05 }, material = "wood", at = { x, y + 0.056, z } }
  end },
  { lesson = "kite", show = function(world, x, y, z)
    world:body { name = "kite_here", noun = "", model = "kite", material = "paper", at = { x, y + 0.15, z } }
  end },
  { lesson = "maze-park", show = function(world, x, y, z)
    world:body { name = "hedge_here", noun = "", model = "box", size = { 0.12, 0.06, 0.03 }, material = "leaves", at = { x, y + 0.03, z - 0.03 } }
    world:body { name = "gem_here", noun = "", model = "gem", at = { x, y + 0.03, z + 0.025 }, felt_shape = "hull" }
  end },
  { lesson = "stacks", show = function(world, x, y, z)
    for i, material in ipairs { "rock", "metal", "wood" } do
      local edge = 0.075 - 0.015 * i
      world:body { name = material .. "_block_here", noun = "", model = "box", size = { edge, edge, edge }, material = material,
                   at = { x, y + edge / 2 + ({ 0, 0.06, 0.105 })[i], z } }
    end
  end },
}
local door = { x = 0.56, z = -0.1, name = "" }

local room, walker
local stars = {}              -- of each place, three bodies
local chosen                  -- the place where the walker is, or goes to
local shown_chosen            -- of which the caption tells
local hand_was = { 0, 0, 0 }
local was_pressed = true      -- who comes in with a button held goes nowhere
local settled = 1             -- seconds

local function solid(world, body)
  body.solid, body.visible = true, true
  return world:body(body)
end

function L:start(world)
  room = world
  world:room()
  world:ground(0)
  world:camera { eye = { 0, 0.62, 1.2 }, target = { 0, 0.19, row_z } }
  world:hand { centre = { 0, 0.24, row_z }, scale = 5 }
  local stands = {}
  local things = setmetatable({ body = function(_, body)
    return body.scale and world:body(body) or solid(world, body)
  end }, { __index = world })
  for i, place in ipairs(places) do
    place.x = spacing * (i - 1 - (#places - 1) / 2) - 0.15
    place.z = row_z
    stands[i] = { at = { place.x, stand_height / 2, place.z }, size = { stand_width, stand_height, stand_width } }
    place.show(things, place.x, stand_height, place.z)
    stars[i] = {}
    for star = 1, 3 do
      stars[i][star] = world:body { name = ("star_%d_of_%d"):format(star, i), noun = "", model = "star", scale = 0.4 }
    end
  end
  -- Seen alone: a hand goes along behind what stands there, and is never caught between.
  world:body { name = "stands", noun = "", model = "box", visible = true, boxes = stands }
  solid(world, { name = "door", noun = "all lessons", model = "box", material = "wood", size = { 0.14, 0.26, 0.02 }, at = { door.x, 0.138, door.z } })
  -- Two walls and a floor; they are out of reach, and seen alone.
  world:body { name = "walls", noun = "", model = "box", visible = true, boxes = {
    { at = { 0, -0.011, 0.05 }, size = { 2.2, 0.02, 1.2 } },
    { at = { 0, 0.35, -0.5 }, size = { 2.2, 0.75, 0.03 } },
  } }
  walker = world:body { name = "walker", noun = "you", model = "walker", movable = true, visible = true, at = { 0, 0, 0.3 } }
end

-- ---- where one can go ---------------------------------------------------------------------------------------------------

local way = {}                -- the places that are there, from left to right, the door last

local function find_way(world)
  local known = {}
  for _, lesson in ipairs(world.lessons) do known[lesson.name] = lesson end
  local won, most = 0, 0
  for i, place in ipairs(places) do
    local lesson = known[place.lesson]
    if lesson then
      place.name, place.title, place.won = lesson.name, lesson.title, lesson.stars
      way[#way + 1] = place
      won, most = won + math.max(place.won, 0), most + 3
      for star = 1, place.won do
        stars[i][star]:place { at = { place.x + 0.042 * (star - 2), 0.34, place.z } }
      end
    end
  end
  way[#way + 1] = door
  world:score(won)
  return won, most
end

-- The first that was never played to its end; the door for who has played all.
local function find_next()
  for i, place in ipairs(way) do
    if place == door or place.won < 0 then return i end
  end
end

local function tell(world)
  local place = way[chosen]
  local go_in = " Press Enter or click to go in."
  if place == door then
    world:caption("All lessons, and your own." .. go_in)
  else
    local title = place.title .. (place.title:find "[%.!?]$" and "" or ".")
    world:caption(title .. (place.won < 0 and "" or (" You have %d of 3 stars."):format(place.won)) .. go_in)
  end
end

-- ---- by hand and by keys --------------------------------------------------------------------------------------------------

local function nearest(tool)
  local best, least = nil, 0.16
  for i, place in ipairs(way) do
    local away = math.sqrt((tool.x - place.x) ^ 2 + 0.25 * (tool.z - place.z) ^ 2)
    if away < least then best, least = i, away end
  end
  return best
end

local speed = 0.7             -- of the walker, metres per second

local function walk(dt)
  local place = way[chosen]
  local to = { place.x, 0, place.z + 0.14 }
  local away = { to[1] - walker.x, 0, to[3] - walker.z }
  local far = math.sqrt(away[1] ^ 2 + away[3] ^ 2)
  if far > 0.002 then
    local part = math.min(1, speed * dt / far)
    walker:place { at = { walker.x + part * away[1], 0, walker.z + part * away[3] } }
  end
end

function L:update(world, dt)
  local tool = world:tool()
  if not chosen then
    local won, most = find_way(world)
    chosen = find_next()
    shown_chosen = chosen
    world:show_hand { at = { way[chosen].x + 0.02, stand_height - 0.02, way[chosen].z + 0.1 } }   -- before the stand, on which the thing is
    world:caption(won == 0 and "Walk with the arrow keys, or with your hand. Touch the things!" or ("Welcome! You have %d of %d stars."):format(won, most))
    hand_was = tool.position
  end
  -- Who moves the hand goes with it, who presses an arrow key with that.
  local moved = math.abs(tool.x - hand_was[1]) + math.abs(tool.y - hand_was[2]) + math.abs(tool.z - hand_was[3])
  local under = nearest(tool)
  if world.time < settled then
    hand_was = tool.position      -- it comes to where the mouse is
  elseif moved > 0.03 then
    hand_was = tool.position
    chosen = under or chosen
  end
  if chosen ~= shown_chosen then
    shown_chosen = chosen
    world:hide_hand()
    tell(world)
  end
  if tool.pressed and not was_pressed and under then
    chosen = under
    world:enter(way[chosen].name)
  end
  was_pressed = tool.pressed
  walk(dt)
end

function L:key(name)
  local world = room
  if not chosen then return end
  if name == "left" then chosen = math.max(chosen - 1, 1)
  elseif name == "right" then chosen = math.min(chosen + 1, #way)
  elseif name == "return" or name == "space" then world:enter(way[chosen].name)
  end
end

L:test { hand = "visitor.lua", expect = { finished = true, felt = true } }

return L
