-- A simulated hand that lowers what it holds into the bowl, goes round in it, and takes it out.
local motion = require "motion"

local above = 0.46
local low = 0.25

return motion.play(function()
  motion.start_at { 0, above, 0 }
  motion.wait(1)
  for _ = 1, 6 do
    motion.move_to({ 0, low, 0 }, 1.5)
    for i = 0, 16 do
      local angle = math.pi * i / 8
      motion.move_to({ 0.06 * math.cos(angle), low, 0.06 * math.sin(angle) }, 0.35)
    end
    motion.move_to({ 0, low, 0 }, 0.5)
    motion.move_to({ 0, above, 0 }, 1)
    motion.wait(4)
  end
end)
