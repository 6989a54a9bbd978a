-- Passes odd formats.
-- Known as: after CVE-2024-31449 (Redis bit.tohex)
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  for _, f in ipairs { '%', '%%', '%s', '%d', '%q', '%c', '%a', '%i', '%99.99f', '%0100d', '%#x', '%p', '%n', '%*d', '%s%s%s', '%10q' } do pcall(string.format, f, 1) pcall(string.format, f, 'x', {}) pcall(string.format, f) end
end

return L
