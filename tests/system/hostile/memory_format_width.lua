-- Pads with 99 places ten thousand times.
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local t = {} for i = 1, 200 do t[i] = 1 end for i = 1, 1e9 do t[i] = string.format(('%99d'):rep(200), table.unpack(t, 1, 200)) .. i end
end

return L
