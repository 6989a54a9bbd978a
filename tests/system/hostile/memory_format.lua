-- Pads a number with a thousand million blanks.
-- Known as: after CVE-2024-31449 (Redis bit.tohex)
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  string.format('%1000000000d', 1)
end

return L
