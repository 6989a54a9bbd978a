-- Iterates for ever through __pairs.
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  for k in pairs(setmetatable({}, { __pairs = function() return function() return 1 end end })) do end
end

return L
