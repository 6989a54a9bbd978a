-- Hangs in a listener.
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self:listen(function() while true do end end)
end

return L
