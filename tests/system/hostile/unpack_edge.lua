-- Unpacks at the edges of all integers.
-- Known as: CVE-2025-46817 (Redis)
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  for _, p in ipairs { { 1, 2147483647 }, { -2147483648, 2147483647 }, { 9223372036854775800, 9223372036854775807 }, { 0, 1e15 } } do pcall(table.unpack, {}, p[1], p[2]) end
end

return L
