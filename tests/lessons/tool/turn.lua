-- Lays the stick down, presses it on the table, then turns the hand back by six degrees.
local motion = require "motion"
return motion.play(function()
  motion.start_at { 0, 0.4, 0 }
  motion.wait(0.5)
  motion.turn_to({ 0, 0, 90 }, 1)
  motion.move_to({ 0, 0.21, 0 }, 1)
  motion.wait(1.5)
  motion.turn_to({ 0, 0, 84 }, 0.5)
end)
