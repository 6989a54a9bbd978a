-- Recurses through gsub.
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local function f(s) return (s:gsub('.', f)) end f('x')
end

return L
