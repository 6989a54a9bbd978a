-- Puts a metatable on the globals.
-- Known as: CVE-2022-24735 (Redis)
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  setmetatable(_G, { __index = function(t, k) return k end, __newindex = function() end })
end

return L
