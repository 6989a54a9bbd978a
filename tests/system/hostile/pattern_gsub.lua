-- Backtracks for years in gsub.
-- Known as: mesecons#255
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  (('z'):rep(41)):gsub(('z?'):rep(41) .. ('z'):rep(41), '.')
end

return L
