-- A simulated hand that pushes the nearest knob to the left, comes back over the handles, and pushes the next one.
local motion = require "motion"

local height = 0.40           -- the stick beside a knob
local above = 0.55

return motion.play(function()
  motion.start_at { 0.12, above, 0.24 }
  motion.wait(1)
  for _ = 1, 40 do
    motion.move_to({ 0.12, height, 0.24 }, 0.6)
    motion.move_to({ -0.2, height, 0.2 }, 1.5)
    motion.move_to({ -0.2, above, 0.24 }, 0.4)
    motion.move_to({ 0.12, above, 0.24 }, 0.5)
  end
end)
