-- Adds __gc after the metatable is set.
-- Known as: CVE-2021-44964 (Lua)
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local m = {} local t = setmetatable({}, m) m.__gc = function() while true do end end t = nil local junk = {} for i = 1, 20000 do junk[i % 10] = { i } end
end

return L
