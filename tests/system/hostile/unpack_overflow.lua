-- Overflows the count of unpack.
-- Known as: CVE-2025-46817 (Redis)
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  table.unpack({}, -9223372036854775807, 9223372036854775807)
end

return L
