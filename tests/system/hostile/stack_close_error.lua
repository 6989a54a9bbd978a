-- Raises errors in nested __close handlers.
-- Known as: after CVE-2021-43519 (Lua)
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local function f(n) local x <close> = setmetatable({}, { __close = function() if n > 0 then f(n - 1) end error('c') end }) error('e') end f(10000)
end

return L
