-- Sends bytes that are no UTF-8.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  self.w:caption('\xff\xfe\x00')
end

return L
