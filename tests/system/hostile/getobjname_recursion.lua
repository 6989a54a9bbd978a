-- Names a value through a long chain of moves.
-- Known as: Lua 5.4.6: recursion in getobjname
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local a = nil pcall(function() local b, c, d = a, a, a return b.c.d.e.f.g end)
end

return L
