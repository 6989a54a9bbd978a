-- Searches balanced brackets in quadratic time.
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  (('('):rep(300000)):find('%b()')
end

return L
