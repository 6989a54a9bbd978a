-- Declares an infinite stiffness.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  world:spring { at = { 0, 0, 0 }, stiffness = math.huge }
end

return L
