-- Goes 4 cm to the side and stays there.
local motion = require "motion"
return motion.play(function()
  motion.start_at { 0, 0.3, 0 }
  motion.wait(0.5)
  motion.move_to({ 0.04, 0.3, 0 }, 1)
end)
