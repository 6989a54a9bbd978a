-- Raises an error that claims another place.
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  error('/etc/passwd:1: root', 0)
end

return L
