-- Loads a C library through package.
-- Known as: CVE-2022-0543 (Redis on Debian)
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local open = package.loadlib('liblua5.4.so.0', 'luaopen_io') open()
end

return L
