-- Never ends in start.
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  while true do end
end

return L
