-- A simulated hand that goes to one planet after the other, and then presses one under the star and drags its surface sideways, to and fro.
local motion = require "motion"

local near = { 0, 0.5, 0.3 }     -- the planet's middle
local eye = { 0, 1.15, 1.5 }
local rest = { 0.25, 0.35, 0.6 }

return motion.play(function(world)
  local star = world:find "star"
  motion.start_at(rest)
  motion.wait(1)
  -- Before one planet after the other, off it and back until it is seen from near: a hand that is there by chance chooses nothing.
  for _, name in ipairs { "earth", "mars", "mercury", "venus", "jupiter", "saturn", "uranus", "neptune" } do
    local far, seen = world:find(name .. "-far"), world:find(name)
    local function is_over() return seen.where ~= "hidden" or star.where ~= "hidden" end
    local function before(up)
      local part = (rest[3] - eye[3]) / (far.z - eye[3])
      return { part * far.x, eye[2] + part * (far.y + up - eye[2]), rest[3] }
    end
    motion.wait_until(function() return far.where ~= "hidden" or is_over() end)
    while not is_over() do
      motion.move_to(before(0.25), 0.5)
      motion.move_to(before(0), 0.5)
      motion.wait_until(is_over, 1.5)
    end
  end
  motion.whenever_placed(star, rest, function(is_there)
    -- From the star towards the planet's middle: 3 cm to its surface.
    local dy, dz = star.y - near[2], star.z - near[3]
    local far = math.sqrt(dy * dy + dz * dz)
    local function at(x, r) return { x, near[2] + dy / far * r, near[3] + dz / far * r } end
    local side = -1
    while is_there() do
      motion.move_to(at(0.04 * side, far + 0.02), 0.5)
      motion.move_to(at(0.04 * side, far - 0.042), 0.25)
      motion.move_to(at(-0.04 * side, far - 0.042), 0.6)
      motion.move_to(at(-0.04 * side, far + 0.02), 0.2)
    end
  end)
end)
