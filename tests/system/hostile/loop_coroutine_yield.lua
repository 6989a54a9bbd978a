-- Yields for ever between two coroutines.
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local co = coroutine.wrap(function() while true do coroutine.yield() end end) while true do co() end
end

return L
