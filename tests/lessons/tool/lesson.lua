-- A stick that is pressed flat on a table, and turned there: force and torque of a tool.
local L = lesson { id = "tool", title = "A stick", level = "A1", minutes = 1 }

function L:start(world)
  world:hand { centre = { 0, 0.3, 0 }, tool = { shape = "box", radius = 0.02, length = 0.2, turn_stiffness = 0.5 } }
  world:body { name = "table", noun = "table", model = "box", radius = 0.1, solid = true, visible = true, at = { 0, 0.1, 0 } }
end

local told = false

function L:update(world)
  local tool = world:tool()
  if world.time > 6.5 and not told then
    told = true
    print(("turned %.0f, felt %.2f N and %.3f N m"):format(tool.turn.z, tool.force, tool.torque))
  end
end

function L:touched(body) print("touched " .. body.name) end

return L
