-- Chains __index for ever.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local t = {} setmetatable(t, { __index = t }) t.__index = t getmetatable(t).__index = t local x = t.nothing
end

return L
