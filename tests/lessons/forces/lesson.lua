-- Every kind of declared force, and one that the lesson computes: a spring of 50 N/m to a point.
local L = lesson { id = "forces", title = "Forces", level = "A1", minutes = 1 }

function L:start(world)
  world:viscosity { name = "honey", damping = 1 }
  world:force(function(tool) return -50 * tool.x, -50 * (tool.y - 0.3), -50 * tool.z end)
end

return L
