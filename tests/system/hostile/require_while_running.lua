-- Requires a file in the middle of the lesson.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  require 'no_such_module'
end

return L
