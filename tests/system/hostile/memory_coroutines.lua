-- Makes coroutines without end.
-- Ends: memory
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local t = {} for i = 1, 1e9 do t[i] = coroutine.create(print) coroutine.resume(t[i]) end
end

return L
