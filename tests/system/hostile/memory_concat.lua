-- Doubles a text 64 times.
-- Known as: mesecons#516
-- Ends: memory
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local s = 'x' for i = 1, 64 do s = s .. s end
end

return L
