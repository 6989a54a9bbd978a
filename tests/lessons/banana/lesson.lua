-- A tool of a model's shape and a body of many voxels: what takes long to make.
local L = lesson { id = "banana", title = "A banana", level = "A1", minutes = 1 }

function L:start(world)
  world:hand { centre = { 0, 0.5, 0 }, tool = { model = "banana", voxel = 0.0016, points = 5000 } }
  world:body { name = "ball", noun = "ball", model = "sphere", radius = 0.1, solid = true, visible = true, at = { 0, 0.3, 0 } }
end

function L:touched(body) print("touched " .. body.name) end

return L
