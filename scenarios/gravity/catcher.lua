-- A simulated hand that goes under whatever falls and waits there until it is caught.
local motion = require "motion"

local rest = { 0, 0.3, 0 }

local function falling(world)
  for _, body in ipairs(world:bodies()) do
    if body.where == "falling" then return body end
  end
end

return motion.play(function(world)
  motion.start_at(rest)
  while true do
    local body
    motion.wait_until(function() body = falling(world) return body end)
    motion.follow(body, { seconds = 5, y = 0.3, z = 0, until_ = function() return body.where ~= "falling" end })
    motion.wait(0.5)
    motion.move_to(rest, 1.2)
  end
end)
