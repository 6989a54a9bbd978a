-- Hangs in a __close that runs because of the error.
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local function f() local x <close> = setmetatable({}, { __close = function() while true do pcall(f) end end }) error('x') end while true do pcall(f) end
end

return L
