local motion = require "motion"
return motion.play(function()
  motion.start_at { 0, 0.35, 0 }
  motion.wait(1)
  motion.move_to({ 0, 0.245, 0 }, 0.5)
  motion.wait(1)
  motion.move_to({ 0, 0.35, 0 }, 0.5)
  motion.move_to({ 0, 0.245, 0 }, 0.5)
  motion.move_to({ 0, 0.35, 0 }, 0.5)
end)
