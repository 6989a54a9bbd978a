--- Lets the learner choose among things by going to one, with an arm, a mouse or keys.
---
---   local choose = require "choose"
---
---   local eye = { 0, 1.15, 1.5 }       -- as world:camera has it
---   choose.offer { mars, venus }       -- a line round each, and an empty sign above the scene
---   local chosen = choose.one(world, { mars, venus }, { eye = eye, hint = "Go to a planet, and stay there." })
---   if not chosen then chosen = mars end
---   chosen:light "lit"                 -- it shines, and its sign is filled
---
--- A thing is chosen when the hand is seen over it, or beside it, and presses its button, or stays there for a second.

-- What the program gives to the shared library: mistakes are told at the lesson's own line.
local module_name, program = ...
local mistake, shown = program.mistake, program.shown

local story = require "story"

local choose = {}

local usual_reach = 0.045   -- metres beside a thing's middle, across the line of sight
local stay_seconds = 1

local function check_bodies(called, bodies)
  if type(bodies) ~= "table" or #bodies == 0 then mistake(called .. " takes a list of bodies; got " .. shown(bodies)) end
  for _, body in ipairs(bodies) do
    if type(body) ~= "userdata" then mistake(called .. " takes a list of bodies; got " .. shown(body) .. " in it") end
  end
end

--- Lights them as things that may be chosen.
---@param bodies Body[]
function choose.offer(bodies)
  check_bodies("choose.offer", bodies)
  for _, body in ipairs(bodies) do body:light "offered" end
end

-- How far a thing is from the line of sight through the hand.
local function away_from_sight(eye, tool, body)
  local ax, ay, az = tool.x - eye[1], tool.y - eye[2], tool.z - eye[3]
  local bx, by, bz = body.x - eye[1], body.y - eye[2], body.z - eye[3]
  local cx, cy, cz = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
  local length = math.sqrt(ax * ax + ay * ay + az * az)
  return length > 0 and math.sqrt(cx * cx + cy * cy + cz * cz) / length or math.huge
end

local options_of = { eye = "table", hint = "string", again = "boolean", reach = "number" }

--- Waits until one of the bodies is chosen, and gives it; nil where nobody has chosen any after 60 seconds. After 20 seconds `hint` is
--- said, after 40 the program's own hand goes to the first. `eye` is where the camera is; within `reach` metres of a thing's middle, seen
--- from there, a hand is at it (0.045 by default); `again`: who did not choose just before is shown at once.
---@param world World
---@param bodies Body[]
---@param options table
---@return Body|nil
function choose.one(world, bodies, options)
  if type(world) ~= "userdata" then mistake("choose.one takes the world first; got " .. shown(world)) end
  check_bodies("choose.one", bodies)
  if type(options) ~= "table" then mistake("choose.one takes options, such as { eye = { 0, 1.15, 1.5 } }; got " .. shown(options)) end
  for name, value in pairs(options) do
    if options_of[name] == nil then program.unknown("choose.one", options_of, name) end
    if type(value) ~= options_of[name] then mistake("choose.one's " .. name .. " is a " .. options_of[name] .. "; got " .. shown(value)) end
  end
  local eye = options.eye
  if not eye or #eye ~= 3 then mistake "choose.one needs where the camera is, eye = { 0, 1.15, 1.5 }" end
  local reach = options.reach or usual_reach

  local function seen_at()
    local tool, best, least = world:tool(), nil, nil
    for _, body in ipairs(bodies) do
      local away = away_from_sight(eye, tool, body)
      if away < math.max(reach, body.radius) and (not least or away < least) then best, least = body, away end
    end
    return best
  end

  -- Where the hand is by chance, and what it presses still, chooses nothing.
  local tired, pressed_before = seen_at(), world:tool().pressed
  local at, since, chosen
  story.wait_with_help(world, function()
    local now, pressed = seen_at(), world:tool().pressed
    if now ~= tired then tired = nil end
    if now ~= at then at, since = now, world.time end
    local presses = pressed and not pressed_before
    pressed_before = pressed
    if now and (presses or now ~= tired and world.time - since >= stay_seconds) then chosen = now end
    return chosen
  end, {
    hint = options.hint, again = options.again,
    show = function()
      local to = bodies[1]
      return { { to.x + 0.1, to.y, to.z + 0.1 }, { to.x, to.y, to.z } }
    end,
  })
  return chosen
end

return setmetatable(choose, {
  __index = function(_, field) program.unknown(module_name, choose, field) end,
})
