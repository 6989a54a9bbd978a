-- Claims a length of a thousand million to table functions.
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local t = setmetatable({}, { __len = function() return 1000000000 end, __index = function(_, i) return i end, __newindex = function() end }) table.insert(t, 1, 1) table.remove(t, 1) table.sort(t) table.concat(t) local a = table.unpack(t)
end

return L
