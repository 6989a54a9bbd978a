-- Lets require load a C library.
-- Known as: CVE-2022-0543 (Redis on Debian)
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  package.cpath = '/usr/lib/?.so' require 'evil'
end

return L
