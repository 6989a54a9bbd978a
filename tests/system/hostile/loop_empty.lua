-- Never ends.
-- Known as: luanti#6299, TIC-80#1409
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  while true do end
end

return L
