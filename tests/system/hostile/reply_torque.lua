-- Gives torques beyond measure, jumping between signs, as six numbers and as three in turn.
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  world:hand {}:force(function(tool)
    if tool.y > 0.3 then return 0, 0, 0 end
    return 0, 0, 0, tool.x > 0 and 1e308 or -1e308, 1e6, -1e6
  end)
end

return L
