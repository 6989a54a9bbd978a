-- Makes texts callable.
-- Known as: CVE-2025-46818 (Redis)
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  getmetatable('').__call = function() end
end

return L
