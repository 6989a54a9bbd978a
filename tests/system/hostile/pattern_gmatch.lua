-- Backtracks in an iterator.
-- Known as: mesecons#255
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  for x in (('a'):rep(60)):gmatch(('a*'):rep(20) .. 'b') do end
end

return L
