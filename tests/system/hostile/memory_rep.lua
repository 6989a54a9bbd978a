-- Makes a text of a thousand million letters.
-- Known as: mesecons#255
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local s = ('x'):rep(1000000000)
end

return L
