-- Connects to the canary socket.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local socket = require 'socket' socket.connect('127.0.0.1', @PORT@)
end

return L
