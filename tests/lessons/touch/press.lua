-- Presses straight down on the ball's top, holds, and lets go.
local motion = require "motion"
return motion.play(function()
  motion.start_at { 0, 0.5, 0 }
  motion.wait(0.5)
  motion.move_to({ 0, 0.385, 0 }, 1)
  motion.wait(2.5)
  motion.move_to({ 0, 0.5, 0 }, 1)
end)
