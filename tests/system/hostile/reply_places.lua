-- Moves a body to the end of all numbers.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  self.b:place { at = { 1e308, 0, 0 } }
end

return L
