-- Sends a caption of a megabyte.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  self.w:caption(('x'):rep(1000000))
end

return L
