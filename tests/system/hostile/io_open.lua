-- Writes the canary file through io.
-- Known as: what Luanti's mod security forbids
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  io.open('@CANARY@', 'w'):write('gone')
end

return L
