-- Makes many texts of a megabyte.
-- Known as: mesecons#255
-- Ends: memory
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local t = {} for i = 1, 1e9 do t[i] = ('x'):rep(1000000 - i) end
end

return L
