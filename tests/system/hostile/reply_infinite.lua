-- Gives an infinite force.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  world:hand {}:force(function() return math.huge, 0, 0 end)
end

return L
