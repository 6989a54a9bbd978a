--- Simulated hands: a Lua file that says where a hand wants to be, 60 times a second.
---
---   local motion = require "motion"
---   return motion.play(function(world)
---     motion.start_at { 0, 0.3, 0 }
---     motion.wait(0.5)
---     motion.move_to({ 0.1, 0.3, 0 }, 0.8)                       -- smoothly, in 0.8 s
---     motion.follow(world:find "apple", { seconds = 2, y = 0.2 }) -- stays under it, at that height
---   end)
---
--- When the function ends the hand stays where it is. Without `motion` a hand's file returns a function of its own:
--- `return function(hand, t, world) return x, y, z end`, called 60 times a second; after them it may give the buttons that it
--- presses, how it is turned, as `motion.turn_to` has it, and the name of a key that it presses.

-- What the program gives to the shared library: mistakes are told at the hand's own line.
local module_name, program = ...
local mistake, shown = program.mistake, program.shown

local motion = {}

-- Where the hand that is being played wants to be. One hand a script, so one set of these.
local x, y, z, buttons = 0, 0.3, 0, 0
local key                     -- to be pressed on the keyboard, once
local turn = { 0, 0, 0 }      -- degrees about this direction, by as much as it is long
local now = 0
local most_degrees = 3600     -- ten turns
local most_metres = 10000

-- Lets a frame go by.
local function next_frame(called)
  if not coroutine.isyieldable() then
    mistake(called .. " belongs inside motion.play(function(world) … end)")
  end
  coroutine.yield()
end

local function check_seconds(called, seconds)
  if type(seconds) ~= "number" then mistake(called .. " takes seconds; got " .. shown(seconds)) end
end

local function check_function(called, given)
  if type(given) ~= "function" then mistake(called .. " takes a function; got " .. shown(given)) end
end

--- The way from 0 to 1 with the least jerk (Flash & Hogan 1985): 10 s^3 - 15 s^4 + 6 s^5.
---@param s number 0 to 1; beyond, the ends
---@return number
function motion.minimum_jerk(s)
  if type(s) ~= "number" then mistake("motion.minimum_jerk takes a number; got " .. shown(s)) end
  if s <= 0 then return 0 end
  if s >= 1 then return 1 end
  return s * s * s * (10 + s * (-15 + 6 * s))
end

local function coordinates(called, place)
  if type(place) ~= "table" and type(place) ~= "userdata" then
    mistake(called .. " takes a place, { x, y, z }, a body or the tool; got " .. shown(place))
  end
  local listed = type(place) == "table"
  local px = listed and place[1] or place.x
  local py = listed and place[2] or place.y
  local pz = listed and place[3] or place.z
  if type(px) ~= "number" or type(py) ~= "number" or type(pz) ~= "number" then
    mistake(called .. " takes a place of three numbers, { x, y, z }; got { " .. shown(px) .. ", " .. shown(py)
      .. ", " .. shown(pz) .. " }")
  end
  return px, py, pz
end

-- A place that a hand may want to be at.
local function reachable(called, place)
  local px, py, pz = coordinates(called, place)
  for _, value in ipairs { px, py, pz } do
    if not (math.abs(value) <= most_metres) then
      mistake(called .. " goes at most " .. most_metres .. " metres far along each axis; got " .. shown(value))
    end
  end
  return px, py, pz
end

--- Is there at once; only sensible at the beginning.
---@param place Vector|Body|Tool
function motion.start_at(place)
  x, y, z = reachable("motion.start_at", place)
end

--- Stays for so many seconds.
---@param seconds number
function motion.wait(seconds)
  check_seconds("motion.wait", seconds)
  local finish = now + seconds
  while now < finish - 1e-9 do next_frame "motion.wait" end
end

--- Stays until `test()` gives true, or so many seconds have gone by (nil: for ever). Gives whether it became true.
---@param test fun(): any
---@param seconds number|nil
---@return boolean
function motion.wait_until(test, seconds)
  check_function("motion.wait_until", test)
  if seconds ~= nil then check_seconds("motion.wait_until's second value", seconds) end
  local finish = seconds and now + seconds
  while not test() do
    if finish and now >= finish - 1e-9 then return false end
    next_frame "motion.wait_until"
  end
  return true
end

--- Moves there smoothly in so many seconds.
---@param place Vector|Body|Tool
---@param seconds number
function motion.move_to(place, seconds)
  local tx, ty, tz = reachable("motion.move_to", place)
  check_seconds("motion.move_to's second value", seconds)
  local fx, fy, fz, from = x, y, z, now
  repeat
    next_frame "motion.move_to"
    local s = seconds > 0 and motion.minimum_jerk((now - from) / seconds) or 1
    x, y, z = fx + (tx - fx) * s, fy + (ty - fy) * s, fz + (tz - fz) * s
  until now >= from + seconds - 1e-9
end

