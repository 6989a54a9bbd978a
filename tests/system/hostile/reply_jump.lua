-- Gives a force that jumps by a million newtons.
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  world:hand {}:force(function(tool) return tool.x > 0 and 1e6 or -1e6, 1e308, -1e308 end)
end

return L
