-- Nests captures beyond all stacks.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  (('a'):rep(300000)):find(('(a'):rep(100000))
end

return L
