-- Runs code as a finalizer, where no hook looks.
-- Known as: CVE-2021-44964 (Lua)
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  setmetatable({}, { __gc = function() while true do end end })
end

return L
