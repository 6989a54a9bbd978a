-- Packs with sizes beyond memory.
-- Known as: CVE-2018-11219 (Redis struct)
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  string.pack('i17', 1)
end

return L
