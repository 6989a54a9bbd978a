-- Passes malformed patterns.
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  for _, p in ipairs { '%', '[', '[a', '[%', '%f', '%b', '%bx', '(', ')', '%1', '(()', '[]', '[^]', '%g(', '(%2)', '[a-', '[%a-z', '^*', '%f[', '%f[a' } do pcall(string.find, 'abc', p) pcall(string.gsub, 'abc', p, '%9') pcall(function() for x in string.gmatch('abc', p) do break end end) end
end

return L
