-- Declares a mass that is no number.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  world:body { name = 'x', mass = 0/0 }
end

return L
