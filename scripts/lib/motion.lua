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
--- When the function ends the hand stays where it is.

local motion = {}

-- Where the hand that is being played wants to be. One hand a process, so one set of these.
local x, y, z, buttons = 0, 0.3, 0, 0
local now = 0

--- The way from 0 to 1 with the least jerk (Flash & Hogan 1985): 10 s^3 - 15 s^4 + 6 s^5.
---@param s number 0 to 1; beyond, the ends
---@return number
function motion.minimum_jerk(s)
  if s <= 0 then return 0 end
  if s >= 1 then return 1 end
  return s * s * s * (10 + s * (-15 + 6 * s))
end

local function coordinates(place)
  local px, py, pz = place.x or place[1], place.y or place[2], place.z or place[3]
  if type(px) ~= "number" or type(py) ~= "number" or type(pz) ~= "number" then
    error("a place is { x, y, z }, a body or the tool", 3)
  end
  return px, py, pz
end

--- Is there at once; only sensible at the beginning.
function motion.start_at(place)
  x, y, z = coordinates(place)
end

--- Stays for so many seconds.
---@param seconds number
function motion.wait(seconds)
  local finish = now + seconds
  while now < finish - 1e-9 do coroutine.yield() end
end

--- Stays until test() gives true, or so many seconds have gone by (nil: for ever). Gives whether it became true.
---@param test fun(): any
---@param seconds number|nil
---@return boolean
function motion.wait_until(test, seconds)
  local finish = seconds and now + seconds
  while not test() do
    if finish and now >= finish - 1e-9 then return false end
    coroutine.yield()
  end
  return true
end

--- Moves there smoothly in so many seconds.
---@param place table
---@param seconds number
function motion.move_to(place, seconds)
  local tx, ty, tz = coordinates(place)
  local fx, fy, fz, from = x, y, z, now
  repeat
    coroutine.yield()
    local s = seconds > 0 and motion.minimum_jerk((now - from) / seconds) or 1
    x, y, z = fx + (tx - fx) * s, fy + (ty - fy) * s, fz + (tz - fz) * s
  until now >= from + seconds - 1e-9
end

--- Goes after a body: each second it covers most of the distance. Options: seconds (how long, default 1), until_ (a function: stop
--- when it gives true), quickness (1/s, default 12), and x, y or z to hold one of them instead.
function motion.follow(body, options)
  options = options or {}
  local finish = now + (options.seconds or 1)
  local quickness = options.quickness or 12
  local last = now
  while now < finish - 1e-9 and not (options.until_ and options.until_()) do
    coroutine.yield()
    local share = 1 - math.exp(-quickness * (now - last))
    last = now
    x = x + ((options.x or body.x) - x) * share
    y = y + ((options.y or body.y) - y) * share
    z = z + ((options.z or body.z) - z) * share
  end
end

--- Presses buttons: 1 for the first, 2 for the second, 3 for both; 0 lets go.
---@param which integer
function motion.press(which) buttons = which end

--- Where the hand wants to be now.
---@return number x, number y, number z
function motion.place() return x, y, z end

--- Makes a simulated hand out of a function that moves it step by step.
---@param script fun(world: World, hand: Tool)
function motion.play(script)
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
    return x, y, z, buttons
  end
end

return motion
