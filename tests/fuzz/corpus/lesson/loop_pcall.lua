-- Swallows the error of the hook.
-- Known as: basic_robot#7
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  while true do pcall(function() while true do end end) end
end

return L
