-- Dumps bytecode by way of the metatable of texts.
-- Known as: mesecons#380
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  (('x').dump)(function() end)
end

return L
