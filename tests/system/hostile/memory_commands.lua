-- Sends a million commands.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  for i = 1, 1e6 do self.w:caption('x') end
end

return L
