-- Gives a force that is no number.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  world:hand {}:force(function() return 0/0, 0, 0 end)
end

return L
