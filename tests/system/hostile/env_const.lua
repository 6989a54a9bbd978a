-- Declares _ENV constant.
-- Known as: CVE-2022-28805 (Lua)
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local _ENV <const> = {} local x = y
end

return L
