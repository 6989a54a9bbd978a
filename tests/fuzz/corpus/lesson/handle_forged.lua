-- Calls methods with forged receivers.
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local w = self.w local m = w.caption for _, fake in ipairs { {}, 'x', 3, function() end, coroutine.create(print), true } do assert(not pcall(m, fake, 'text')) end assert(not pcall(m))
end

return L
