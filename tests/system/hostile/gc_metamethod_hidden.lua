-- Hides __gc behind __index.
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local m = setmetatable({}, { __index = function() return function() while true do end end end }) local t = setmetatable({}, m) t = nil local junk = {} for i = 1, 20000 do junk[i % 10] = { i } end
end

return L
