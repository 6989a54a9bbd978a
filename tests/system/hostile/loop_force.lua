-- Hangs in the force function.
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  world:hand {}:force(function(tool) while true do end end)
end

return L
