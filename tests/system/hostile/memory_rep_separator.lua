-- Overflows the size of rep with a separator.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local s = ('x'):rep(9223372036854775807, ('y'):rep(1000))
end

return L
