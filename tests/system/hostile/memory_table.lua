-- Fills memory with tables.
-- Ends: memory
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local t = {} for i = 1, 1e9 do t[i] = { i } end
end

return L
