-- Raises an error of wild bytes.
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  error('\0\27[31m\xff:12: gone', 0)
end

return L