--- Turns the hand smoothly in so many seconds, to { x, y, z }: about this direction, by as many degrees as it is long.
--- `{ 0, 0, 30 }` leans what it holds 30 degrees to the left, `{ 0, 0, 0 }` holds it as in the beginning.
---@param to Vector
---@param seconds number
function motion.turn_to(to, seconds)
  if type(to) ~= "table" then
    mistake("motion.turn_to takes degrees about a direction, such as { 0, 0, 30 }; got " .. shown(to))
  end
  local tx, ty, tz = coordinates("motion.turn_to", to)
  local degrees = math.sqrt(tx * tx + ty * ty + tz * tz)
  if not (degrees <= most_degrees) then
    mistake("motion.turn_to turns by at most " .. most_degrees .. " degrees; got " .. shown(degrees))
  end
  check_seconds("motion.turn_to's second value", seconds)
  local fx, fy, fz, from = turn[1], turn[2], turn[3], now
  repeat
    next_frame "motion.turn_to"
    local s = seconds > 0 and motion.minimum_jerk((now - from) / seconds) or 1
    turn = { fx + (tx - fx) * s, fy + (ty - fy) * s, fz + (tz - fz) * s }
  until now >= from + seconds - 1e-9
end

local follow_options = { seconds = "number", quickness = "number", until_ = "function", x = "number", y = "number",
  z = "number" }

local function check_follow(body, options)
  if type(body) ~= "userdata" then mistake("motion.follow takes a body; got " .. shown(body)) end
  if type(options) ~= "table" then
    mistake("motion.follow's options are a table, such as { seconds = 2 }; got " .. shown(options))
  end
  for name, value in pairs(options) do
    if follow_options[name] == nil then program.unknown("motion.follow", follow_options, name) end
    if type(value) ~= follow_options[name] then
      mistake("motion.follow's " .. name .. " is a " .. follow_options[name] .. "; got " .. shown(value))
    end
  end
end

--- Goes after a body: each second it covers most of the distance. Options: `seconds` (how long, default 1), `until_` (a
--- function: stop when it gives true), `quickness` (1/s, default 12), and `x`, `y` or `z` to hold one of them instead.
---@param body Body
---@param options table|nil
function motion.follow(body, options)
  options = options or {}
  check_follow(body, options)
  local finish = now + (options.seconds or 1)
  local quickness = options.quickness or 12
  local last = now
  while now < finish - 1e-9 and not (options.until_ and options.until_()) do
    next_frame "motion.follow"
    local share = 1 - math.exp(-quickness * (now - last))
    last = now
    x = x + ((options.x or body.x) - x) * share
    y = y + ((options.y or body.y) - y) * share
    z = z + ((options.z or body.z) - z) * share
  end
end

--- For ever: each time that a body is placed somewhere, such as a star that shows where to press, does something and then
--- goes to rest.
---@param body Body
---@param rest Vector where the hand waits
---@param act fun(is_there: fun(): boolean) moves the hand, as long as is_there(): the body has not gone elsewhere
function motion.whenever_placed(body, rest, act)
  if type(body) ~= "userdata" then mistake("motion.whenever_placed takes a body; got " .. shown(body)) end
  check_function("motion.whenever_placed's third value", act)
  while true do
    motion.wait_until(function() return body.where == "placed" end)
    local bx, by, bz = body.x, body.y, body.z
    act(function() return body.where == "placed" and body.x == bx and body.y == by and body.z == bz end)
    motion.move_to(rest, 0.6)
  end
end

--- Presses buttons: 1 for the first, 2 for the second, 3 for both; 0 lets go.
---@param which integer
function motion.press(which)
  if math.type(which) ~= "integer" or which < 0 then
    mistake("motion.press takes 0, 1, 2 or 3; got " .. shown(which))
  end
  buttons = which
end

--- Presses a key of the keyboard: "left", "right", "up", "down", "space", a letter. While a question is open it is not heard.
---@param name string
function motion.key(name)
  if type(name) ~= "string" then mistake("motion.key takes the name of a key, such as \"left\"; got " .. shown(name)) end
  key = name
  next_frame "motion.key"
end

--- Where the hand wants to be now.
---@return number x, number y, number z
function motion.place() return x, y, z end

--- Makes a simulated hand out of a function that moves it step by step.
---@param script fun(world: World, hand: Tool)
function motion.play(script)
  check_function("motion.play", script)
  local playing = coroutine.create(script)
  local begun = false
  return function(hand, t, world)
    now = t
    if not begun then
      begun = true
      x, y, z = hand.x, hand.y, hand.z
    end
    if coroutine.status(playing) ~= "dead" then
      local fine, problem = coroutine.resume(playing, world, hand)
      if not fine then error(problem, 0) end
    end
    local pressed = key
    key = nil
    return x, y, z, buttons, turn, pressed
  end
end

return setmetatable(motion, {
  __index = function(_, field) program.unknown(module_name, motion, field) end,
})
