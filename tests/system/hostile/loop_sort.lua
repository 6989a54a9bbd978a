-- Sorts with an order that never returns.
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  table.sort({ 3, 2, 1 }, function() while true do end end)
end

return L
