-- Gives ten thousand numbers for a force.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }
local many = {}
for i = 1, 10000 do many[i] = i end

function L:start(world)
  world:hand {}:force(function() return table.unpack(many) end)
end

return L
