-- Iterates over a table without end.
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  for i in ipairs(setmetatable({}, { __index = function(_, i) return i end })) do end
end

return L
