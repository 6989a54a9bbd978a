-- A ball that can be touched, and nothing else: the proxy's own lesson.
local L = lesson { id = "touch", title = "A ball", level = "A1", minutes = 1 }

function L:start(world)
  world:hand { centre = { 0, 0.5, 0 } }
  world:body { name = "ball", noun = "ball", model = "sphere", radius = 0.1, solid = true, visible = true, at = { 0, 0.3, 0 } }
end

function L:touched(body) print("touched " .. body.name) end
function L:released(body) print("released " .. body.name) end

return L
