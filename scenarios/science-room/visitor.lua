-- A simulated hand that goes from place to place, strokes what stands there, and goes in at the last one.
local motion = require "motion"

local stroked = { "apple_here", "wood_here", "planet_here", "hedge_here" }

return motion.play(function(world)
  motion.start_at { 0, 0.3, 0.1 }
  motion.wait(1)
  for _, name in ipairs(stroked) do
    local thing = world:find(name)
    motion.move_to({ thing.x - 0.01, thing.y + 0.1, thing.z }, 0.6)
    motion.move_to({ thing.x - 0.01, thing.y + 0.028, thing.z }, 0.6)
    motion.move_to({ thing.x + 0.01, thing.y + 0.028, thing.z }, 0.8)
    motion.move_to({ thing.x, thing.y + 0.1, thing.z }, 0.6)
  end
  motion.press(1)
  motion.wait(1)
end)
