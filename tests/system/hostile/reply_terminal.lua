-- Sends control characters to the teacher's terminal.
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  print('\27[2J\27]0;gone\7')
end

return L
