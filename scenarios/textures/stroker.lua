-- A simulated hand that taps and strokes what the star hangs over.
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

local function distance(one, other) return math.abs(one.x - other.x) end

-- What stands under the star; nil while there is none.
local function under_the_star(world)
  local star, found
  for _, body in ipairs(world:bodies()) do
    if body.name == "star" and body.where == "placed" then star = body end
  end
  for _, body in ipairs(star and world:bodies() or {}) do
    if body.material and body.where == "placed" and (not found or distance(body, star) < distance(found, star)) then
      found = body
    end
  end
  return found
end

return motion.play(function(world)
  motion.start_at { 0, rest, 0 }
  motion.wait(1)
  while true do
    local body = under_the_star(world)
    if body then stroke(body) end
    motion.wait(0.1)
  end
end)
