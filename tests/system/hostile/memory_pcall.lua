-- Swallows every refusal of memory and goes on.
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local t = {} while true do pcall(function() for i = 1, 1e9 do t[#t + 1] = ('x'):rep(10000) .. #t end end) end
end

return L
