-- Returns no text from __tostring.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  print(setmetatable({}, { __tostring = function() return {} end }))
end

return L
