-- Reads a file through io.lines.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  for line in io.lines('/etc/passwd') do print(line) end
end

return L
