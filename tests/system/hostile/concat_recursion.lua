-- Calls itself through __concat.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local t t = setmetatable({}, { __concat = function(a, b) return a .. b end }) local x = t .. t
end

return L
