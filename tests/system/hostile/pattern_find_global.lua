-- Backtracks for years in string.find.
-- Known as: mesecons#255
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  string.find(('a'):rep(40), ('a*'):rep(40) .. 'b')
end

return L
