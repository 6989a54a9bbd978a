-- Dumps bytecode to change it.
-- Known as: CVE-2015-4335 (Redis)
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  string.dump(function() end)
end

return L
