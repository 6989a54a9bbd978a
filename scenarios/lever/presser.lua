-- A simulated hand that presses the lever under the star, until the star is gone.
local motion = require "motion"

local rest = { 0.1, 0.58, 0 }

return motion.play(function(world)
  local star = world:find "star"
  motion.start_at(rest)
  motion.wait(1)
  motion.whenever_placed(star, rest, function(is_there)
    local x = star.x
    motion.move_to({ x, 0.46, 0 }, 0.6)
    -- Down, deeper and deeper, as somebody who presses harder.
    local y = 0.42
    while is_there() and y > 0.2 do
      motion.move_to({ x, y, 0 }, 0.05)
      y = y - 0.004
    end
    motion.wait_until(function() return not is_there() end, 4)
    motion.wait(0.5)
    motion.move_to({ x, 0.55, 0 }, 0.5)
  end)
end)
