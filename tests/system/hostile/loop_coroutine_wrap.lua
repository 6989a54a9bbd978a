-- Passes the hang to ever new coroutines.
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local function f() while true do pcall(coroutine.wrap(f)) end end f()
end

return L
