-- Backtracks for years in find.
-- Known as: mesecons#255
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  (('a'):rep(25)):find(('a?'):rep(25) .. 'b' )
end

return L
