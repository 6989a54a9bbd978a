-- A simulated hand that presses a planet under the star and drags its surface sideways, to and fro.
local motion = require "motion"

local near = { 0, 0.5, 0.3 }     -- the planet's middle
local rest = { 0.25, 0.35, 0.6 }

return motion.play(function(world)
  local star = world:find "star"
  motion.start_at(rest)
  motion.wait(1)
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
