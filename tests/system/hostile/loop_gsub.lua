-- Hangs in a replacement.
-- Known as: mesecons#255
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  string.gsub('a', 'a', function() while true do end end)
end

return L
