-- Recurses through tostring.
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local t t = setmetatable({}, { __tostring = function() return tostring(t) end }) tostring(t)
end

return L
