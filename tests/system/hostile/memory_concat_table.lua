-- Joins a thousand copies of a megabyte.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local t = {} local s = ('x'):rep(100000) for i = 1, 1000 do t[i] = s end table.concat(t)
end

return L
