-- Counts to the end of all numbers.
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  for i = math.mininteger, math.maxinteger do end
end

return L
