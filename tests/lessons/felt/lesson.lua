-- A material out of another and a picture, as docs/teach.md shows it.
local L = lesson { id = "felt", title = "A cushion", level = "A1", minutes = 1 }

function L:start(world)
  local felt = world:material {
    name = "felt", like = "wood", stiffness = 300, friction = 0.6,
    texture = { image = "felt.png", size = 0.016, height = 0.0004 },
  }
  world:hand { centre = { 0, 0.4, 0 }, rate = 2000 }
  world:body { name = "cushion", model = "box", radius = 0.05, solid = true, visible = true, material = felt, at = { 0, 0.3, 0 } }
  print(felt, felt.stiffness, felt.friction)
end

return L
