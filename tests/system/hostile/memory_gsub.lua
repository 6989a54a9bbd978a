-- Blows a text up by replacing.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local s = ('a'):rep(1000000) s:gsub('a', ('b'):rep(1000))
end

return L
