-- Backtracks by way of a method of a text.
-- Known as: mesecons#380
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  (('x'):rep(30)):match(('.-'):rep(30) .. 'y')
end

return L
