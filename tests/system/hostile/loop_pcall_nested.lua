-- Swallows it at a hundred depths.
-- Known as: basic_robot#7
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local function f(n) while true do pcall(f, n + 1) end end f(1)
end

return L
