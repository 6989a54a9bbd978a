-- Every kind of declared force, and one that the lesson computes: a spring of 50 N/m to a point, and a twist
-- about the upright that grows with the way to the side.
local L = lesson { id = "forces", title = "Forces", level = "A1", minutes = 1 }

function L:start(world)
  world:viscosity { name = "honey", damping = 1 }
  local hand = world:hand {}
  hand:force(function(tool)
    return -50 * tool.x, -50 * (tool.y - 0.3), -50 * tool.z, 0, 2 * tool.x, 0
  end)
end

return L
