-- Never ends in a condition.
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  repeat until (function() return false end)()
end

return L
