-- Searches a long text in quadratic time.
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local s = ('a'):rep(200000) s:find('.-b')
end

return L
