-- Passes a million values.
-- Known as: CVE-2014-5461 (Lua varargs)
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local t = {} for i = 1, 1e6 do t[i] = i end select('#', table.unpack(t))
end

return L
