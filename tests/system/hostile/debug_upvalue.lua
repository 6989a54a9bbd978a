-- Changes an upvalue of pcall.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  debug.setupvalue(pcall, 1, print)
end

return L
