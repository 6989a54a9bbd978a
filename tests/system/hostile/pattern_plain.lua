-- Searches plainly in quadratic time.
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local s = ('a'):rep(1000000) s:find(('a'):rep(500000) .. 'b', 1, true)
end

return L
