-- A simulated hand that taps and strokes whatever stands on the board, one thing after the other.
local motion = require "motion"

local rest = 0.53      -- how high it goes from one thing to the next
local deep = 0.006     -- how far it presses beyond the top: some newtons
local reach = 0.025    -- how far it strokes to each side

-- How high a thing is above its middle.
local tops = { spaceship = 0.084, table = 0.057, statue = 0.076 }
local function top_of(body) return body.y + (tops[body.name] or 0.045) end

local function stroke(body)
  local x, z, top = body.x, body.z, top_of(body)
  motion.move_to({ x, rest, z }, 0.8)
  motion.move_to({ x, top + 0.01, z }, 0.4)
  motion.move_to({ x, top - deep, z }, 0.15)   -- the tap
  for _ = 1, 2 do
    motion.move_to({ x - reach, top - deep, z }, 0.4)
    motion.move_to({ x + reach, top - deep, z }, 0.5)
  end
  motion.move_to({ x, top - deep, z }, 0.3)
  motion.move_to({ x, rest, z }, 0.5)
  motion.wait(0.3)
end

return motion.play(function(world)
  motion.start_at { 0, rest, 0 }
  motion.wait(1)
  while true do
    for _, body in ipairs(world:bodies()) do
      if body.material and body.where == "placed" then stroke(body) end
    end
    motion.wait(0.1)
  end
end)
