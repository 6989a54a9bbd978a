-- Keeps memory in a chain of functions.
-- Ends: memory
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local f = function() end while true do local g = f f = function() return g, { 1, 2, 3, 4, 5, 6, 7, 8 } end end
end

return L
