-- A simulated hand that lifts the wooden block and the metal block, and puts the one on top of the other.
local motion = require "motion"

local radius = 0.008
local rest = { 0, 0.34, 0.0 }

-- Touches a block from above and grips it.
local function grip(body, half)
  motion.move_to({ body.x, body.y + half + 0.08, body.z }, 0.8)
  motion.move_to({ body.x, body.y + half + radius - 0.003, body.z }, 0.6)
  motion.wait(0.3)
  motion.press(1)
  motion.wait(0.2)
end

local function let_go()
  motion.press(0)
  motion.wait(0.2)
  local x, y, z = motion.place()
  motion.move_to({ x, y + 0.1, z }, 0.6)
end

local function lift(body, half)
  grip(body, half)
  local x, y, z = motion.place()
  motion.move_to({ x, y + 0.1, z }, 1)
  motion.wait(1)
  motion.move_to({ x, y - 0.002, z }, 1)
  motion.wait(0.3)
  let_go()
end

return motion.play(function(world)
  local wood, metal = world:find "wood", world:find "metal"
  motion.start_at(rest)
  motion.wait(4)
  lift(wood, 0.04)
  motion.wait(1)
  lift(metal, 0.04)
  motion.move_to(rest, 1)
  -- The questions are asked; then the tower.
  motion.wait_until(function() return world.time > 30 end)
  grip(wood, 0.04)
  local x, y = motion.place()
  -- Over the tall block between them.
  motion.move_to({ x, y + 0.18, 0 }, 1)
  motion.move_to({ metal.x, y + 0.18, 0 }, 1.5)
  motion.wait(0.5)
  motion.move_to({ metal.x, y + 0.08, 0 }, 1)
  motion.wait(0.5)
  let_go()
  motion.move_to(rest, 1)
end)
