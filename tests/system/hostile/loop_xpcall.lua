-- Hangs in a message handler, where no hook looks.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  xpcall(error, function() while true do end end)
end

return L
