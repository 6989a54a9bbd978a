-- Concatenates numbers and long texts.
-- Known as: Lua 5.4.6: buffer in string concatenation
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  for n = 1, 200 do local s = ('x'):rep(n) .. 1 .. 2.5 .. ('y'):rep(n) end
end

return L
