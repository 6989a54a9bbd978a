-- Asks the name of a function in a vararg error.
-- Known as: CVE-2021-44647 (Lua funcnamefromcode)
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local function f(...) local a <const> = ... return (a or nil)() end pcall(f) local t = setmetatable({}, { __index = function(t, k) return k() end }) pcall(function() return t.x.y.z end)
end

return L
