-- Hangs in __tostring while it is printed.
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  print(setmetatable({}, { __tostring = function() while true do end end }))
end

return L
