-- Calls itself through __index.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local t t = setmetatable({}, { __index = function(s, k) return s[k + 1] end }) local x = t[1]
end

return L
