-- Declares a thousand bodies.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  for i = 1, 1000 do world:body { name = 'b' .. i } end
end

return L
