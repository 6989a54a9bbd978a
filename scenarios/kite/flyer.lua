-- A simulated hand that holds the line still, and lets more out while the balloon is there.
local motion = require "motion"

local rest = { 0, 1.2, 0 }

return motion.play(function(world)
  local balloon = world:find "balloon"
  motion.start_at(rest)
  while true do
    motion.wait_until(function() return balloon.where ~= "hidden" end)
    motion.press(1)
    motion.wait_until(function() return balloon.where == "hidden" end)
    motion.press(0)
  end
end)
