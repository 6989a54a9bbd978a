-- Declares names that lead out of the folder.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  world:body { name = 'x', model = '../../etc/passwd' }
end

return L
